#include "discretisation/spacetime/target_projection.hpp"

namespace cleave::discretisation::spacetime {
namespace {

template <int D>
Matrix<D> identity() {
  Matrix<D> one{};
  for (int i = 0; i < D; ++i) one[i][i] = 1.0;
  return one;
}

/// v* = v prescribed, s* = s + Z (v* - v).
template <int D>
class Velocity final : public Target<D> {
 public:
  explicit Velocity(VectorField<D> velocity) : velocity_(std::move(velocity)) {}
  void star(const Interface<D>& facet, std::span<const Event<D>> at, std::span<const Traces<D>>,
            std::span<StarMap<D>> map, std::span<Star<D>> load) const override {
    const Matrix<D> fixed = identity<D>();
    projected_map<D>(facet, fixed, map[0]);
    if (!velocity_) return;
    for (std::size_t q = 0; q < at.size(); ++q)
      projected_load<D>(facet, fixed, velocity_(at[q]), {}, load[q]);
  }

 private:
  VectorField<D> velocity_;
};

}  // namespace

template <int D>
TargetPtr<D> make_velocity(VectorField<D> velocity) {
  return std::make_unique<Velocity<D>>(std::move(velocity));
}

template <int D>
TargetPtr<D> make_displacement(VectorField<D> rate) {
  return make_velocity<D>(std::move(rate));
}
template TargetPtr<1> make_velocity<1>(VectorField<1>);
template TargetPtr<2> make_velocity<2>(VectorField<2>);
template TargetPtr<3> make_velocity<3>(VectorField<3>);
template TargetPtr<1> make_displacement<1>(VectorField<1>);
template TargetPtr<2> make_displacement<2>(VectorField<2>);
template TargetPtr<3> make_displacement<3>(VectorField<3>);

}  // namespace cleave::discretisation::spacetime
