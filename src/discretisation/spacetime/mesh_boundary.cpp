#include <algorithm>
#include <map>

#include "discretisation/spacetime/mesh.hpp"
#include "discretisation/spacetime/mesh_faces.hpp"
#include "discretisation/spacetime/mesh_words.hpp"

/// The boundary of a space mesh: opening cracks, listing and tagging faces, and where vertices may move.

namespace cleave::discretisation::spacetime {

/// Doubles the vertices around which crack faces separate the simplices. A tip is not doubled.
template <int D>
void SpaceMesh<D>::open_cracks() {
  std::vector<Vertex> touched;
  for (const CrackFace& crack : crack_)
    for (const Vertex v : face_of<D>(simplex_[index(crack.simplex)], crack.opposite)) touched.push_back(v);
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  if (touched.empty()) return;

  list_stars();
  // Stars of the mesh before doubling; a simplex that changed its corner is found by its place in the star.
  for (const Vertex v : touched) {
    const auto around = star(v);
    std::vector<int> group(around.size(), -1);
    int groups = 0;
    for (std::size_t a = 0; a < around.size(); ++a) {
      if (group[a] >= 0) continue;
      std::vector<std::size_t> open{a};
      group[a] = groups;
      while (!open.empty()) {  // walk through faces that contain v and are not cracked
        const auto s = index(around[open.back()]);
        open.pop_back();
        for (std::size_t i = 0; i <= D; ++i) {
          const Simplex next = across_[s][i];
          if (next < 0) continue;  // (across the face opposite v lies no simplex of the star)
          const auto at =
              static_cast<std::size_t>(std::lower_bound(around.begin(), around.end(), next) - around.begin());
          if (at == around.size() || around[at] != next || group[at] >= 0) continue;
          group[at] = groups;
          open.push_back(at);
        }
      }
      ++groups;
    }
    for (int g = 1; g < groups; ++g) {
      const auto twin = static_cast<Vertex>(position_.size());
      position_.push_back(Point<D>(position_[index(v)]));
      origin_.push_back(v);
      for (std::size_t a = 0; a < around.size(); ++a)
        if (group[a] == g)
          std::replace(simplex_[index(around[a])].begin(), simplex_[index(around[a])].end(), v, twin);
    }
  }
}

template <int D>
void SpaceMesh<D>::list_boundary() {
  std::array<std::int32_t, D + 1> none;
  none.fill(-1);
  face_of_.assign(simplex_.size(), none);
  boundary_.clear();
  for (std::size_t s = 0; s < simplex_.size(); ++s)
    for (int i = 0; i <= D; ++i) {
      if (across_[s][index(i)] >= 0) continue;
      BoundaryFace<D> face;
      face.simplex = static_cast<Simplex>(s);
      face.opposite = i;
      face.vertex = face_of<D>(simplex_[s], i);
      std::array<Point<D>, D> corner;
      for (std::size_t k = 0; k < D; ++k) corner[k] = position_[index(face.vertex[k])];
      face.normal = area_vector<static_cast<std::size_t>(D)>(corner, position_[index(simplex_[s][index(i)])]);
      face.area = norm(face.normal);
      for (double& component : face.normal) component /= face.area;
      face_of_[s][index(i)] = static_cast<std::int32_t>(boundary_.size());
      boundary_.push_back(face);
    }
  for (std::size_t c = 0; c < crack_.size(); ++c) {
    const auto one = face_of_[index(crack_[c].simplex)][index(crack_[c].opposite)];
    const auto other = face_of_[index(crack_[c].other)][index(crack_[c].other_opposite)];
    boundary_[index(one)].crack = boundary_[index(other)].crack = static_cast<std::int32_t>(c);
    boundary_[index(one)].twin = other;
    boundary_[index(other)].twin = one;
  }
}

template <int D>
MeshFault SpaceMesh<D>::tag_boundary(const SpaceMeshInput<D>& input) {
  if (input.tag.empty()) return {};
  std::map<std::array<Vertex, D>, std::vector<std::int32_t>> faces;
  for (std::size_t f = 0; f < boundary_.size(); ++f) {
    std::array<Vertex, D> face;
    for (std::size_t k = 0; k < D; ++k) face[k] = origin_[index(boundary_[f].vertex[k])];
    faces[sorted(face)].push_back(static_cast<std::int32_t>(f));
  }
  const Words<D> words(input);
  for (const FaceTag<D>& tag : input.tag) {
    const auto found = faces.find(sorted(tag.vertex));
    if (found == faces.end()) {
      std::string names;
      std::vector<std::size_t> places;
      for (const Vertex v : tag.vertex) {
        names += (names.empty() ? "" : ", ") + words.vertex(index(v));
        places.push_back(index(v));
      }
      return words.fault("the face with vertices " + names + " is not on the boundary",
                         "a load or support was given on a face inside the body", {}, places);
    }
    for (const std::int32_t f : found->second) boundary_[index(f)].tag = tag.tag;  // both faces of a crack
  }
  return {};
}

/// Normals of the boundary and of material interfaces at each vertex, made orthonormal.
template <int D>
void SpaceMesh<D>::find_held_directions() {
  held_.assign(position_.size(), {});
  held_count_.assign(position_.size(), 0);
  std::vector<std::int32_t> tag(position_.size(), -1);
  const auto hold = [&](Vertex v, Point<D> normal) {
    auto& count = held_count_[index(v)];
    for (std::int8_t k = 0; k < count; ++k) {
      const auto& e = held_[index(v)][index(k)];
      const double part = dot(normal, e);
      for (std::size_t j = 0; j < D; ++j) normal[j] -= part * e[j];
    }
    const double rest = norm(normal);
    if (rest < 1e-9 || count == D) return;
    for (double& component : normal) component /= rest;
    held_[index(v)][index(count++)] = normal;
  };
  const auto hold_all = [&](Vertex v) {
    for (std::size_t k = 0; k < D; ++k) {
      Point<D> axis{};
      axis[k] = 1.0;
      hold(v, axis);
    }
  };
  for (const BoundaryFace<D>& face : boundary_)
    for (const Vertex v : face.vertex) {
      hold(v, face.normal);
      if (tag[index(v)] >= 0 && tag[index(v)] != face.tag) hold_all(v);
      tag[index(v)] = face.tag;
      if (face.crack >= 0) hold_all(v);
    }
  for (std::size_t s = 0; s < simplex_.size(); ++s)
    for (int i = 0; i <= D; ++i) {
      const Simplex other = across_[s][index(i)];
      if (other < 0 || material_[index(other)] == material_[s]) continue;
      const auto face = face_of<D>(simplex_[s], i);
      std::array<Point<D>, D> corner;
      for (std::size_t k = 0; k < D; ++k) corner[k] = position_[index(face[k])];
      Point<D> normal =
          area_vector<static_cast<std::size_t>(D)>(corner, position_[index(simplex_[s][index(i)])]);
      const double size = norm(normal);
      for (double& component : normal) component /= size;
      for (const Vertex v : face) hold(v, normal);
    }
}

template <int D>
void SpaceMesh<D>::keep_on_boundary(Vertex v, Point<D>& displacement) const {
  if (held_count_[index(v)] == D) {
    displacement = {};
    return;
  }
  for (std::int8_t k = 0; k < held_count_[index(v)]; ++k) {
    const auto& e = held_[index(v)][index(k)];
    const double part = dot(displacement, e);
    for (std::size_t j = 0; j < D; ++j) displacement[j] -= part * e[j];
  }
}

#define CLEAVE_BOUNDARY(D)                                                 \
  template void SpaceMesh<D>::open_cracks();                               \
  template void SpaceMesh<D>::list_boundary();                             \
  template MeshFault SpaceMesh<D>::tag_boundary(const SpaceMeshInput<D>&); \
  template void SpaceMesh<D>::find_held_directions();                      \
  template void SpaceMesh<D>::keep_on_boundary(Vertex, Point<D>&) const;
CLEAVE_BOUNDARY(1)
CLEAVE_BOUNDARY(2)
CLEAVE_BOUNDARY(3)
#undef CLEAVE_BOUNDARY

}  // namespace cleave::discretisation::spacetime
