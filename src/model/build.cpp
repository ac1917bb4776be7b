/// Cards to Model: read all blocks phase by phase, resolve, fill defaults, check.

#include <array>

#include "deck/layout.hpp"
#include "model/check.hpp"
#include "model/keyword/handler.hpp"
#include "model/keyword/honoured.hpp"
#include "model/keyword/law_of_part.hpp"
#include "model/model.hpp"
#include "model/write/references.hpp"

namespace cleave::model {

void finish_nodes(Draft& draft);
void finish_solids(Draft& draft);
void finish_shells(Draft& draft);
void finish_parts(Draft& draft);
void finish_velocities(Draft& draft);
void finish_sets(Draft& draft);
void finish_stresses(Draft& draft);
void finish_rigid(Draft& draft);

namespace {

void finish_elements(Draft& draft) {
  finish_solids(draft);
  finish_shells(draft);
}

/// A block without a handler: noted, refused, or unknown to the card table.
void take_unhandled(Draft& draft, const deck::Block& block) {
  Account::Entry& entry = account_of(*draft.account, block.keyword);
  ++entry.cards;
  if (!block.known) {
    entry.policy = Account::Policy::unknown;  // the reader has said so, with the nearest name
    return;
  }
  if (block.consumed) return;  // the reader has used it: *INCLUDE, *PARAMETER, *TITLE, ...
  const Unhandled rule = unhandled(block.keyword);
  entry.policy = rule.policy;
  entry.remark = rule.remark;
  if (entry.policy == Account::Policy::refused)
    draft.refuse(block.place, block.keyword, "", "not computed here", std::string(rule.remark));
  else if (entry.policy == Account::Policy::output_only)
    draft.diagnostics.note(block.place, block.keyword, "", "skipped", std::string(rule.remark));
}

void take_cards(Draft& draft, const deck::Block& block, const Handler& handler) {
  const std::size_t field_count = deck::fields_of(block.keyword).size();
  draft.first_of_block = true;
  for (deck::Card& card : draft.deck.cards(block, draft.diagnostics)) {
    const Entry entry = draft.entry_of(std::move(card), block.transform);
    handler.take(draft, entry);
    draft.first_of_block = false;

    Account::Entry& line = account_of(*draft.account, block.keyword);
    ++line.cards;
    const std::size_t given = entry.card().given_fields().size();
    line.defaulted += field_count > given ? field_count - given : 0;
    report_unused(draft, entry, line, [&](std::string_view name) {
      if (names(handler.honoured, name)) return FieldUse::honoured;
      return names(handler.harmless, name) ? FieldUse::harmless : FieldUse::ignored;
    });
  }
}

void take_block(Draft& draft, const deck::Block& block, const Handler& handler) {
  Account::Entry& line = account_of(*draft.account, block.keyword);
  line.remark = handler.remark;
  line.policy = handler.policy;
  if (handler.stream) {
    line.cards += handler.stream(draft, block);
  } else {
    take_cards(draft, block, handler);
  }
}

/// One *CONTROL_ card of a kind counts: the last one.
void warn_repeated_controls(Draft& draft) {
  std::map<std::string, const deck::Block*> seen;
  for (const deck::Block& block : draft.deck.blocks()) {
    if (!block.keyword.starts_with("CONTROL_")) continue;
    if (const auto [at, fresh] = seen.try_emplace(block.keyword, &block); !fresh)
      draft.diagnostics.warning(block.place, block.keyword, "",
                                "given before, on line " + std::to_string(at->second->place.line) +
                                    "; what stands here replaces it");
  }
}

/// A handler that drops a field makes its keyword "honoured in part".
void settle_policies(Account& account) {
  for (auto& entry : account.entries)
    if (entry.policy == Account::Policy::honoured && !entry.ignored_fields.empty())
      entry.policy = Account::Policy::in_part;
}

}  // namespace

Model build(const deck::Deck& deck, const BuildOptions& options, deck::Diagnostics& diagnostics,
            Account& account) {
  Model model;
  Draft draft(deck, options, diagnostics, model, account);
  model.title = deck.title();
  warn_repeated_controls(draft);

  // Which handler takes which block; blocks without one are settled here, in reading order.
  std::vector<const Handler*> handler_of;
  for (const deck::Block& block : deck.blocks()) {
    const Handler* handler = block.known && !block.consumed ? find_handler(block.keyword) : nullptr;
    handler_of.push_back(handler && (handler->take || handler->stream) ? handler : nullptr);
    account_of(account, block.keyword);
    if (!handler_of.back()) take_unhandled(draft, block);
  }

  // Later phases refer to earlier ones, never the other way, whatever the order in the deck.
  using Finish = void (*)(Draft&);
  constexpr std::pair<Phase, Finish> phases[] = {
      {Phase::transformation, nullptr},  {Phase::curve, nullptr},
      {Phase::definition, nullptr},      {Phase::node, finish_nodes},
      {Phase::frame, nullptr},           {Phase::vector, nullptr},
      {Phase::material, nullptr},        {Phase::part, nullptr},
      {Phase::element, finish_elements}, {Phase::set, nullptr},
      {Phase::action, nullptr},
  };
  for (const auto& [phase, finish] : phases) {
    for (std::size_t i = 0; i < handler_of.size(); ++i)
      if (handler_of[i] && handler_of[i]->phase == phase) take_block(draft, deck.blocks()[i], *handler_of[i]);
    if (phase == Phase::transformation) draft.transformations_read = true;
    for (const auto& act : draft.after_phase) act();
    draft.after_phase.clear();
    if (finish) finish(draft);
    if (phase == Phase::definition && options.end_time > 0.0) model.control.end.time = options.end_time;
  }

  finish_parts(draft);
  build_laws(draft);
  for (const auto& act : draft.when_laws_known) act();
  finish_rigid(draft);
  finish_velocities(draft);
  finish_sets(draft);
  finish_stresses(draft);
  name_node_lists(model);
  model.requests.title = model.title;
  settle_policies(account);
  if (!diagnostics.failed()) {
    check(model, deck, diagnostics);
    if (options.needs_end_time) check_end_time(model, deck, diagnostics);
  }
  return model;
}

}  // namespace cleave::model
