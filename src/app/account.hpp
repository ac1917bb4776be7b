#pragma once
/// How the keywords of a deck were taken, as a table for people.

#include <string>

#include "model/model.hpp"

namespace cleave::app {

/// "honoured", "in part", ...
const char* word_for(model::Account::Policy policy);

/// One line per keyword: cards read, fields defaulted, fields not honoured. Empty for an empty account.
std::string table_of(const model::Account& account);

}  // namespace cleave::app
