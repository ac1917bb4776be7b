#pragma once
/// The surface of a rigid wall of simple geometry, and how a step of a node meets it.

#include <optional>
#include <vector>

#include "model/load.hpp"

namespace cleave::solver {

/// A wall is what lies behind all of its faces: planes, and the round face of a cylinder or sphere. The
/// hollow of a cylinder or sphere has a round face alone, which looks inward. Places are relative to the
/// wall's origin, and follow it when it moves.
class WallShape {
 public:
  using Vector = model::Vector;

  explicit WallShape(const model::RigidWall& wall);

  /// What a step runs into.
  struct Hit {
    Vector normal;  ///< outward, where the step enters
    double push;    ///< from the end of the step along the normal to the surface, above 0 [length]
    std::size_t face;
    double level;  ///< of the surface that holds the node: 0, or below where it was behind from the start
  };
  /// The surface that a straight step from one place to another enters: the one it passes last, as the wall
  /// is convex. A place within rounding of the surface is on it. A place behind it keeps its depth: it may
  /// leave but not go deeper; behind a wall that ends (a rectangle, a piece of a hollow cylinder) it is free.
  std::optional<Hit> enters(const Vector& from, const Vector& to) const;

  /// How far from a place along the normal of a hit to the surface it is held by; may be below zero [length].
  double push(const Hit& hit, const Vector& place) const;

  /// Distance behind the surface, 0 outside [length].
  double depth(const Vector& place) const;
  /// Does it hold every node that is behind it?
  bool endless() const { return !ends_; }

 private:
  /// In front of a face is where its measure is positive: n . x - offset, or the distance from the middle (of
  /// a sphere) or axis less the radius; the other way round inside.
  struct Face {
    bool round = false;
    Vector normal{0, 0, 1};  ///< of a plane
    double offset = 0.0;
  };

  double measure(const Face& face, const Vector& place) const;
  double measure(const Vector& place) const;  ///< the largest of all faces
  /// Part of the step after which a round face is passed, 0 if it begins behind it.
  double passed(const Vector& from, const Vector& step, double radius) const;
  Vector normal(const Face& face, const Vector& place) const;
  Vector across(const Vector& place) const;  ///< from the axis of a cylinder, the middle of a sphere
  bool within(const Vector& place) const;    ///< the ends of a wall that ends

  const model::RigidWall& wall_;
  std::vector<Face> faces_;
  bool ends_ = false;
  double close_ = 0.0;  ///< what counts as rounding [length]
};

}  // namespace cleave::solver
