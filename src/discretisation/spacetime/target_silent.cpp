#include "discretisation/spacetime/target.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// The outgoing invariant s - Z v leaves, the incoming one s + Z v is that of the incident wave:
/// s* = (s - Z v + w) / 2.
template <int D>
class Silent final : public Target<D> {
 public:
  explicit Silent(VectorField<D> incident) : incident_(std::move(incident)) {}
  void star(const Interface<D>& facet, std::span<const Event<D>> at, std::span<const Traces<D>>,
            std::span<StarMap<D>> map, std::span<Star<D>> load) const override {
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) map[0].map[i][j] = -0.5 * facet.z_minus[i][j];
      map[0].map[i][D + i] = 0.5;
    }
    characteristic_velocities(facet, map[0]);
    if (!incident_) return;
    for (std::size_t q = 0; q < at.size(); ++q) {
      load[q].s = incident_(at[q]);
      for (double& s : load[q].s) s *= 0.5;
      characteristic_velocities(facet, load[q]);
    }
  }

 private:
  VectorField<D> incident_;
};

}  // namespace

template <int D>
TargetPtr<D> make_silent(VectorField<D> incident) {
  return std::make_unique<Silent<D>>(std::move(incident));
}
template TargetPtr<1> make_silent<1>(VectorField<1>);
template TargetPtr<2> make_silent<2>(VectorField<2>);
template TargetPtr<3> make_silent<3>(VectorField<3>);

}  // namespace cleave::discretisation::spacetime
