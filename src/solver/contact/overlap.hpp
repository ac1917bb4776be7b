#pragma once
/// How two faces lie over each other: the polygon they share, seen along their common normal, and the energy
/// that is in it. Theory: docs/solver/contact.md, section 3.

#include "solver/contact/pair_energy.hpp"
#include "solver/contact/shadow.hpp"

namespace cleave::solver {

/// A quadrature point of the shared polygon.
struct SharedPoint {
  double area;          ///< [length^2]
  double gap;           ///< from a to b along the normal, positive where a is behind b [length]
  double wa[4], wb[4];  ///< values of the corner functions
};

/// What two faces do to each other, for a pressure of 1 per length of depth.
struct Push {
  double energy = 0.0;      ///< [length^4]
  Vector on_a[4], on_b[4];  ///< minus its gradient: forces on the corners [length^3]
  double normal = 0.0;      ///< their sum on a, along the normal [length^3]
  double rate = 0.0;        ///< by how much that grows with the depth, about [length^2]
  double deep_area = 0.0;   ///< where a is behind b [length^2]
  double volume = 0.0;      ///< between the faces there [length^3]
  double wa[4], wb[4];      ///< mean corner functions of the volume between them; each sums to 1
};

/// Adds the forces of an energy that changes with the normal of a face.
/// @param x       corners; the normal is along the product of the diagonals [length]
/// @param unit    that normal
/// @param size    length of that product [length^2]
/// @param with_unit, with_size  change of the energy with both
void turn_back(const Vector x[4], const Vector& unit, double size, const Vector& with_unit, double with_size,
               Vector force[4]);

/// Two faces. The height of a face over the plane across the common normal is bilinear (triangles: linear).
class Overlap {
 public:
  /// Finds the polygon that both cover.
  /// @param a, b  corners; triangles repeat the third [length]
  /// @return false where they share nothing or do not look at each other
  bool share(const Vector a[4], const Vector b[4]);
  /// As share, and also false where a is nowhere behind b.
  bool meet(const Vector a[4], const Vector b[4]) { return share(a, b) && deepest() > 0.0; }

  const Vector& normal() const { return n_; }        ///< unit, from b to a
  double facing() const { return facing_; }          ///< minus the cosine between the normals
  double area() const { return area_; }              ///< of the polygon, across the normal [length^2]
  double deepest() const { return gap_[deepest_]; }  ///< a behind b, at the corners of the polygon [length]
  /// The shortest way by which they come apart: square to what lies at the deepest place (the face over a
  /// corner of the other, or two edges that cross), or along the plane over an edge; at least zero [length]
  double penetration() const;
  /// Values of the corner functions at the deepest place.
  void weights_there(double wa[4], double wb[4]) const;

  /// The energy, and the forces that are its gradient: the pressure along the normal of each face, what the
  /// edges of the polygon do when they move, and the turning of the common normal. So no motion around a
  /// closed path gains anything: exactly so for plane faces, to the order of the quadrature for those that
  /// are not. The forces sum to zero, and so do their moments. Constant depth over parallelograms and
  /// triangles is integrated exactly: a constant pressure between unlike meshes gives each node its
  /// consistent share (Puso & Laursen 2004, sec. 3).
  /// @param offset  the depth that counts as none [length]
  /// @return false where nothing is deeper than the offset
  bool push(const Springs& springs, double offset, Push& out);

  /// Quadrature points of the whole polygon, whatever the depth.
  void points(std::vector<SharedPoint>& out) const;

 private:
  static constexpr int of_b = 4;      // edges of a have their number, those of b theirs and this,
  static constexpr int of_depth = 8;  // and this is where the depth is that which counts as none
  static constexpr int batches = 2;   // of corners of the polygon
  static_assert(batches * base::lane_count >= Polygon::most);

  void balance(ShadowChange& a, ShadowChange& b) const;
  void to_corners(const ShadowChange& a, const ShadowChange& b, double with_facing, double with_la,
                  Push& out) const;

  const Vector *a_ = nullptr, *b_ = nullptr;
  Vector na_, nb_, n_, e1_, e2_;
  double la_ = 0.0, lb_ = 0.0, opening_ = 0.0;
  double facing_ = 0.0, area_ = 0.0;
  Shadow sa_, sb_;
  Polygon shared_;  // edges of a have their number, those of b theirs and four more
  alignas(64) double gap_[batches * base::lane_count];
  int deepest_ = 0;
};

}  // namespace cleave::solver
