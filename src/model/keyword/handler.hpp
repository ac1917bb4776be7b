#pragma once
/// The table that says, for each keyword, who takes it, when, and which of its fields count.
///
/// One family of keywords is one file in this folder with one `const Family`, and one line in families.inc.

#include <span>
#include <string_view>

#include "model/keyword/draft.hpp"

namespace cleave::model {

/// Keywords are taken phase by phase, so that references may point forward in the deck.
enum class Phase {
  transformation,
  curve,
  definition,
  node,
  frame,
  vector,
  material,
  part,
  element,
  set,
  action
};

struct Handler {
  std::string_view keyword;  ///< canonical; a trailing * takes every keyword that begins so
  Phase phase = Phase::action;
  std::string_view honoured;       ///< field names, blank between; "*" for all
  std::string_view harmless = {};  ///< fields without influence on what is computed here: warned, not refused
  void (*take)(Draft&, const Entry&) = nullptr;                 ///< one data set
  std::size_t (*stream)(Draft&, const deck::Block&) = nullptr;  ///< or a whole block of rows
  std::string_view remark = {};
  Account::Policy policy = Account::Policy::honoured;  ///< other than honoured: read, but not computed with
};

using Family = std::span<const Handler>;

/// Every family of families.inc.
std::span<const Family* const> families();
/// The handler of a canonical keyword; an exact name goes before a pattern. Null when there is none.
const Handler* find_handler(std::string_view keyword);

/// What to say of a known keyword that no handler takes.
struct Unhandled {
  Account::Policy policy = Account::Policy::refused;
  std::string_view remark;
};
Unhandled unhandled(std::string_view keyword);

/// Does a blank-separated list hold the name, or "*"?
bool names(std::string_view list, std::string_view name);

}  // namespace cleave::model
