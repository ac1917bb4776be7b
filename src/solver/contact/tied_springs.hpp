#pragma once
/// Springs that keep the distance of two sides (*CONTACT_TIED_..._OFFSET).

#include <vector>

#include "base/tensor.hpp"
#include "solver/contact/touch.hpp"

namespace cleave::solver {

/// One spring, with a Touch for its nodes and weights.
struct Spring {
  Touch touch;
  Vector rest;  ///< from b to a in the frame of b's face [length]
};

struct Frame3 {
  Vector e1, e2, n;
};
/// Axes that turn with a face.
Frame3 frame_of(std::span<const double> position, const Index node[4]);

/// Forces on the corners of a face that together are a moment alone: those of a rigid turn, f = w x r about
/// the middle of the corners. @return sums to 0 [force]
void couple_of(std::span<const double> position, const Index node[4], const Vector& moment,
               Vector (&force)[4]);
/// The largest force on each corner per unit of moment [1/length].
void couple_bound(std::span<const double> position, const Index node[4], double (&bound)[4]);

/// Springs at the quadrature points of every polygon that faces of both sides share, less than half an
/// element (or the distance of the card) apart; or from single nodes to their closest points. An error where
/// there is none, and no node that became a rigid body's.
std::vector<Spring> find_springs(const discretisation::World& world, const model::Contact& contact,
                                 const Surface& a, const Surface& b, deck::Diagnostics& diagnostics);

}  // namespace cleave::solver
