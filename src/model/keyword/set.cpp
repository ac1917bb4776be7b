/// *SET_NODE, *SET_PART, *SET_SOLID, *SET_SHELL, *SET_BEAM: lists, ranges, columns, sums and intersections of
/// sets, general selections.

#include <algorithm>

#include "model/keyword/handler.hpp"
#include "model/keyword/selection.hpp"

namespace cleave::model {
namespace {

template <class Member>
void sort_unique(std::vector<Member>& members) {
  std::sort(members.begin(), members.end());
  members.erase(std::unique(members.begin(), members.end()), members.end());
}

/// All ids of a series with their row; zeros are padding.
std::vector<std::pair<Id, std::size_t>> written_ids(const Entry& entry, std::string_view series) {
  std::vector<std::pair<Id, std::size_t>> ids;
  std::size_t row = 0;
  for (const Id id : entry.card().integers(series)) {
    if (id != 0) ids.emplace_back(id, row);
    ++row;
  }
  return ids;
}

// --- what the kinds of set have in common, told apart by a description -------------------------------------

struct NodeKind {
  using Member = Index;
  static constexpr IdKind ids = IdKind::node;
  static constexpr std::string_view name = "node", series = "NODES", column = "NID";
  static SetBook<Index>& book(Draft& d) { return d.node_sets; }
  static bool find(Draft& d, Id id, Member& out) { return (out = d.model.mesh.nodes.find(id)) >= 0; }
  static void range(Draft& d, Id from, Id to, std::vector<Member>& out) {
    const auto& all = d.model.mesh.nodes.id;
    const auto first = std::lower_bound(all.begin(), all.end(), from);
    const auto last = std::upper_bound(all.begin(), all.end(), to);
    for (auto i = first; i < last; ++i) out.push_back(static_cast<Index>(i - all.begin()));
  }
};

struct PartKind {
  using Member = Index;
  static constexpr IdKind ids = IdKind::part;
  static constexpr std::string_view name = "part", series = "PARTS", column = "PID";
  static SetBook<Index>& book(Draft& d) { return d.part_sets; }
  static bool find(Draft& d, Id id, Member& out) { return (out = d.model.part_of(id)) >= 0; }
  static void range(Draft& d, Id from, Id to, std::vector<Member>& out) {
    for (std::size_t p = 0; p < d.model.parts.size(); ++p)
      if (d.model.parts[p].id >= from && d.model.parts[p].id <= to) out.push_back(static_cast<Index>(p));
  }
};

template <ElementKind which>
struct ElementsOf {
  using Member = Id;
  static constexpr ElementKind kind = which;
  static constexpr IdKind ids = IdKind::element;
  static constexpr std::string_view name = kind == ElementKind::solid ? "element" : name_of(kind);
  static constexpr std::string_view series = kind == ElementKind::solid   ? "SOLIDS"
                                             : kind == ElementKind::shell ? "SHELLS"
                                                                          : "BEAMS";
  static SetBook<Id>& book(Draft& d) { return d.element_sets(kind); }
  static bool find(Draft& d, Id id, Member& out) { return out = id, d.element(id, kind).has_value(); }
  static void range(Draft& d, Id from, Id to, std::vector<Member>& out) {
    for (const auto& group : d.model.mesh.elements(kind))
      for (const Id id : group.id)
        if (id >= from && id <= to) out.push_back(id);
  }
};
using SolidKind = ElementsOf<ElementKind::solid>;
using ShellKind = ElementsOf<ElementKind::shell>;
using BeamKind = ElementsOf<ElementKind::beam>;

template <ElementKind kind>
std::vector<Id> select(Draft& draft, const Entry& entry) {
  return select_elements(draft, entry, kind);
}

/// Elements of a kind of which nothing is computed are not read: sets of them are named once, not each of
/// their members.
template <class Kind>
bool refused_as_a_whole(Draft& draft, const Entry& entry) {
  if constexpr (requires { Kind::kind; }) {
    if (!draft.model.mesh.elements(Kind::kind).empty()) return false;
    draft.refuse(entry, "SID", "there are no " + std::string(name_of(Kind::kind)) + "s that are computed",
                 "leave the set out");
    return true;
  }
  return false;
}

template <class Kind>
std::vector<typename Kind::Member> list(Draft& draft, const Entry& entry) {
  std::vector<typename Kind::Member> members;
  if (refused_as_a_whole<Kind>(draft, entry)) return members;
  Capped missing;
  for (const auto& [written, row] : written_ids(entry, Kind::series)) {
    const Id id = entry.offset(Kind::ids, written);
    typename Kind::Member member;
    if (Kind::find(draft, id, member))
      members.push_back(member);
    else if (missing.take())
      draft.error(
          entry, "SID",
          "the set names " + std::string(Kind::name) + " " + std::to_string(id) + ", which is not defined");
  }
  if (const auto rest = missing.rest(); !rest.empty())
    draft.error(entry, "SID", rest + " members that are not defined");
  sort_unique(members);
  return members;
}

template <class Kind>
std::vector<typename Kind::Member> column(Draft& draft, const Entry& entry) {
  std::vector<typename Kind::Member> members;
  for (std::size_t row = 0; row < entry.card().row_count(Kind::column); ++row) {
    const Id id = entry.id(Kind::ids, Kind::column, row);
    typename Kind::Member member;
    if (id == 0) continue;
    if (Kind::find(draft, id, member))
      members.push_back(member);
    else
      draft.error(
          entry, Kind::column,
          "the set names " + std::string(Kind::name) + " " + std::to_string(id) + ", which is not defined");
  }
  sort_unique(members);
  return members;
}

/// Everything that is defined with a number in the ranges B1BEG..B1END, ...
template <class Kind>
std::vector<typename Kind::Member> generate(Draft& draft, const Entry& entry) {
  std::vector<typename Kind::Member> members;
  for (std::size_t row = 0; row < entry.card().row_count("B1BEG"); ++row)
    for (int k = 1; k <= 4; ++k) {
      const std::string begin = "B" + std::to_string(k) + "BEG", end = "B" + std::to_string(k) + "END";
      const Id from = entry.id(Kind::ids, begin, row), to = entry.id(Kind::ids, end, row);
      if (from == 0 && to == 0) continue;
      if (to < from) {
        draft.error(
            entry, end,
            "the range ends at " + std::to_string(to) + ", before it begins at " + std::to_string(from));
        continue;
      }
      const std::size_t before = members.size();
      Kind::range(draft, from, to, members);
      if (members.size() == before)
        draft.warning(entry, begin,
                      "no " + std::string(Kind::name) + " has a number from " + std::to_string(from) +
                          " to " + std::to_string(to));
    }
  sort_unique(members);
  return members;
}

template <class Kind>
std::vector<std::vector<typename Kind::Member>> named_sets(Draft& draft, const Entry& entry) {
  std::vector<std::vector<typename Kind::Member>> sets;
  const std::string_view series = entry.has("SETS") ? "SETS" : Kind::series;
  for (const auto& [written, row] : written_ids(entry, series)) {
    const Id id = entry.offset(IdKind::set, written);
    bool circular = false;
    if (const auto* members = Kind::book(draft).find(draft, id, &circular))
      sets.push_back(*members);
    else
      draft.error(entry, "",
                  std::string(Kind::name) + " set " + std::to_string(id) +
                      (circular ? " contains itself" : " is not defined"));
  }
  return sets;
}

template <class Kind>
std::vector<typename Kind::Member> sum(Draft& draft, const Entry& entry) {
  std::vector<typename Kind::Member> members;
  for (const auto& set : named_sets<Kind>(draft, entry))
    members.insert(members.end(), set.begin(), set.end());
  sort_unique(members);
  return members;
}

template <class Kind>
std::vector<typename Kind::Member> intersection(Draft& draft, const Entry& entry) {
  const auto sets = named_sets<Kind>(draft, entry);
  if (sets.empty()) return {};
  auto members = sets[0];
  for (std::size_t i = 1; i < sets.size(); ++i)
    std::erase_if(members, [&](auto m) { return !std::binary_search(sets[i].begin(), sets[i].end(), m); });
  return members;
}

/// Files the card under its number; members are found when somebody asks, or at the end.
template <class Kind, auto evaluate>
void keep(Draft& draft, const Entry& entry) {
  const std::string_view field = entry.has("SID") ? "SID" : "NSID";
  const Id id = entry.id(IdKind::set, field);
  if (id <= 0) return draft.error(entry, field, "a set number must be 1 or more");
  if (draft.claim(entry, std::string(Kind::name) + " set", id, field))
    Kind::book(draft).add(id, entry, evaluate);
}

struct SegmentKind {
  static constexpr std::string_view name = "segment";
  static SetBook<Segment>& book(Draft& d) { return d.segment_sets; }
};

constexpr std::string_view ids = "TITLE SID NSID SOLVER ITS NODES PARTS SOLIDS SHELLS BEAMS SETS";
constexpr std::string_view ranges = "TITLE SID SOLVER ITS B1BEG B1END B2BEG B2END B3BEG B3END B4BEG B4END";
constexpr std::string_view selection = "TITLE SID SOLVER ITS OPTION E1 E2 E3 E4 E5 E6 E7";
constexpr std::string_view attributes = "DA1 DA2 DA3 DA4 A1 A2 A3 A4";

constexpr Handler handlers[] = {
    {"SET_NODE", Phase::set, ids, attributes, keep<NodeKind, list<NodeKind>>},
    {"SET_NODE_LIST", Phase::set, ids, attributes, keep<NodeKind, list<NodeKind>>},
    {"SET_NODE_COLUMN", Phase::set, "TITLE SID SOLVER ITS NID", attributes, keep<NodeKind, column<NodeKind>>},
    {"SET_NODE_LIST_GENERATE", Phase::set, ranges, attributes, keep<NodeKind, generate<NodeKind>>},
    {"SET_NODE_ADD", Phase::set, ids, attributes, keep<NodeKind, sum<NodeKind>>},
    {"SET_NODE_INTERSECT", Phase::set, ids, attributes, keep<NodeKind, intersection<NodeKind>>},
    {"SET_NODE_GENERAL", Phase::set, selection, attributes, keep<NodeKind, select_nodes>},
    {"SET_PART", Phase::set, ids, attributes, keep<PartKind, list<PartKind>>},
    {"SET_PART_LIST", Phase::set, ids, attributes, keep<PartKind, list<PartKind>>},
    {"SET_PART_COLUMN", Phase::set, "TITLE SID SOLVER PID", attributes, keep<PartKind, column<PartKind>>},
    {"SET_PART_LIST_GENERATE", Phase::set, ranges, attributes, keep<PartKind, generate<PartKind>>},
    {"SET_PART_ADD", Phase::set, ids, attributes, keep<PartKind, sum<PartKind>>},
    {"SET_SOLID", Phase::set, ids, {}, keep<SolidKind, list<SolidKind>>},
    {"SET_SOLID_GENERATE", Phase::set, ranges, {}, keep<SolidKind, generate<SolidKind>>},
    {"SET_SOLID_GENERAL", Phase::set, selection, {}, keep<SolidKind, select<ElementKind::solid>>},
    {"SET_SOLID_ADD", Phase::set, ids, {}, keep<SolidKind, sum<SolidKind>>},
    {"SET_SHELL", Phase::set, ids, attributes, keep<ShellKind, list<ShellKind>>},
    {"SET_SHELL_LIST", Phase::set, ids, attributes, keep<ShellKind, list<ShellKind>>},
    {"SET_SHELL_LIST_GENERATE", Phase::set, ranges, attributes, keep<ShellKind, generate<ShellKind>>},
    {"SET_SHELL_GENERAL", Phase::set, selection, attributes, keep<ShellKind, select<ElementKind::shell>>},
    {"SET_SHELL_ADD", Phase::set, ids, {}, keep<ShellKind, sum<ShellKind>>},
    {"SET_BEAM", Phase::set, ids, {}, keep<BeamKind, list<BeamKind>>},
    {"SET_BEAM_GENERATE", Phase::set, ranges, attributes, keep<BeamKind, generate<BeamKind>>},
    {"SET_BEAM_GENERAL", Phase::set, selection, attributes, keep<BeamKind, select<ElementKind::beam>>},
    {"SET_BEAM_ADD", Phase::set, ids, {}, keep<BeamKind, sum<BeamKind>>},
    {"SET_SEGMENT", Phase::set, "TITLE SID SOLVER ITS N1 N2 N3 N4", attributes,
     keep<SegmentKind, list_segments>},
    {"SET_SEGMENT_ADD", Phase::set, ids, {}, keep<SegmentKind, add_segments>},
    {"SET_SEGMENT_GENERAL", Phase::set, selection, attributes, keep<SegmentKind, select_segments>},
};

}  // namespace

/// Evaluates what nobody has asked for and hands the sets to the model.
void finish_sets(Draft& draft) {
  draft.model.node_sets = draft.node_sets.take(draft);
  draft.model.part_sets = draft.part_sets.take(draft);
  draft.model.solid_sets = draft.solid_sets.take(draft);
  draft.model.shell_sets = draft.shell_sets.take(draft);
  draft.model.beam_sets = draft.beam_sets.take(draft);
  draft.model.segment_sets = draft.segment_sets.take(draft);
}

extern const Family set_cards{handlers};

}  // namespace cleave::model
