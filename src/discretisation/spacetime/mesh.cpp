#include "discretisation/spacetime/mesh.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "discretisation/spacetime/mesh_faces.hpp"
#include "discretisation/spacetime/mesh_words.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// A face as seen by one simplex.
template <int D>
struct Side {
  std::array<Vertex, D> face;
  Simplex simplex;
  std::int32_t opposite;
  bool operator<(const Side& o) const {
    return face != o.face         ? face < o.face
           : simplex != o.simplex ? simplex < o.simplex
                                  : opposite < o.opposite;
  }
};

/// Rows of `count` lists given by (row, entry) pairs that arrive in the wanted order.
void make_rows(std::size_t count, const std::vector<std::pair<std::int32_t, std::int32_t>>& pairs,
               std::vector<std::int32_t>& start, std::vector<std::int32_t>& list) {
  start.assign(count + 1, 0);
  for (const auto& pair : pairs) ++start[static_cast<std::size_t>(pair.first) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::int32_t> next(start.begin(), start.end() - 1);
  list.resize(pairs.size());
  for (const auto& [row, entry] : pairs)
    list[static_cast<std::size_t>(next[static_cast<std::size_t>(row)]++)] = entry;
}

/// The simplices themselves: numbers in range, speeds positive, volumes positive.
template <int D>
MeshFault check_simplices(const SpaceMeshInput<D>& in, std::vector<std::array<Vertex, D + 1>>& simplex) {
  const Words<D> words(in);
  if (in.simplex.empty()) return words.fault("the mesh has no elements", "", {}, {});
  for (std::size_t m = 0; m < in.speed.size(); ++m)
    if (!(in.speed[m].slowest > 0.0 && in.speed[m].fastest >= in.speed[m].slowest &&
          in.speed[m].fastest < 1e300))
      return words.fault("material " + std::to_string(m + 1) + " has no positive wave speed",
                         "zero or negative density or modulus", {}, {});
  std::vector<char> used(in.vertex.size(), 0);
  simplex = in.simplex;
  for (std::size_t s = 0; s < simplex.size(); ++s) {
    std::array<Point<D>, D + 1> corner;
    double longest = 0.0;
    for (std::size_t i = 0; i <= D; ++i) {
      const Vertex v = simplex[s][i];
      if (v < 0 || static_cast<std::size_t>(v) >= in.vertex.size())
        return words.fault("element " + words.element(s) + " names a vertex that does not exist", "", {s},
                           {});
      used[static_cast<std::size_t>(v)] = 1;
      corner[i] = in.vertex[static_cast<std::size_t>(v)];
      for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, distance(corner[i], corner[j]));
    }
    if constexpr (D == 1) {
      if (corner[1][0] < corner[0][0]) {
        std::swap(simplex[s][0], simplex[s][1]);
        std::swap(corner[0], corner[1]);
      }
    }
    const double volume = signed_volume<D>(corner), scale = std::pow(longest, D);
    if (!(std::abs(volume) > 1e-12 * scale))
      return words.fault("element " + words.element(s) + " is degenerate: its corners lie in one " +
                             (D == 3   ? "plane"
                              : D == 2 ? "line"
                                       : "point") +
                             words.at(corner[0]),
                         "repeated or misplaced nodes", {s}, {});
    if (volume < 0.0)
      return words.fault("element " + words.element(s) + " is inverted" + words.at(corner[0]),
                         "its nodes are numbered the other way round", {s}, {});
    const std::int32_t material = in.material[s];
    if (material < 0 || static_cast<std::size_t>(material) >= in.speed.size())
      return words.fault("element " + words.element(s) + " has no material", "", {s}, {});
  }
  for (std::size_t v = 0; v < used.size(); ++v)
    if (!used[v])
      return words.fault("vertex " + words.vertex(v) + " belongs to no element" + words.at(in.vertex[v]), "",
                         {}, {v});
  return {};
}

}  // namespace

template <int D>
MeshFault SpaceMesh<D>::build(const SpaceMeshInput<D>& input) {
  *this = {};
  std::vector<std::array<Vertex, D + 1>> simplex;
  if (MeshFault fault = check_simplices<D>(input, simplex); !fault.ok) return fault;
  simplex_ = std::move(simplex);
  position_ = input.vertex;
  material_ = input.material;
  speed_ = input.speed;
  vertex_id_ = input.vertex_id;
  simplex_id_ = input.simplex_id;
  origin_.resize(position_.size());
  std::iota(origin_.begin(), origin_.end(), 0);
  MeshFault fault = join_faces(input);
  if (fault.ok) {
    open_cracks();
    list_boundary();
    fault = tag_boundary(input);
  }
  if (!fault.ok) {
    *this = {};
    return fault;
  }
  list_stars();
  list_neighbours();
  colour();
  find_held_directions();
  return {};
}

/// Finds across_ and crack_; checks that the simplices cover their body once.
template <int D>
MeshFault SpaceMesh<D>::join_faces(const SpaceMeshInput<D>& input) {
  const Words<D> words(input);
  std::vector<Side<D>> sides;
  sides.reserve(simplex_.size() * (D + 1));
  for (std::size_t s = 0; s < simplex_.size(); ++s)
    for (int i = 0; i <= D; ++i)
      sides.push_back({sorted(face_of<D>(simplex_[s], i)), static_cast<Simplex>(s), i});
  std::sort(sides.begin(), sides.end());

  std::vector<std::array<Vertex, D>> cracks;
  for (const auto& face : input.crack) cracks.push_back(sorted(face));
  std::array<Simplex, D + 1> none;
  none.fill(-1);
  across_.assign(simplex_.size(), none);
  std::vector<std::array<Vertex, D>> outer;
  std::map<std::array<Vertex, D>, std::pair<Side<D>, Side<D>>> wanted;  // crack faces found inside the mesh
  for (const auto& face : cracks) wanted.try_emplace(face);
  std::map<std::array<Vertex, D>, bool> found;

  for (std::size_t a = 0, b; a < sides.size(); a = b) {
    for (b = a + 1; b < sides.size() && sides[b].face == sides[a].face; ++b) {
    }
    if (b - a == 1) {
      outer.push_back(sides[a].face);
      continue;
    }
    const auto first = static_cast<std::size_t>(sides[a].simplex),
               second = static_cast<std::size_t>(sides[a + 1].simplex);
    if (b - a > 2)
      return words.fault("elements " + words.element(first) + ", " + words.element(second) + " and " +
                             words.element(static_cast<std::size_t>(sides[a + 2].simplex)) + " share a face" +
                             words.at(position_[index(sides[a].face[0])]),
                         "overlapping parts, or an element given twice", {first, second}, {});
    // Two simplices on the same side of their common face overlap.
    std::array<Point<D>, D> corner;
    for (std::size_t i = 0; i < D; ++i) corner[i] = position_[index(sides[a].face[i])];
    const Vertex top = simplex_[first][index(sides[a].opposite)],
                 back = simplex_[second][index(sides[a + 1].opposite)];
    const auto normal = area_vector<static_cast<std::size_t>(D)>(corner, position_[index(top)]);
    if (dot(normal, difference(position_[index(back)], corner[0])) <= 0.0)
      return words.fault("elements " + words.element(first) + " and " + words.element(second) +
                             " lie on the same side of their common face" + words.at(corner[0]),
                         "overlapping parts, or an element given twice", {first, second}, {});
    if (const auto crack = wanted.find(sides[a].face); crack != wanted.end()) {
      crack->second = {sides[a], sides[a + 1]};
      found[sides[a].face] = true;
      continue;
    }
    across_[first][index(sides[a].opposite)] = sides[a + 1].simplex;
    across_[second][index(sides[a + 1].opposite)] = sides[a].simplex;
  }

  crack_.clear();
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    if (!found.count(cracks[c])) {
      std::string names;
      std::vector<std::size_t> places;
      for (const Vertex v : cracks[c]) {
        const bool exists = v >= 0 && static_cast<std::size_t>(v) < position_.size();
        names += (names.empty() ? "" : ", ") + (exists ? words.vertex(index(v)) : std::string("(none)"));
        if (exists) places.push_back(index(v));
      }
      return words.fault("the crack face with vertices " + names + " is no face between two elements",
                         "a crack must follow faces inside the mesh", {}, places);
    }
    const auto& [one, other] = wanted[cracks[c]];
    crack_.push_back({one.simplex, one.opposite, other.simplex, other.opposite});
  }
  return check_covering<D>(input, outer);
}

template <int D>
void SpaceMesh<D>::list_stars() {
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  pairs.reserve(simplex_.size() * (D + 1));
  for (std::size_t s = 0; s < simplex_.size(); ++s)
    for (const Vertex v : simplex_[s]) pairs.emplace_back(v, static_cast<Simplex>(s));
  make_rows(position_.size(), pairs, star_start_, star_);
}

template <int D>
void SpaceMesh<D>::list_neighbours() {
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  std::vector<Vertex> around;
  for (Vertex v = 0; v < vertex_count(); ++v) {
    around.clear();
    for (const Simplex s : star(v))
      for (const Vertex w : simplex(s))
        if (w != v) around.push_back(w);
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    for (const Vertex w : around) pairs.emplace_back(v, w);
  }
  make_rows(position_.size(), pairs, near_start_, near_);
}

/// Greedy colouring in the order of the vertices, then numbers by (colour, vertex).
template <int D>
void SpaceMesh<D>::colour() {
  std::vector<std::int32_t> colour(position_.size(), -1), order(position_.size());
  std::vector<char> taken;
  for (Vertex v = 0; v < vertex_count(); ++v) {
    taken.assign(neighbours(v).size() + 1, 0);
    for (const Vertex w : neighbours(v))
      if (w < v && index(colour[index(w)]) < taken.size()) taken[index(colour[index(w)])] = 1;
    colour[index(v)] = static_cast<std::int32_t>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
  }
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Vertex a, Vertex b) { return colour[index(a)] < colour[index(b)]; });
  rank_.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank_[index(order[i])] = static_cast<std::int32_t>(i);
}

template <int D>
double SpaceMesh<D>::volume() const {
  double sum = 0.0;
  for (const auto& simplex : simplex_) {
    std::array<Point<D>, D + 1> corner;
    for (std::size_t i = 0; i <= D; ++i) corner[i] = position_[index(simplex[i])];
    sum += signed_volume<static_cast<std::size_t>(D)>(corner);
  }
  return sum;
}

template <int D>
std::int64_t SpaceMesh<D>::vertex_id(Vertex v) const {
  const Vertex o = origin(v);
  return vertex_id_.empty() ? o + 1 : vertex_id_[index(o)];
}

template <int D>
std::int64_t SpaceMesh<D>::simplex_id(Simplex s) const {
  return simplex_id_.empty() ? s + 1 : simplex_id_[index(s)];
}

template class SpaceMesh<1>;
template class SpaceMesh<2>;
template class SpaceMesh<3>;

}  // namespace cleave::discretisation::spacetime
