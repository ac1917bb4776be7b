#pragma once
/// Target (starred) values: what is imposed weakly on a facet that contains the pole.
///
/// One file per kind: a class derived from Target and one function that makes it, declared below. All but the
/// patch solver's own treatment of inflow, outflow and tilted facets goes through this door.
/// Equations: section "Star values" of docs/spacetime-numerics.md.

#include <functional>
#include <memory>
#include <span>

#include "discretisation/spacetime/elastic.hpp"

namespace cleave::discretisation::spacetime {

/// A vertical facet. n points from side minus to side plus; on the boundary there is no side plus and n is
/// the outward normal. Tractions s = sigma n use the same n on both sides.
template <int D>
struct Interface {
  Vector<D> n;
  const Elastic<D>* minus = nullptr;
  const Elastic<D>* plus = nullptr;  ///< null on the boundary
  Matrix<D> z_minus{}, z_plus{};     ///< impedances along n
};

/// Traces of the bulk fields at a point of a facet: velocity, traction, displacement of both sides.
template <int D>
struct Traces {
  Vector<D> v_minus{}, s_minus{}, u_minus{};
  Vector<D> v_plus{}, s_plus{}, u_plus{};
};

/// Star values: one traction, the velocities of the two sides.
template <int D>
struct Star {
  Vector<D> s{}, v_minus{}, v_plus{};
};

/// The linear dependence of the star values on the traces:
/// (s*, v*-, v*+) = map (v-, s-, v+, s+) + load.
template <int D>
struct StarMap {
  Matrix<3 * D, 4 * D> map{};
  Star<D> apply(const Traces<D>& traces, const Star<D>& load) const;
};

template <int D>
class Target {
 public:
  virtual ~Target() = default;

  /// The star values as affine functions of the traces. They must agree with the characteristic that leaves
  /// each side, s* - Z v* = s - Z v with the side's outward normal, in map and load alike: the patch solver
  /// relies on it and reads the velocities of the star state alone (characteristic_velocities() sees to it).
  /// @param at   the quadrature points
  /// @param now  traces at the points in the iterate before; zeros in the first. Linear targets ignore them
  /// @param map  a linear target fills one; a nonlinear one fills one per point, its linearisation at `now`
  /// @param load [points] the part that does not depend on the traces, zero on entry
  virtual void star(const Interface<D>& facet, std::span<const Event<D>> at, std::span<const Traces<D>> now,
                    std::span<StarMap<D>> map, std::span<Star<D>> load) const = 0;

  /// A nonlinear target makes the patch solver iterate until the star tractions stop changing.
  virtual bool linear() const { return true; }
};

template <int D>
using TargetPtr = std::unique_ptr<const Target<D>>;
/// A vector that varies over the boundary and in time.
template <int D>
using VectorField = std::function<Vector<D>(const Event<D>&)>;

/// Fills `map` with the star velocities that belong to a given star traction on each side, characteristic
/// rule (4.3) of the specification; the rows of s* must be set. `load` gets the part due to load.s.
template <int D>
void characteristic_velocities(const Interface<D>& facet, StarMap<D>& map);
template <int D>
void characteristic_velocities(const Interface<D>& facet, Star<D>& load);

/// Interior facet, perfect bond: the exact Riemann solution for two elastic materials, isotropic or not
/// (4.1).
template <int D>
TargetPtr<D> make_bonded();
/// Prescribed traction [stress]; an empty field is a free face.
template <int D>
TargetPtr<D> make_traction(VectorField<D> traction);
/// Prescribed velocity [length/time]; a displacement history enters as its rate, see make_displacement.
template <int D>
TargetPtr<D> make_velocity(VectorField<D> velocity);
/// Prescribed displacement [length]: `rate` is its time derivative. The displacement itself enters through
/// the initial data, which must agree with it.
template <int D>
TargetPtr<D> make_displacement(VectorField<D> rate);
/// Symmetry plane: no normal velocity, no shear traction.
template <int D>
TargetPtr<D> make_symmetry();
/// Antisymmetry plane: no tangential velocity, no normal traction.
template <int D>
TargetPtr<D> make_antisymmetry();
/// Component by component in the axes: `fixed[i]` prescribes velocity component i, else traction component i.
template <int D>
TargetPtr<D> make_mixed(std::array<bool, D> fixed, VectorField<D> velocity, VectorField<D> traction);
/// The same along any directions: `fixed` projects on those of prescribed velocity.
template <int D>
TargetPtr<D> make_projected(const Matrix<D>& fixed, VectorField<D> velocity, VectorField<D> traction);
/// Transmitting boundary; `incident` gives the characteristic s + Z v of a wave coming in, with the outward
/// normal, empty for a quiet exterior [stress]. Exact for normal incidence.
template <int D>
TargetPtr<D> make_silent(VectorField<D> incident);

}  // namespace cleave::discretisation::spacetime
