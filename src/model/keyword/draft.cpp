#include "model/keyword/draft.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"

namespace cleave::model {

unsigned direction_bits(std::int64_t code) {
  static constexpr unsigned bits[] = {0, 1, 2, 4, 3, 6, 5, 7};
  return code >= 0 && code <= 7 ? bits[code] : 0;
}

bool Box::contains(const Vector& point) const {
  const Vector r = point - frame.origin;
  const Vector local = {dot(r, frame.axis[0]), dot(r, frame.axis[1]), dot(r, frame.axis[2])};
  return local.x >= low.x && local.x <= high.x && local.y >= low.y && local.y <= high.y && local.z >= low.z &&
         local.z <= high.z;
}

Draft::Draft(const deck::Deck& d, const BuildOptions& o, deck::Diagnostics& say, Model& m, Account& a)
    : deck(d), options(o), diagnostics(say), model(m), account(&a) {}

// --- messages ----------------------------------------------------------------------------------------

/// Has the reader already said that this field makes no sense? Then what follows from it is not said again.
static bool said_before(const Entry& entry, std::string_view field) {
  return !field.empty() && entry.has(field) && entry.card().unreadable(field);
}

void Draft::error(const Entry& entry, std::string_view field, std::string message, std::string hint) {
  if (said_before(entry, field)) return;
  const auto place = field.empty() ? entry.place() : entry.place(field);
  diagnostics.error(place, entry.keyword(), std::string(field), std::move(message), std::move(hint));
}

void Draft::warning(const Entry& entry, std::string_view field, std::string message, std::string hint) {
  if (said_before(entry, field)) return;
  const auto place = field.empty() ? entry.place() : entry.place(field);
  diagnostics.warning(place, entry.keyword(), std::string(field), std::move(message), std::move(hint));
}

void Draft::refuse(deck::Place place, std::string keyword, std::string field, std::string message,
                   std::string hint) {
  if (options.allow_unsupported)
    diagnostics.warning(place, std::move(keyword), std::move(field), std::move(message), std::move(hint));
  else
    diagnostics.error(place, std::move(keyword), std::move(field), std::move(message), std::move(hint));
}

void Draft::refuse(const Entry& entry, std::string_view field, std::string message, std::string hint) {
  if (said_before(entry, field)) return;
  const auto place = field.empty() ? entry.place() : entry.place(field);
  refuse(place, entry.keyword(), std::string(field), std::move(message), std::move(hint));
}

bool Draft::claim(const Entry& entry, std::string_view space, Id id, std::string_view field) {
  const auto [at, fresh] = claimed_.try_emplace({std::string(space), id}, entry.place());
  if (fresh) return true;
  const deck::Place before = at->second;
  const auto path = before.file >= 0 ? deck.sources().file(before.file).path.string() : std::string();
  error(entry, field,
        std::string(space) + " " + std::to_string(id) + " was defined before, at " + path + ":" +
            std::to_string(before.line),
        "give each " + std::string(space) + " its own number");
  return false;
}

void Draft::refuse_turned(const Entry& entry, std::string_view what) {
  if (entry.motion().turns())
    refuse(entry, "", std::string(what) + " inside a file that *DEFINE_TRANSFORMATION turns or scales",
           "move this keyword out of the transformed include file");
}

// --- references --------------------------------------------------------------------------------------

Index Draft::node(const Entry& entry, std::string_view field, std::size_t row) {
  const Id id = entry.id(IdKind::node, field, row);
  const Index index = model.mesh.nodes.find(id);
  if (index < 0)
    diagnostics.error(entry.place(field, row), entry.keyword(), std::string(field),
                      "node " + std::to_string(id) + " is not defined",
                      "add it to *NODE or correct the number");
  return index;
}

Index Draft::part(const Entry& entry, std::string_view field, std::size_t row) {
  const Id id = entry.id(IdKind::part, field, row);
  const Index index = model.part_of(id);
  if (index < 0)
    diagnostics.error(entry.place(field, row), entry.keyword(), std::string(field),
                      "part " + std::to_string(id) + " is not defined", "add a *PART or correct the number");
  return index;
}

Index Draft::curve(const Entry& entry, std::string_view field, bool required) {
  const Id id = entry.id(IdKind::function, field);
  if (id == 0) {
    if (required) error(entry, field, "a curve is needed here", "name a *DEFINE_CURVE");
    return -1;
  }
  const Index index = model.curve_of(id);
  if (index < 0)
    error(entry, field, "curve " + std::to_string(id) + " is not defined",
          "add a *DEFINE_CURVE or correct the number");
  return index;
}

namespace {

template <class Member>
const std::vector<Member>* find_set(Draft& draft, SetBook<Member>& book, const Entry& entry,
                                    std::string_view field, std::string_view kind) {
  const Id id = entry.id(IdKind::set, field);
  bool circular = false;
  const auto* members = book.find(draft, id, &circular);
  if (!members)
    draft.error(
        entry, field,
        std::string(kind) + " set " + std::to_string(id) +
            (circular ? " contains itself" : " is not defined"),
        circular ? "" : "sets of nodes, parts, segments and each kind of element are numbered separately");
  return members;
}

}  // namespace

const std::vector<Index>* Draft::node_set(const Entry& entry, std::string_view field) {
  return find_set(*this, node_sets, entry, field, "node");
}
const std::vector<Index>* Draft::part_set(const Entry& entry, std::string_view field) {
  return find_set(*this, part_sets, entry, field, "part");
}
const std::vector<Id>* Draft::element_set(const Entry& entry, std::string_view field, ElementKind kind) {
  return find_set(*this, element_sets(kind), entry, field, name_of(kind));
}
const std::vector<Segment>* Draft::segment_set(const Entry& entry, std::string_view field) {
  return find_set(*this, segment_sets, entry, field, "segment");
}

const Frame* Draft::frame(const Entry& entry, std::string_view field) {
  static const Frame global;
  const Id id = entry.id(IdKind::definition, field);
  if (id == 0) return &global;
  const auto at = frames.find(id);
  if (at != frames.end()) return &at->second;
  error(entry, field, "coordinate system " + std::to_string(id) + " is not defined",
        "add a *DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR");
  return nullptr;
}

const Box* Draft::box(const Entry& entry, std::string_view field) {
  const Id id = entry.id(IdKind::definition, field);
  const auto at = boxes.find(id);
  if (at != boxes.end()) return &at->second;
  error(entry, field, "box " + std::to_string(id) + " is not defined", "add a *DEFINE_BOX");
  return nullptr;
}

// --- geometry ----------------------------------------------------------------------------------------

Vector Draft::position(Index node) const {
  const double* p = model.mesh.nodes.position.data() + 3 * static_cast<std::size_t>(node);
  return {p[0], p[1], p[2]};
}

std::vector<Index> Draft::all_nodes() const {
  std::vector<Index> all(model.mesh.nodes.count());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
  return all;
}

std::vector<Index> Draft::nodes_of_parts(const std::vector<Index>& parts) const {
  std::vector<char> wanted(model.parts.size(), 0), hit(model.mesh.nodes.count(), 0);
  for (const Index p : parts) wanted[p] = 1;
  for (const auto* groups : {&model.mesh.solids, &model.mesh.shells, &model.mesh.beams})
    for (const Elements& group : *groups) {
      const int n = nodes_of(group.shape);
      for (std::size_t e = 0; e < group.count(); ++e)
        if (group.part[e] >= 0 && wanted[group.part[e]])
          for (int a = 0; a < n; ++a) hit[group.node[e * n + a]] = 1;
    }
  std::vector<Index> nodes;
  for (std::size_t i = 0; i < hit.size(); ++i)
    if (hit[i]) nodes.push_back(static_cast<Index>(i));
  return nodes;
}

std::optional<std::vector<Index>> Draft::selected_nodes(const Entry& entry) {
  std::vector<Index> nodes;
  if (entry.integer("NSID") == 0) {
    nodes = all_nodes();
  } else {
    const auto* set = node_set(entry, "NSID");
    if (!set) return std::nullopt;
    nodes = *set;
  }
  if (entry.has("BOXID") && entry.integer("BOXID") != 0) {
    const Box* limits = box(entry, "BOXID");
    if (!limits) return std::nullopt;
    std::erase_if(nodes, [&](Index i) { return !limits->contains(position(i)); });
  }
  if (entry.has("NSIDEX") && entry.integer("NSIDEX") != 0) {
    const auto* out = node_set(entry, "NSIDEX");
    if (!out) return std::nullopt;
    std::erase_if(nodes, [&](Index i) { return std::binary_search(out->begin(), out->end(), i); });
  }
  return nodes;
}

double Draft::plane_tolerance() const {
  const auto& p = model.mesh.nodes.position;
  const std::size_t count = model.mesh.nodes.count();
  if (count == 0) return 0.0;
  double low[3] = {p[0], p[1], p[2]}, high[3] = {p[0], p[1], p[2]};
  for (std::size_t i = 0; i < p.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], p[i]);
    high[i % 3] = std::max(high[i % 3], p[i]);
  }
  // A thousandth of the mean spacing that so many nodes would have in a cube as wide as the model.
  const double width = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  return 1e-3 * width / std::cbrt(static_cast<double>(count));
}

SetBook<Id>& Draft::element_sets(ElementKind kind) {
  return kind == ElementKind::solid ? solid_sets : kind == ElementKind::shell ? shell_sets : beam_sets;
}

std::optional<Draft::ElementPlace> Draft::element(Id id, ElementKind kind) {
  auto& index = element_index_[static_cast<std::size_t>(kind)];
  if (index.empty()) {
    const std::vector<Elements>& groups = model.mesh.elements(kind);
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (std::size_t e = 0; e < groups[g].count(); ++e)
        index.push_back({groups[g].id[e], {static_cast<std::uint32_t>(g), static_cast<std::uint32_t>(e)}});
    std::sort(index.begin(), index.end(), [](auto& a, auto& b) { return a.first < b.first; });
  }
  const auto at = std::lower_bound(index.begin(), index.end(), id,
                                   [](const auto& item, Id wanted) { return item.first < wanted; });
  if (at == index.end() || at->first != id) return std::nullopt;
  return at->second;
}

Index Draft::mid_node(Index a, Index b) {
  if (!mid_nodes_) {
    mid_nodes_.emplace();
    constexpr int edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
    for (const Elements& group : model.mesh.solids) {
      if (group.shape != Shape::tet10) continue;
      for (std::size_t e = 0; e < group.count(); ++e) {
        const Index* n = &group.node[10 * e];
        for (int k = 0; k < 6; ++k)
          mid_nodes_->emplace(std::minmax(n[edges[k][0]], n[edges[k][1]]), n[4 + k]);
      }
    }
  }
  const auto at = mid_nodes_->find(std::minmax(a, b));
  return at == mid_nodes_->end() ? -1 : at->second;
}

// --- *INCLUDE_TRANSFORM ------------------------------------------------------------------------------

const Affine& Draft::motion(int transform) {
  static const Affine identity;
  const auto& t = deck.transforms()[transform];
  if (transform == 0 || !transformations_read) return identity;
  if (const auto at = motions_.find(transform); at != motions_.end()) return at->second;
  Affine own;
  if (t.transformation != 0) {
    const auto definition = transformations.find(t.transformation);
    if (definition != transformations.end())
      own = definition->second;
    else
      diagnostics.error(t.place, "INCLUDE_TRANSFORM", "TRANID",
                        "transformation " + std::to_string(t.transformation) + " is not defined",
                        "add a *DEFINE_TRANSFORMATION");
  }
  // What moves the including file moves the included one too, afterwards.
  return motions_[transform] = followed_by(own, motion(t.parent));
}

Entry Draft::entry_of(deck::Card card, int transform) {
  return Entry(std::move(card), deck.transforms()[transform], motion(transform));
}

}  // namespace cleave::model
