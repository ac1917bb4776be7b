#include "model/keyword/selection.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "model/outer_faces.hpp"

namespace cleave::model {
namespace {

/// One row of a _GENERAL set: a word and up to seven numbers.
struct Row {
  std::string word;
  bool removes = false;
  std::vector<std::pair<Id, std::string>> arguments;  ///< written number, field it stands in
};

std::vector<Row> rows_of(const Entry& entry) {
  std::vector<Row> rows;
  for (std::size_t i = 0; i < entry.card().row_count("OPTION"); ++i) {
    Row row;
    for (const char c : entry.card().text("OPTION", i)) row.word += static_cast<char>(std::toupper(c));
    static constexpr std::string_view removing[] = {
        "DNODE", "DELEM", "DPART", "DBOX", "DSEG", "DSET_SOLID", "DSET_SHELL", "DSET_BEAM", "DSET_NODE"};
    row.removes = std::find(std::begin(removing), std::end(removing), row.word) != std::end(removing);
    if (row.removes) row.word.erase(0, 1);
    for (int k = 1; k <= 7; ++k) {
      const std::string field = "E" + std::to_string(k);
      if (const Id id = entry.integer(field, i)) row.arguments.emplace_back(id, field);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

template <class Member, class Less = std::less<>>
void apply(std::vector<Member>& members, std::vector<Member> change, bool removes, Less less = {}) {
  std::sort(change.begin(), change.end(), less);
  if (removes) {
    std::erase_if(members,
                  [&](const Member& m) { return std::binary_search(change.begin(), change.end(), m, less); });
    return;
  }
  members.insert(members.end(), change.begin(), change.end());
  std::sort(members.begin(), members.end(), less);
  const auto same = [&](const Member& a, const Member& b) { return !less(a, b) && !less(b, a); };
  members.erase(std::unique(members.begin(), members.end(), same), members.end());
}

void unknown(Draft& draft, const Entry& entry, const Row& row, std::string_view known) {
  draft.refuse(entry, "OPTION", "the selection " + row.word + " is not known here",
               "use " + std::string(known));
}

const Box* box_of(Draft& draft, const Entry& entry, Id written, std::string_view field) {
  const auto at = draft.boxes.find(entry.offset(IdKind::definition, written));
  if (at != draft.boxes.end()) return &at->second;
  draft.error(entry, field, "box " + std::to_string(written) + " is not defined", "add a *DEFINE_BOX");
  return nullptr;
}

std::vector<Index> parts_of(Draft& draft, const Entry& entry, const Row& row) {
  std::vector<Index> parts;
  for (const auto& [written, field] : row.arguments) {
    const Id id = entry.offset(IdKind::part, written);
    if (const Index part = draft.model.part_of(id); part >= 0)
      parts.push_back(part);
    else
      draft.error(entry, field, "part " + std::to_string(id) + " is not defined");
  }
  return parts;
}

/// Element numbers of a row of ELEM, or of SET_SOLID, SET_SHELL, SET_BEAM.
std::vector<Id> elements_of(Draft& draft, const Entry& entry, const Row& row, ElementKind kind) {
  std::vector<Id> elements;
  for (const auto& [written, field] : row.arguments) {
    if (row.word == "ELEM") {
      const Id id = entry.offset(IdKind::element, written);
      if (draft.element(id, kind))
        elements.push_back(id);
      else
        draft.error(entry, field, "element " + std::to_string(id) + " is not defined");
    } else {
      const Id id = entry.offset(IdKind::set, written);
      if (const auto* set = draft.element_sets(kind).find(draft, id))
        elements.insert(elements.end(), set->begin(), set->end());
      else
        draft.error(entry, field,
                    std::string(name_of(kind)) + " set " + std::to_string(id) + " is not defined");
    }
  }
  return elements;
}

std::span<const Index> nodes_of_element(const Draft& draft, ElementKind kind, Draft::ElementPlace at) {
  const Elements& group = draft.model.mesh.elements(kind)[at.group];
  const std::size_t n = static_cast<std::size_t>(nodes_of(group.shape));
  return {group.node.data() + at.index * n, n};
}

template <class Body>
void for_each_element(const Draft& draft, ElementKind kind, const Body& body) {
  const std::vector<Elements>& groups = draft.model.mesh.elements(kind);
  for (std::uint32_t g = 0; g < groups.size(); ++g)
    for (std::uint32_t e = 0; e < groups[g].count(); ++e) body(Draft::ElementPlace{g, e});
}

/// SET_SOLID, SET_SHELL or SET_BEAM: the kind it is of.
std::optional<ElementKind> set_kind(const Row& row) {
  for (const ElementKind kind : {ElementKind::solid, ElementKind::shell, ElementKind::beam}) {
    std::string word = "SET_";
    for (const char c : name_of(kind)) word += static_cast<char>(std::toupper(c));
    if (row.word == word) return kind;
  }
  return std::nullopt;
}

/// Segments are the same when they have the same corners.
std::array<Index, 4> corners(const Segment& s) {
  std::array<Index, 4> c{s.node[0], s.node[1], s.node[2], s.node[3]};
  std::sort(c.begin(), c.end());
  return c;
}
bool before(const Segment& a, const Segment& b) {
  return corners(a) < corners(b);
}

}  // namespace

std::vector<Index> select_nodes(Draft& draft, const Entry& entry) {
  std::vector<Index> members;
  for (const Row& row : rows_of(entry)) {
    std::vector<Index> change;
    if (row.word == "ALL") {
      change = draft.all_nodes();
    } else if (row.word == "NODE") {
      for (const auto& [written, field] : row.arguments) {
        const Id id = entry.offset(IdKind::node, written);
        if (const Index node = draft.model.mesh.nodes.find(id); node >= 0)
          change.push_back(node);
        else
          draft.error(entry, field, "node " + std::to_string(id) + " is not defined");
      }
    } else if (row.word == "PART") {
      change = draft.nodes_of_parts(parts_of(draft, entry, row));
    } else if (row.word == "BOX") {
      for (const auto& [written, field] : row.arguments)
        if (const Box* box = box_of(draft, entry, written, field))
          for (const Index i : draft.all_nodes())
            if (box->contains(draft.position(i))) change.push_back(i);
    } else if (const auto kind = row.word == "ELEM" ? ElementKind::solid : set_kind(row)) {
      for (const Id id : elements_of(draft, entry, row, *kind)) {
        const auto nodes = nodes_of_element(draft, *kind, *draft.element(id, *kind));
        change.insert(change.end(), nodes.begin(), nodes.end());
      }
    } else if (row.word == "SET_NODE") {
      for (const auto& [written, field] : row.arguments) {
        const Id id = entry.offset(IdKind::set, written);
        if (const auto* set = draft.node_sets.find(draft, id))
          change.insert(change.end(), set->begin(), set->end());
        else
          draft.error(entry, field,
                      "node set " + std::to_string(id) + " is not defined, or contains this one");
      }
    } else {
      unknown(draft, entry, row,
              "ALL, NODE, PART, BOX, ELEM, SET_SOLID, SET_SHELL, SET_BEAM, SET_NODE, or one of them with D "
              "to take away");
    }
    apply(members, std::move(change), row.removes);
  }
  return members;
}

std::vector<Id> select_elements(Draft& draft, const Entry& entry, ElementKind kind) {
  const std::vector<Elements>& groups = draft.model.mesh.elements(kind);
  std::vector<Id> members;
  const auto id_at = [&](Draft::ElementPlace at) { return groups[at.group].id[at.index]; };
  for (const Row& row : rows_of(entry)) {
    std::vector<Id> change;
    if (row.word == "ALL") {
      for_each_element(draft, kind, [&](auto at) { change.push_back(id_at(at)); });
    } else if (row.word == "ELEM" || set_kind(row) == kind) {
      change = elements_of(draft, entry, row, kind);
    } else if (row.word == "PART") {
      const auto parts = parts_of(draft, entry, row);
      for_each_element(draft, kind, [&](auto at) {
        const Index part = groups[at.group].part[at.index];
        if (std::find(parts.begin(), parts.end(), part) != parts.end()) change.push_back(id_at(at));
      });
    } else if (row.word == "BOX") {
      for (const auto& [written, field] : row.arguments)
        if (const Box* box = box_of(draft, entry, written, field))
          for_each_element(draft, kind, [&](auto at) {
            const auto nodes = nodes_of_element(draft, kind, at);
            if (std::all_of(nodes.begin(), nodes.end(),
                            [&](Index i) { return box->contains(draft.position(i)); }))
              change.push_back(id_at(at));
          });
    } else {
      unknown(draft, entry, row,
              "ALL, ELEM, PART, BOX, sets of the same kind, or one of them with D to take away");
    }
    apply(members, std::move(change), row.removes);
  }
  return members;
}

std::vector<Segment> select_segments(Draft& draft, const Entry& entry) {
  std::vector<Segment> members;
  for (const Row& row : rows_of(entry)) {
    std::vector<Segment> change;
    if (row.word == "ALL") {
      change = boundary_segments(draft.model.mesh, {});
    } else if (row.word == "PART") {
      if (const auto parts = parts_of(draft, entry, row); !parts.empty())
        change = boundary_segments(draft.model.mesh, parts);
    } else if (row.word == "BOX") {
      for (const auto& [written, field] : row.arguments)
        if (const Box* box = box_of(draft, entry, written, field))
          for (const Segment& s : boundary_segments(draft.model.mesh, {}))
            if (std::all_of(s.node, s.node + 4, [&](Index i) { return box->contains(draft.position(i)); }))
              change.push_back(s);
    } else if (row.word == "SEG" && row.arguments.size() >= 3) {
      Segment segment;
      bool whole = true;
      for (std::size_t k = 0; k < 4; ++k) {
        const Id id = entry.offset(IdKind::node, row.arguments[std::min(k, row.arguments.size() - 1)].first);
        segment.node[k] = draft.model.mesh.nodes.find(id);
        if (segment.node[k] < 0) {
          draft.error(entry, "OPTION",
                      "the segment names node " + std::to_string(id) + ", which is not defined");
          whole = false;
        }
      }
      if (whole) change.push_back(segment);
    } else {
      unknown(draft, entry, row, "ALL, PART, BOX, SEG, or one of them with D to take away");
    }
    apply(members, std::move(change), row.removes, before);
  }
  return members;
}

bool read_segment(Draft& draft, const Entry& entry, std::size_t row, Segment& out) {
  static constexpr std::string_view fields[] = {"N1", "N2", "N3", "N4"};
  // Blank nodes repeat the one before: N4 of a triangle, N3 of an edge in the plane, N2 of the end of a bar.
  const int needed = !draft.model.mesh.beams.empty() ? 1 : !draft.model.mesh.shells.empty() ? 2 : 3;
  for (int k = 0; k < 4; ++k) {
    if (k >= needed && entry.integer(fields[k], row) == 0) {
      out.node[k] = out.node[k - 1];
      continue;
    }
    out.node[k] = draft.node(entry, fields[k], row);
    if (out.node[k] < 0) return false;
  }
  return true;
}

std::vector<Segment> list_segments(Draft& draft, const Entry& entry) {
  std::vector<Segment> members;
  for (std::size_t row = 0; row < entry.card().row_count("N1"); ++row) {
    Segment segment;
    if (entry.integer("N1", row) == 0) continue;
    if (read_segment(draft, entry, row, segment)) members.push_back(segment);
  }
  return members;
}

std::vector<Segment> add_segments(Draft& draft, const Entry& entry) {
  std::vector<Segment> members;
  for (const Id written : entry.card().integers("SETS")) {
    if (written == 0) continue;
    const Id id = entry.offset(IdKind::set, written);
    if (const auto* set = draft.segment_sets.find(draft, id))
      apply(members, *set, false, before);
    else
      draft.error(entry, "SETS",
                  "segment set " + std::to_string(id) + " is not defined, or contains this one");
  }
  return members;
}

}  // namespace cleave::model
