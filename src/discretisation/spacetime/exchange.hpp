#pragma once
/// What passes between a body and the outside: work and impulse of its boundary and of its body force.

#include "discretisation/spacetime/columns.hpp"

namespace cleave::discretisation::spacetime {

/// Const and without scratch: any thread may ask.
template <int D>
class Outside {
 public:
  /// The body must outlive it.
  explicit Outside(const Body<D>& body);

  /// Over the part of an element before time t; over all of it if it ends before. The numerical dissipation
  /// is that of the whole element times the share of its volume.
  Exchange<D> before(Simplex s, const SolvedElement<D>& element, double t) const;

  /// Force of the outside on the body at time t, by the corners of the boundary faces of an element that the
  /// plane of time cuts: the star traction times the linear function that is 1 at the corner. Per unit of
  /// thickness; adds to `force`.
  /// @param wanted [boundary face] which faces count
  /// @param force  [vertex]
  void reactions(Simplex s, const SolvedElement<D>& element, double t, std::span<const char> wanted,
                 std::span<Vector<D>> force) const;

 private:
  struct Facet {
    std::array<Event<D>, D + 1> corner;
    std::array<double, D + 1> time;
    std::int32_t face;  ///< of the boundary
    double measure;     ///< [length^(D-1) time]
  };
  template <class Visit>
  void each_facet(const SolvedElement<D>& element, const Visit& visit) const;
  /// Star values at events of a boundary face.
  void star(const SolvedElement<D>& element, std::int32_t face, std::span<const Event<D>> at,
            std::span<Star<D>> values) const;

  const Body<D>& body_;
  std::vector<Matrix<D>> impedance_;  ///< [boundary face]
};

}  // namespace cleave::discretisation::spacetime
