#pragma once
/// The spacetime solution at one instant: sums over parts, values at vertices and at points inside simplices.

#include "discretisation/spacetime/exchange.hpp"
#include "discretisation/spacetime/front.hpp"

namespace cleave::discretisation::spacetime {

/// Integrals over one part at constant time, per unit of thickness.
template <int D>
struct PartSums {
  double mass = 0.0;      ///< [mass]
  Vector<D> momentum{};   ///< [mass length/time]
  double kinetic = 0.0;   ///< [energy]
  double internal = 0.0;  ///< strain energy [energy]
};

/// Values at a place and instant.
template <int D>
struct PlaceState {
  PointState<D> state;
  Vector<D> acceleration{};  ///< time derivative of the velocity polynomial [length/time^2]
  Voigt<D> stress{};         ///< [stress]
  double across = 0.0;       ///< stress across the plane, D = 2 [stress]
};

/// A plane of time through the solution that columns hold; at the start, before any element, the initial
/// state. Sums are taken in fixed order: their bits do not depend on the number of threads.
template <int D>
class Instant {
 public:
  /// The columns must hold every element that the plane cuts.
  Instant(const Body<D>& body, const Columns<D>& columns, double time)
      : body_(body), columns_(columns), time_(time) {}

  /// Exact integrals of the polynomials over the cut [part].
  std::vector<PartSums<D>> sums() const;
  /// All that was exchanged before. Exact on the boundary, see Outside for the dissipation.
  Exchange<D> exchanged(const Outside<D>& outside) const;
  /// Outside::reactions() of all elements.
  void reactions(const Outside<D>& outside, std::span<const char> wanted, std::span<Vector<D>> force) const;
  /// Total area (length, volume) of the cut; that of the body, if no element is missing.
  double volume() const;

  /// In simplex s at x, by the element whose cut it lies in; on the border between two, by the older one.
  PlaceState<D> at(Simplex s, const Point<D>& x) const;
  /// Mean of at() over the simplices around vertex v, by their volumes, where it stands in the undeformed
  /// mesh.
  PlaceState<D> at_vertex(Vertex v) const;

 private:
  template <class Visit>
  void each_piece(Simplex s, const Visit& visit) const;

  const Body<D>& body_;
  const Columns<D>& columns_;
  double time_;
};

}  // namespace cleave::discretisation::spacetime
