#pragma once
/// Nothing read is silently ignored: fields that were given and are not used are named.

#include <functional>
#include <string_view>

#include "model/keyword/draft.hpp"

namespace cleave::model {

enum class FieldUse { honoured, harmless, ignored };

/// Looks at every given field of the card. A field that is not honoured is reported unless it holds 0 or its
/// documented default: as a warning if harmless, else refused. Reported names are added to the account's
/// entry.
void report_unused(Draft& draft, const Entry& entry, Account::Entry& account,
                   const std::function<FieldUse(std::string_view)>& use);

/// The account's entry of a keyword, made on first use.
Account::Entry& account_of(Account& account, std::string_view keyword);

}  // namespace cleave::model
