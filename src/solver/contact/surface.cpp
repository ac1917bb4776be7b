#include "solver/contact/surface.hpp"

#include <algorithm>
#include <map>
#include <memory>

#include "discretisation/rigid/block.hpp"
#include "model/material/law.hpp"
#include "model/solid_geometry.hpp"
#include "model/solid_shape.hpp"

namespace cleave::solver {

using model::Segment;

namespace {

std::array<Index, 4> key_of(const Segment& face) {
  std::array<Index, 4> key{face.node[0], face.node[1], face.node[2], face.node[3]};
  if (face.node[3] == face.node[2]) key[3] = -1;
  std::sort(key.begin(), key.end());
  return key;
}

/// Does the second face run round its corners in the opposite sense of the first?
bool reversed(const Segment& a, const Segment& b) {
  const int count = a.node[3] == a.node[2] ? 3 : 4;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      if (b.node[j] == a.node[i]) return b.node[(j + 1) % count] != a.node[(i + 1) % count];
  return false;
}

Segment turned(const Segment& f) {
  if (f.node[3] == f.node[2]) return {{f.node[0], f.node[2], f.node[1], f.node[1]}};
  return {{f.node[0], f.node[3], f.node[2], f.node[1]}};
}

}  // namespace

Vector area_normal(const Face& face, std::span<const double> position) {
  const Vector a = vector_at(position, face.node[0]), b = vector_at(position, face.node[1]);
  const Vector c = vector_at(position, face.node[2]), d = vector_at(position, face.node[3]);
  return 0.5 * base::cross(c - a, d - b);
}

Surface::Surface(const discretisation::World& world, const model::Contact& contact,
                 const model::ContactSide& side, bool inner, bool orient, deck::Diagnostics& diagnostics)
    : world_(world) {
  if (side.parts.empty()) {
    add_listed(contact, side, orient, diagnostics);
  } else {
    add_outer(contact, inner, side.parts);
    add_shells(contact, side.parts);
  }
  list_owned();
  alive_.assign(elements_.size(), 1);
  connect();
}

/// Every side of the elements whose part is wanted, those of equal corners together.
template <class Wanted>
std::vector<Surface::Side> Surface::sides_of(const Wanted& wanted) const {
  std::vector<Side> sides;
  const model::Mesh& mesh = world_.model->mesh;
  for (std::size_t g = 0; g < mesh.solids.size(); ++g) {
    const model::Elements& group = mesh.solids[g];
    const auto n = static_cast<std::size_t>(model::nodes_of(group.shape));
    for (std::size_t e = 0; e < group.count(); ++e) {
      const Index* nodes = &group.node[n * e];
      if (!wanted(group.part[e], nodes, n)) continue;
      for (const auto& local : model::faces_of(group.shape)) {
        Index corner[4];  // repeated nodes make triangles of quadrilaterals, or nothing
        int count = 0;
        for (const int a : local)
          if (std::find(corner, corner + count, nodes[a]) == corner + count) corner[count++] = nodes[a];
        if (count < 3) continue;
        if (count == 3) corner[3] = corner[2];
        const Segment face{{corner[0], corner[1], corner[2], corner[3]}};
        sides.push_back({key_of(face), face, static_cast<std::int32_t>(g), static_cast<std::int32_t>(e)});
      }
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key < b.key; });
  return sides;
}

void Surface::add_outer(const model::Contact& contact, bool inner, std::span<const Index> parts) {
  const auto sides = sides_of([&](Index part, const Index*, std::size_t) {
    return std::binary_search(parts.begin(), parts.end(), part);
  });
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].key == sides[i].key) ++j;
    if (j == i + 1) add_face(contact, sides[i].face, sides[i], -1);
    if (j == i + 2 && inner) {
      const auto first = static_cast<std::int32_t>(faces_.size());
      add_face(contact, sides[i].face, sides[i], first + 1);
      add_face(contact, sides[i + 1].face, sides[i + 1], first);
    }
    i = j;
  }
}

void Surface::add_listed(const model::Contact& contact, const model::ContactSide& side, bool orient,
                         deck::Diagnostics& diagnostics) {
  std::vector<char> used(world_.node_count(), 0);
  for (const Segment& face : side.segments)
    for (const Index node : face.node) used[static_cast<std::size_t>(node)] = 1;
  const auto sides = sides_of([&](Index, const Index* nodes, std::size_t n) {
    return std::count_if(nodes, nodes + n, [&](Index a) { return used[static_cast<std::size_t>(a)] != 0; }) >=
           3;
  });
  std::map<std::array<Index, 4>, std::pair<std::size_t, std::size_t>> shells;
  for (std::size_t g = 0; g < world_.model->mesh.shells.size(); ++g) {
    const model::Elements& group = world_.model->mesh.shells[g];
    const auto n = static_cast<std::size_t>(model::nodes_of(group.shape));
    for (std::size_t e = 0; e < group.count(); ++e) {
      const Index* node = &group.node[n * e];
      shells.emplace(key_of({{node[0], node[1], node[2], node[n - 1]}}), std::pair{g, e});
    }
  }
  const auto name = [&](const Segment& face) {
    std::string text;
    for (const Index node : face.node)
      text += (text.empty() ? "" : " ") +
              std::to_string(world_.model->mesh.nodes.id[static_cast<std::size_t>(node)]);
    return text;
  };
  for (const Segment& face : side.segments) {
    const auto key = key_of(face);
    const auto at = std::lower_bound(sides.begin(), sides.end(), key,
                                     [](const Side& s, const std::array<Index, 4>& k) { return s.key < k; });
    if (at == sides.end() || at->key != key) {
      if (const auto shell = shells.find(key); shell != shells.end()) {
        const auto [group, element] = shell->second;
        add_shell(contact, group, element, face);
        if (orient) add_shell(contact, group, element, turned(face));
        continue;
      }
      diagnostics.error(
          contact.place, contact.keyword, "", "segment " + name(face) + " is no face of a solid",
          "contact needs the element behind a face: name faces of *ELEMENT_SOLID or rigid shells");
      continue;
    }
    const bool back = reversed(at->face, face);
    if (back && !orient)
      diagnostics.error(contact.place, contact.keyword, "",
                        "normals are not consistent: segment " + name(face) + " points into its solid",
                        "number its nodes counter-clockwise seen from outside, or give ORIEN 2 in "
                        "*CONTROL_CONTACT to have it turned");
    add_face(contact, back ? turned(face) : face, *at, -1);
  }
}

std::int32_t Surface::number(model::Id key) {
  const auto [at, fresh] = number_.try_emplace(key, static_cast<std::int32_t>(elements_.size()));
  if (fresh) elements_.push_back(key);
  return at->second;
}

/// Both sides of every shell of the parts.
void Surface::add_shells(const model::Contact& contact, std::span<const Index> parts) {
  const auto& shells = world_.model->mesh.shells;
  for (std::size_t g = 0; g < shells.size(); ++g) {
    const auto n = static_cast<std::size_t>(model::nodes_of(shells[g].shape));
    for (std::size_t e = 0; e < shells[g].count(); ++e) {
      if (!std::binary_search(parts.begin(), parts.end(), shells[g].part[e])) continue;
      const Index* node = &shells[g].node[n * e];
      const Segment top{{node[0], node[1], node[2], node[n - 1]}};
      add_shell(contact, g, e, top);
      add_shell(contact, g, e, turned(top));
    }
  }
}

/// One side of a shell: its stiffness is K A over the diagonal, and what is behind it as deep as it is wide.
void Surface::add_shell(const model::Contact& contact, std::size_t g, std::size_t e, const Segment& side) {
  const model::Model& model = *world_.model;
  const model::Elements& group = model.mesh.shells[g];
  const model::Part& part = model.parts[static_cast<std::size_t>(group.part[e])];
  Face face;
  face.node = {side.node[0], side.node[1], side.node[2], side.node[3]};
  face.element = group.id[e];
  face.part = group.part[e];
  face.rigid = static_cast<bool>(world_.model->parts[static_cast<std::size_t>(face.part)].rigid);
  face.owner = number(-group.id[e]);
  face.shell = true;
  const int rule = model.control.contact.shell_thickness;
  const double thickness = discretisation::shell_thickness(part.section);
  if (contact.automatic || rule == 2 || (rule == 1 && !part.rigid)) face.offset = 0.5 * thickness;
  largest_offset_ = std::max(largest_offset_, face.offset);
  face.area = norm(area_normal(face, model.mesh.nodes.position));
  face.thickness = std::max(thickness, std::sqrt(face.area));
  double diagonal = 0.0;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < a; ++b)
      diagonal = std::max(diagonal, norm(vector_at(model.mesh.nodes.position, face.node[a]) -
                                         vector_at(model.mesh.nodes.position, face.node[b])));
  const double bulk = part.law ? part.law->bulk_modulus() : 0.0;
  face.stiffness = diagonal > 0.0 ? bulk * face.area / diagonal : 0.0;
  faces_.push_back(face);
}

void Surface::add_face(const model::Contact& contact, const Segment& segment, const Side& side,
                       std::int32_t twin) {
  const model::Model& model = *world_.model;
  const model::Elements& group = model.mesh.solids[static_cast<std::size_t>(side.group)];
  const auto n = static_cast<std::size_t>(model::nodes_of(group.shape));
  const auto e = static_cast<std::size_t>(side.element);
  Face face;
  face.node = {segment.node[0], segment.node[1], segment.node[2], segment.node[3]};
  face.element = group.id[e];
  face.part = group.part[e];
  face.rigid = static_cast<bool>(world_.model->parts[static_cast<std::size_t>(face.part)].rigid);
  face.owner = number(group.id[e]);
  face.twin = twin;
  std::array<model::Corner, 10> corner;
  for (std::size_t a = 0; a < n; ++a) corner[a] = vector_at(model.mesh.nodes.position, group.node[n * e + a]);
  const double volume = model::volume(group.shape, {corner.data(), n});
  face.area = norm(area_normal(face, model.mesh.nodes.position));
  face.thickness = face.area > 0.0 ? volume / face.area : 0.0;
  const model::Part& part = model.parts[static_cast<std::size_t>(face.part)];
  const double own = part.law ? part.law->bulk_modulus() : 0.0;
  const double bulk = contact.solid_modulus > 0.0 ? contact.solid_modulus : own;
  face.offset = 0.5 * contact.solid_thickness;
  largest_offset_ = std::max(largest_offset_, face.offset);
  face.stiffness = volume > 0.0 ? bulk * face.area * face.area / volume : 0.0;
  faces_.push_back(face);
}

void Surface::start(const discretisation::State& state) {
  alive_.assign(elements_.size(), 1);
  for (std::size_t b = 0; b < world_.blocks.size(); ++b) {
    const auto ids = world_.blocks[b]->element_ids();
    const auto alive = std::make_unique<bool[]>(ids.size());
    world_.blocks[b]->alive(state.blocks[b], {alive.get(), ids.size()});
    for (std::size_t e = 0; e < ids.size(); ++e)
      if (!alive[e])
        if (const auto at = number_.find(ids[e]); at != number_.end())
          alive_[static_cast<std::size_t>(at->second)] = 0;
  }
  connect();
}

void Surface::list_owned() {
  first_owned_.assign(elements_.size() + 1, 0);
  for (const Face& face : faces_) ++first_owned_[static_cast<std::size_t>(face.owner) + 1];
  for (std::size_t e = 0; e < elements_.size(); ++e) first_owned_[e + 1] += first_owned_[e];
  owned_.resize(faces_.size());
  std::vector<std::int32_t> next(first_owned_.begin(), first_owned_.end() - 1);
  for (std::size_t f = 0; f < faces_.size(); ++f)
    owned_[static_cast<std::size_t>(next[static_cast<std::size_t>(faces_[f].owner)]++)] =
        static_cast<std::int32_t>(f);
}

void Surface::erode(std::span<const model::Id> eroded) {
  std::vector<std::size_t> dead;
  for (const model::Id id : eroded)
    if (const auto at = number_.find(id); at != number_.end()) {
      alive_[static_cast<std::size_t>(at->second)] = 0;
      dead.push_back(static_cast<std::size_t>(at->second));
    }
  // The faces of these elements go; those they hid appear.
  std::vector<std::int32_t> gone, bared;
  for (const std::size_t e : dead)
    for (std::int32_t i = first_owned_[e]; i < first_owned_[e + 1]; ++i) {
      const std::int32_t f = owned_[static_cast<std::size_t>(i)];
      const std::int32_t twin = faces_[static_cast<std::size_t>(f)].twin;
      if (here_[static_cast<std::size_t>(f)]) {
        here_[static_cast<std::size_t>(f)] = 0;
        gone.push_back(f);
      } else if (twin >= 0 && !here_[static_cast<std::size_t>(twin)] &&
                 alive_[static_cast<std::size_t>(faces_[static_cast<std::size_t>(twin)].owner)]) {
        here_[static_cast<std::size_t>(twin)] = 1;
        bared.push_back(twin);
      }
    }
  if (gone.empty() && bared.empty()) return;
  ++version_;

  std::erase_if(active_, [&](std::int32_t f) { return !here_[static_cast<std::size_t>(f)]; });
  std::sort(bared.begin(), bared.end());
  const auto old = static_cast<std::ptrdiff_t>(active_.size());
  active_.insert(active_.end(), bared.begin(), bared.end());
  std::inplace_merge(active_.begin(), active_.begin() + old, active_.end());

  std::vector<Index> touched, fresh;
  const auto corners_of = [&](const std::vector<std::int32_t>& some, const auto& act) {
    for (const std::int32_t f : some) {
      const Face& face = faces_[static_cast<std::size_t>(f)];
      for (int a = 0; a < face.corners(); ++a) act(face.node[static_cast<std::size_t>(a)], f);
    }
  };
  corners_of(gone, [&](Index node, std::int32_t f) { leave(node, f), touched.push_back(node); });
  corners_of(bared, [&](Index node, std::int32_t f) { enter(node, f), touched.push_back(node); });
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());

  std::erase_if(nodes_, [&](Index node) { return rows_[static_cast<std::size_t>(node)].count == 0; });
  for (const Index node : touched)
    if (rows_[static_cast<std::size_t>(node)].count > 0 &&
        !std::binary_search(nodes_.begin(), nodes_.end(), node))
      fresh.push_back(node);
  const auto before = static_cast<std::ptrdiff_t>(nodes_.size());
  nodes_.insert(nodes_.end(), fresh.begin(), fresh.end());
  std::inplace_merge(nodes_.begin(), nodes_.begin() + before, nodes_.end());
  for (const Index node : touched)
    for (const std::int32_t f : faces_at(node)) find_neighbours(f);
}

void Surface::connect() {
  ++version_;
  // A face is there while its element is and the one across is not.
  active_.clear();
  here_.assign(faces_.size(), 0);
  rows_.assign(world_.node_count(), {});
  neighbour_.assign(4 * faces_.size(), -1);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    if (!alive_[static_cast<std::size_t>(face.owner)]) continue;
    if (face.twin >= 0 && alive_[static_cast<std::size_t>(faces_[static_cast<std::size_t>(face.twin)].owner)])
      continue;
    here_[f] = 1;
    active_.push_back(static_cast<std::int32_t>(f));
    for (int a = 0; a < face.corners(); ++a)
      ++rows_[static_cast<std::size_t>(face.node[static_cast<std::size_t>(a)])].room;
  }
  nodes_.clear();
  std::int32_t total = 0;
  for (std::size_t node = 0; node < rows_.size(); ++node) {
    rows_[node].first = total;
    total += rows_[node].room;
    if (rows_[node].room > 0) nodes_.push_back(static_cast<Index>(node));
  }
  list_.resize(static_cast<std::size_t>(total));
  for (const std::int32_t f : active_) {
    const Face& face = faces_[static_cast<std::size_t>(f)];
    for (int a = 0; a < face.corners(); ++a) enter(face.node[static_cast<std::size_t>(a)], f);
  }
  for (const std::int32_t f : active_) find_neighbours(f);
}

/// Lists a face at a node, in its place.
void Surface::enter(Index node, std::int32_t face) {
  Row& row = rows_[static_cast<std::size_t>(node)];
  if (row.count == row.room) {
    const auto end = static_cast<std::int32_t>(list_.size());
    const std::int32_t room = std::max(8, 2 * row.room);
    list_.resize(list_.size() + static_cast<std::size_t>(room));
    std::copy_n(list_.begin() + row.first, row.count, list_.begin() + end);
    row.first = end;
    row.room = room;
  }
  const auto begin = list_.begin() + row.first, end = begin + row.count;
  const auto at = std::lower_bound(begin, end, face);
  std::copy_backward(at, end, end + 1);
  *at = face;
  ++row.count;
}

void Surface::leave(Index node, std::int32_t face) {
  Row& row = rows_[static_cast<std::size_t>(node)];
  const auto begin = list_.begin() + row.first, end = begin + row.count;
  row.count = static_cast<std::int32_t>(std::remove(begin, end, face) - begin);
}

/// The face across the edge from corner a to the next is the one that runs it the other way.
void Surface::find_neighbours(std::int32_t f) {
  const Face& face = faces_[static_cast<std::size_t>(f)];
  for (int a = 0; a < face.corners(); ++a) {
    const Index from = face.node[static_cast<std::size_t>(a)];
    const Index to = face.node[static_cast<std::size_t>((a + 1) % face.corners())];
    std::int32_t found = -1;
    for (const std::int32_t g : faces_at(to)) {
      const Face& other = faces_[static_cast<std::size_t>(g)];
      if (other.owner == face.owner && face.shell) continue;  // its other side
      for (int b = 0; b < other.corners(); ++b)
        if (other.node[static_cast<std::size_t>(b)] == to &&
            other.node[static_cast<std::size_t>((b + 1) % other.corners())] == from)
          found = found == -1 ? g : -2;
    }
    neighbour_[4 * static_cast<std::size_t>(f) + static_cast<std::size_t>(a)] = found < 0 ? -1 : found;
  }
}

std::span<const std::int32_t> Surface::faces_at(Index node) const {
  const Row& row = rows_[static_cast<std::size_t>(node)];
  return {list_.data() + row.first, static_cast<std::size_t>(row.count)};
}

}  // namespace cleave::solver
