#include "discretisation/spacetime/target_projection.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// The velocity is held along the normal (symmetry) or along the tangents (antisymmetry); the face is free in
/// the other directions.
template <int D>
class Mirror final : public Target<D> {
 public:
  explicit Mirror(bool symmetric) : symmetric_(symmetric) {}
  void star(const Interface<D>& facet, std::span<const Event<D>>, std::span<const Traces<D>>,
            std::span<StarMap<D>> map, std::span<Star<D>>) const override {
    Matrix<D> fixed{};
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        const double normal = facet.n[i] * facet.n[j];
        fixed[i][j] = symmetric_ ? normal : (i == j ? 1.0 : 0.0) - normal;
      }
    projected_map<D>(facet, fixed, map[0]);
  }

 private:
  bool symmetric_;
};

}  // namespace

template <int D>
TargetPtr<D> make_symmetry() {
  return std::make_unique<Mirror<D>>(true);
}

template <int D>
TargetPtr<D> make_antisymmetry() {
  return std::make_unique<Mirror<D>>(false);
}
template TargetPtr<1> make_symmetry<1>();
template TargetPtr<2> make_symmetry<2>();
template TargetPtr<3> make_symmetry<3>();
template TargetPtr<1> make_antisymmetry<1>();
template TargetPtr<2> make_antisymmetry<2>();
template TargetPtr<3> make_antisymmetry<3>();

}  // namespace cleave::discretisation::spacetime
