/// *DEFINE_CURVE, *DEFINE_TABLE, *DEFINE_TABLE_2D.

#include <algorithm>

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

/// The dimension of a curve is known only where it is used, so its file may not change units.
void refuse_units(Draft& draft, const Entry& entry) {
  if (changes_units(entry.transform()))
    draft.refuse(entry, "", "a curve inside a file with unit factors (FCTMAS, FCTTIM, FCTLEN)",
                 "move the curve to a file without factors, in the units of the model");
}

bool ascending(Draft& draft, const Entry& entry, const std::vector<double>& x, std::string_view field,
               bool jumps_allowed) {
  for (std::size_t i = 1; i < x.size(); ++i)
    if (x[i] < x[i - 1] || (x[i] == x[i - 1] && !jumps_allowed)) {
      draft.diagnostics.error(
          entry.place(field, i), entry.keyword(), std::string(field),
          "abscissae must ascend: " + std::to_string(x[i]) + " after " + std::to_string(x[i - 1]));
      return false;
    }
  return true;
}

/// x = SFA (A1 + OFFA), y = SFO (O1 + OFFO); a factor of 0 means 1.
void take_curve(Draft& draft, const Entry& entry) {
  Curve curve;
  curve.id = entry.id(IdKind::function, "LCID");
  curve.title = entry.title();
  curve.place = entry.place("LCID");
  if (curve.id <= 0) return draft.error(entry, "LCID", "a curve number must be 1 or more");
  if (!draft.claim(entry, "curve or table", curve.id, "LCID")) return;
  refuse_units(draft, entry);
  if (entry.integer("SIDR") == 1)
    draft.refuse(entry, "SIDR", "a curve for dynamic relaxation only", "set SIDR to 0 or remove the curve");

  const double factor_x = entry.real_or("SFA", pure, 1.0), factor_y = entry.real_or("SFO", pure, 1.0);
  const double shift_x = entry.real("OFFA", pure), shift_y = entry.real("OFFO", pure);
  const std::size_t count = entry.card().row_count("A1");
  if (count < 1) return draft.error(entry, "A1", "a curve needs at least one point");
  for (std::size_t i = 0; i < count; ++i) {
    curve.x.push_back(factor_x * (entry.card().real("A1", i) + shift_x));
    curve.y.push_back(factor_y * (entry.card().real("O1", i) + shift_y));
  }
  if (!ascending(draft, entry, curve.x, "A1", true)) return;
  draft.model.curves.push_back(std::move(curve));
}

/// The curves of a *DEFINE_TABLE follow it in the deck, one per value.
void take_table(Draft& draft, const Entry& entry) {
  Table table;
  table.id = entry.id(IdKind::function, "TBID");
  table.title = entry.title();
  if (!draft.claim(entry, "curve or table", table.id, "TBID")) return;
  refuse_units(draft, entry);
  const double factor = entry.real_or("SFA", pure, 1.0), shift = entry.real("OFFA", pure);
  const bool named = entry.keyword() == "DEFINE_TABLE_2D";
  std::vector<Id> curves;
  if (named) {
    for (std::size_t i = 0; i < entry.card().row_count("VALUE"); ++i) {
      table.value.push_back(factor * (entry.card().real("VALUE", i) + shift));
      curves.push_back(entry.id(IdKind::function, "LCID", i));
    }
  } else {
    for (const double v : entry.card().reals("POINTS")) table.value.push_back(factor * (v + shift));
    // The next curves in reading order, whatever their numbers.
    const deck::Place here = entry.place();
    std::size_t at = 0;
    const auto& blocks = draft.deck.blocks();
    while (at < blocks.size() && !(blocks[at].place.file == here.file && blocks[at].place.line == here.line))
      ++at;
    deck::Diagnostics said_already;  // these cards are read again in their own turn
    for (++at; at < blocks.size() && curves.size() < table.value.size(); ++at) {
      if (blocks[at].keyword != "DEFINE_CURVE") break;
      for (const auto& card : draft.deck.cards(blocks[at], said_already))
        curves.push_back(draft.entry_of(card, blocks[at].transform).id(IdKind::function, "LCID"));
    }
  }
  if (table.value.empty())
    return draft.error(entry, named ? "VALUE" : "POINTS", "a table needs at least one value");
  if (curves.size() < table.value.size())
    return draft.error(entry, "POINTS",
                       std::to_string(table.value.size()) + " values, but " + std::to_string(curves.size()) +
                           " *DEFINE_CURVE follow",
                       "put one *DEFINE_CURVE per value right after the table, or use *DEFINE_TABLE_2D");
  if (!ascending(draft, entry, table.value, named ? "VALUE" : "POINTS", false)) return;

  // Curves come later in the deck: their indices are looked up when all are known.
  const std::size_t slot = draft.model.tables.size();
  draft.model.tables.push_back(std::move(table));
  draft.after_phase.push_back([&draft, entry, slot, curves] {
    for (const Id id : curves) {
      const Index index = draft.model.curve_of(id);
      if (index < 0)
        draft.error(entry, "LCID", "curve " + std::to_string(id) + " of the table is not defined");
      draft.model.tables[slot].curve.push_back(index);
    }
  });
}

constexpr Handler handlers[] = {
    {.keyword = "DEFINE_CURVE",
     .phase = Phase::curve,
     .honoured = "LCID SIDR SFA SFO OFFA OFFO DATTYP A1 O1",
     .harmless = "LCINT",
     .take = take_curve,
     .remark = "curves are used as given, not resampled (LCINT)"},
    {.keyword = "DEFINE_TABLE",
     .phase = Phase::curve,
     .honoured = "TBID SFA OFFA POINTS",
     .take = take_table},
    {.keyword = "DEFINE_TABLE_2D",
     .phase = Phase::curve,
     .honoured = "TBID SFA OFFA VALUE LCID",
     .take = take_table},
};

}  // namespace
extern const Family curve_cards{handlers};

}  // namespace cleave::model
