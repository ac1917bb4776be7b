#pragma once
/// The space mesh under the front: simplices, stars, facet neighbours, boundary faces, and cracks along
/// faces.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "discretisation/spacetime/geometry.hpp"

namespace cleave::discretisation::spacetime {

/// Why a mesh is refused, and where. `element` and `vertex` are the user's numbers (see SpaceMeshInput),
/// lowest first; both lists may be empty when the fault has no such place.
struct MeshFault {
  bool ok = true;
  std::string what;          ///< with the numbers and the place
  std::string likely_cause;  ///< and what to try
  std::vector<std::int64_t> element, vertex;
};

/// Wave speeds of one material. [length/time]
struct WaveSpeeds {
  double fastest = 0.0;  ///< largest phase speed over all directions: bounds the slope of the front
  double slowest = 0.0;  ///< smallest (shear) speed: bounds the inclination of poles
};

/// A face of the boundary and the number it shall carry (a load, a support, ...).
template <int D>
struct FaceTag {
  std::array<Vertex, D> vertex;
  std::int32_t tag = 0;
};

/// What a space mesh is made from. Faces may name their vertices in any order.
template <int D>
struct SpaceMeshInput {
  std::vector<Point<D>> vertex;                     ///< [length]
  std::vector<std::array<Vertex, D + 1>> simplex;   ///< positively oriented (1D: any order)
  std::vector<std::int32_t> material;               ///< [simplex], index into `speed`
  std::vector<WaveSpeeds> speed;                    ///< [material]
  std::vector<FaceTag<D>> tag;                      ///< boundary faces without one carry 0
  std::vector<std::array<Vertex, D>> crack;         ///< interior faces to be opened
  std::vector<std::int64_t> vertex_id, simplex_id;  ///< the user's numbers for messages; empty: index + 1
  bool touching_allowed = false;                    ///< may two unmerged vertices share a place?
};

/// A face of the boundary: of the body, or of a crack.
template <int D>
struct BoundaryFace {
  Simplex simplex = -1;
  std::int32_t opposite = -1;    ///< local number, in the simplex, of the corner not on the face
  std::array<Vertex, D> vertex;  ///< ascending local number
  Point<D> normal;               ///< unit, outward
  double area = 0.0;             ///< [length^(D-1)]
  std::int32_t tag = 0;
  std::int32_t crack = -1;  ///< index into SpaceMeshInput::crack; else -1
  std::int32_t twin = -1;   ///< the boundary face on the other side of the crack; else -1
};

/// A conforming simplicial mesh in D = 1, 2, 3 dimensions. Constant once built.
template <int D>
class SpaceMesh {
 public:
  /// Checks and connects. Refuses, leaving the mesh empty: degenerate or inverted simplices, vertices outside
  /// any simplex, hanging and doubled vertices, faces with more than two simplices, overlaps, crack faces
  /// that are not interior faces, tagged faces that are not on the boundary, speeds that are not positive.
  MeshFault build(const SpaceMeshInput<D>& input);

  Vertex vertex_count() const { return static_cast<Vertex>(position_.size()); }
  Simplex simplex_count() const { return static_cast<Simplex>(simplex_.size()); }

  const std::vector<Point<D>>& position() const { return position_; }  ///< initial [length]
  const std::array<Vertex, D + 1>& simplex(Simplex s) const { return simplex_[index(s)]; }
  std::int32_t material(Simplex s) const { return material_[index(s)]; }
  const WaveSpeeds& speed(Simplex s) const { return speed_[index(material_[index(s)])]; }

  /// Simplices around a vertex, ascending.
  std::span<const Simplex> star(Vertex v) const { return slice(star_start_, star_, v); }
  /// Vertices that share a simplex with v, ascending, without v.
  std::span<const Vertex> neighbours(Vertex v) const { return slice(near_start_, near_, v); }
  /// Simplex across the face opposite local corner i; -1 on the boundary.
  Simplex across(Simplex s, int i) const { return across_[index(s)][static_cast<std::size_t>(i)]; }
  /// Index of the boundary face opposite local corner i; -1 in the interior.
  std::int32_t boundary_face(Simplex s, int i) const {
    return face_of_[index(s)][static_cast<std::size_t>(i)];
  }
  const std::vector<BoundaryFace<D>>& boundary() const { return boundary_; }

  /// The vertex of the input that v stands for: itself, or the one it was doubled from.
  Vertex origin(Vertex v) const { return origin_[index(v)]; }
  /// Breaks ties of time: a permutation of the vertices by colour, then number. Vertices of a colour are
  /// never neighbours, so a level front has many local minima, and tents on it do not sweep in one direction.
  std::int32_t rank(Vertex v) const { return rank_[index(v)]; }
  /// Takes from a displacement what would move v off its boundary or material interface: all of it at
  /// corners, at crack faces and where tags meet.
  void keep_on_boundary(Vertex v, Point<D>& displacement) const;

  double volume() const;  ///< of the body [length^D]
  std::int64_t vertex_id(Vertex v) const;
  std::int64_t simplex_id(Simplex s) const;

 private:
  static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
  static std::span<const std::int32_t> slice(const std::vector<std::int32_t>& start,
                                             const std::vector<std::int32_t>& list, std::int32_t i) {
    const std::size_t begin = index(start[index(i)]), end = index(start[index(i) + 1]);
    return {list.data() + begin, end - begin};
  }
  MeshFault join_faces(const SpaceMeshInput<D>& input);
  void open_cracks();
  void list_boundary();
  MeshFault tag_boundary(const SpaceMeshInput<D>& input);
  void list_stars();
  void list_neighbours();
  void colour();
  void find_held_directions();

  struct CrackFace {
    Simplex simplex;
    std::int32_t opposite;
    Simplex other;
    std::int32_t other_opposite;
  };

  std::vector<Point<D>> position_;
  std::vector<std::array<Vertex, D + 1>> simplex_;
  std::vector<std::int32_t> material_;
  std::vector<WaveSpeeds> speed_;
  std::vector<std::array<Simplex, D + 1>> across_;
  std::vector<std::array<std::int32_t, D + 1>> face_of_;
  std::vector<BoundaryFace<D>> boundary_;
  std::vector<CrackFace> crack_;
  std::vector<Vertex> origin_;
  std::vector<std::int32_t> rank_, star_start_, star_, near_start_, near_;
  std::vector<std::array<Point<D>, D>> held_;  ///< orthonormal directions in which a vertex must not move
  std::vector<std::int8_t> held_count_;
  std::vector<std::int64_t> vertex_id_, simplex_id_;
};

/// Checks that the simplices do not overlap and no vertex hangs on another's face: part of SpaceMesh::build.
template <int D>
MeshFault check_covering(const SpaceMeshInput<D>& input, const std::vector<std::array<Vertex, D>>& boundary);

/// Mesh faces under a crack given by its corners: a polyline in 2D, a plane convex polygon in 3D. Fails where
/// the crack leaves the faces of the mesh, naming the part of it and the place. Appends to input.crack.
MeshFault add_crack(SpaceMeshInput<2>& input, std::span<const Point<2>> polyline);
MeshFault add_crack(SpaceMeshInput<3>& input, std::span<const Point<3>> polygon);

}  // namespace cleave::discretisation::spacetime
