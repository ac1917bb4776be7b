#include "solver/contact/surface.hpp"

#include <algorithm>
#include <memory>

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
  if (side.parts.empty())
    add_listed(contact, side, orient, diagnostics);
  else
    add_outer(inner, side.parts);
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

void Surface::add_outer(bool inner, std::span<const Index> parts) {
  const auto sides = sides_of([&](Index part, const Index*, std::size_t) {
    return std::binary_search(parts.begin(), parts.end(), part);
  });
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].key == sides[i].key) ++j;
    if (j == i + 1) add_face(sides[i].face, sides[i], -1);
    if (j == i + 2 && inner) {
      const std::int32_t first = number(sides[i]), second = number(sides[i + 1]);
      add_face(sides[i].face, sides[i], second);
      add_face(sides[i + 1].face, sides[i + 1], first);
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
      diagnostics.error(contact.place, contact.keyword, "",
                        "segment " + name(face) + " is no face of a solid",
                        "contact needs the solid behind a face: name faces of *ELEMENT_SOLID");
      continue;
    }
    const bool back = reversed(at->face, face);
    if (back && !orient)
      diagnostics.error(contact.place, contact.keyword, "",
                        "normals are not consistent: segment " + name(face) + " points into its solid",
                        "number its nodes counter-clockwise seen from outside, or give ORIEN 2 in "
                        "*CONTROL_CONTACT to have it turned");
    add_face(back ? turned(face) : face, *at, -1);
  }
}

std::int32_t Surface::number(const Side& side) {
  const model::Id id = world_.model->mesh.solids[static_cast<std::size_t>(side.group)]
                           .id[static_cast<std::size_t>(side.element)];
  const auto [at, fresh] = number_.try_emplace(id, static_cast<std::int32_t>(elements_.size()));
  if (fresh) elements_.push_back(id);
  return at->second;
}

void Surface::add_face(const Segment& segment, const Side& side, std::int32_t across) {
  const model::Model& model = *world_.model;
  const model::Elements& group = model.mesh.solids[static_cast<std::size_t>(side.group)];
  const auto n = static_cast<std::size_t>(model::nodes_of(group.shape));
  const auto e = static_cast<std::size_t>(side.element);
  Face face;
  face.node = {segment.node[0], segment.node[1], segment.node[2], segment.node[3]};
  face.element = group.id[e];
  face.part = group.part[e];
  face.owner = number(side);
  face.across = across;
  std::array<model::Corner, 10> corner;
  for (std::size_t a = 0; a < n; ++a) corner[a] = vector_at(model.mesh.nodes.position, group.node[n * e + a]);
  const double volume = model::volume(group.shape, {corner.data(), n});
  face.area = norm(area_normal(face, model.mesh.nodes.position));
  face.thickness = face.area > 0.0 ? volume / face.area : 0.0;
  const model::Part& part = model.parts[static_cast<std::size_t>(face.part)];
  const double bulk = part.law ? part.law->bulk_modulus() : 0.0;
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

bool Surface::erode(std::span<const model::Id> eroded) {
  bool changed = false;
  for (const model::Id id : eroded)
    if (const auto at = number_.find(id); at != number_.end()) {
      alive_[static_cast<std::size_t>(at->second)] = 0;
      changed = true;
    }
  if (changed) connect();
  return changed;
}

void Surface::connect() {
  // A face is there while its element is and the one across is not.
  active_.clear();
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    if (alive_[static_cast<std::size_t>(face.owner)] &&
        (face.across < 0 || !alive_[static_cast<std::size_t>(face.across)]))
      active_.push_back(static_cast<std::int32_t>(f));
  }
  nodes_.clear();
  for (const std::int32_t f : active_)
    for (const Index node : faces_[static_cast<std::size_t>(f)].node) nodes_.push_back(node);
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  place_.assign(world_.node_count(), -1);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    place_[static_cast<std::size_t>(nodes_[i])] = static_cast<std::int32_t>(i);

  first_.assign(nodes_.size() + 1, 0);
  const auto each_corner = [&](const auto& act) {
    for (const std::int32_t f : active_) {
      const Face& face = faces_[static_cast<std::size_t>(f)];
      for (int a = 0; a < face.corners(); ++a)
        act(f, a,
            static_cast<std::size_t>(
                place_[static_cast<std::size_t>(face.node[static_cast<std::size_t>(a)])]));
    }
  };
  each_corner([&](std::int32_t, int, std::size_t at) { ++first_[at + 1]; });
  for (std::size_t i = 0; i < nodes_.size(); ++i) first_[i + 1] += first_[i];
  list_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  each_corner([&](std::int32_t f, int, std::size_t at) { list_[static_cast<std::size_t>(next[at]++)] = f; });

  // The face across the edge from corner a to the next is the one that runs it the other way.
  neighbour_.assign(4 * faces_.size(), -1);
  each_corner([&](std::int32_t f, int a, std::size_t) {
    const Face& face = faces_[static_cast<std::size_t>(f)];
    const Index from = face.node[static_cast<std::size_t>(a)];
    const Index to = face.node[static_cast<std::size_t>((a + 1) % face.corners())];
    std::int32_t found = -1;
    for (const std::int32_t g : faces_at(to)) {
      const Face& other = faces_[static_cast<std::size_t>(g)];
      for (int b = 0; b < other.corners(); ++b)
        if (other.node[static_cast<std::size_t>(b)] == to &&
            other.node[static_cast<std::size_t>((b + 1) % other.corners())] == from)
          found = found == -1 ? g : -2;
    }
    neighbour_[4 * static_cast<std::size_t>(f) + static_cast<std::size_t>(a)] = found < 0 ? -1 : found;
  });
}

std::span<const std::int32_t> Surface::faces_at(Index node) const {
  const std::int32_t at = place_[static_cast<std::size_t>(node)];
  if (at < 0) return {};
  const auto begin = static_cast<std::size_t>(first_[static_cast<std::size_t>(at)]);
  const auto end = static_cast<std::size_t>(first_[static_cast<std::size_t>(at) + 1]);
  return {list_.data() + begin, end - begin};
}

}  // namespace cleave::solver
