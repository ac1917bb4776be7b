#include "discretisation/spacetime/target_projection.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// s* = t, v* = v + Z^-1 (t - s).
template <int D>
class Traction final : public Target<D> {
 public:
  explicit Traction(VectorField<D> traction) : traction_(std::move(traction)) {}
  void star(const Interface<D>& facet, std::span<const Event<D>> at, std::span<const Traces<D>>,
            std::span<StarMap<D>> map, std::span<Star<D>> load) const override {
    const Matrix<D> fixed{};
    projected_map<D>(facet, fixed, map[0]);
    if (!traction_) return;
    for (std::size_t q = 0; q < at.size(); ++q)
      projected_load<D>(facet, fixed, {}, traction_(at[q]), load[q]);
  }

 private:
  VectorField<D> traction_;
};

}  // namespace

template <int D>
TargetPtr<D> make_traction(VectorField<D> traction) {
  return std::make_unique<Traction<D>>(std::move(traction));
}
template TargetPtr<1> make_traction<1>(VectorField<1>);
template TargetPtr<2> make_traction<2>(VectorField<2>);
template TargetPtr<3> make_traction<3>(VectorField<3>);

}  // namespace cleave::discretisation::spacetime
