#include "discretisation/spacetime/target_projection.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// Velocity along some directions, traction along the others.
template <int D>
class Mixed final : public Target<D> {
 public:
  Mixed(const Matrix<D>& fixed, VectorField<D> velocity, VectorField<D> traction)
      : fixed_(fixed), velocity_(std::move(velocity)), traction_(std::move(traction)) {}
  void star(const Interface<D>& facet, std::span<const Event<D>> at, std::span<const Traces<D>>,
            std::span<StarMap<D>> map, std::span<Star<D>> load) const override {
    projected_map<D>(facet, fixed_, map[0]);
    for (std::size_t q = 0; q < at.size(); ++q) {
      const Vector<D> velocity = velocity_ ? velocity_(at[q]) : Vector<D>{};
      const Vector<D> traction = traction_ ? traction_(at[q]) : Vector<D>{};
      projected_load<D>(facet, fixed_, velocity, traction, load[q]);
    }
  }

 private:
  Matrix<D> fixed_;
  VectorField<D> velocity_, traction_;
};

}  // namespace

template <int D>
TargetPtr<D> make_mixed(std::array<bool, D> fixed, VectorField<D> velocity, VectorField<D> traction) {
  Matrix<D> projector{};
  for (int i = 0; i < D; ++i) projector[i][i] = fixed[i] ? 1.0 : 0.0;
  return make_projected<D>(projector, std::move(velocity), std::move(traction));
}

template <int D>
TargetPtr<D> make_projected(const Matrix<D>& fixed, VectorField<D> velocity, VectorField<D> traction) {
  return std::make_unique<Mixed<D>>(fixed, std::move(velocity), std::move(traction));
}
template TargetPtr<1> make_projected<1>(const Matrix<1>&, VectorField<1>, VectorField<1>);
template TargetPtr<2> make_projected<2>(const Matrix<2>&, VectorField<2>, VectorField<2>);
template TargetPtr<3> make_projected<3>(const Matrix<3>&, VectorField<3>, VectorField<3>);
template TargetPtr<1> make_mixed<1>(std::array<bool, 1>, VectorField<1>, VectorField<1>);
template TargetPtr<2> make_mixed<2>(std::array<bool, 2>, VectorField<2>, VectorField<2>);
template TargetPtr<3> make_mixed<3>(std::array<bool, 3>, VectorField<3>, VectorField<3>);

}  // namespace cleave::discretisation::spacetime
