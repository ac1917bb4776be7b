#include "discretisation/spacetime/target.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// The two invariants that travel towards the facet, s- - Z- v- and s+ + Z+ v+, determine the common velocity
/// and traction. The impedances are matrices, which need not commute.
template <int D>
class Bonded final : public Target<D> {
 public:
  void star(const Interface<D>& facet, std::span<const Event<D>>, std::span<const Traces<D>>,
            std::span<StarMap<D>> map, std::span<Star<D>>) const override {
    Matrix<D> sum{};
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) sum[i][j] = facet.z_minus[i][j] + facet.z_plus[i][j];
    const Matrix<D> mobility = inverse<D>(sum);
    auto& m = map[0].map;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        double minus = 0.0, plus = 0.0;
        for (int k = 0; k < D; ++k)
          minus += mobility[i][k] * facet.z_minus[k][j], plus += mobility[i][k] * facet.z_plus[k][j];
        for (int side = 1; side <= 2; ++side) {
          auto& row = m[side * D + i];
          row[j] = minus, row[D + j] = -mobility[i][j], row[2 * D + j] = plus,
          row[3 * D + j] = mobility[i][j];
        }
      }
    for (int i = 0; i < D; ++i) {
      m[i][D + i] = 1.0;
      for (int k = 0; k < D; ++k) {
        for (int c = 0; c < 4 * D; ++c) m[i][c] += facet.z_minus[i][k] * m[D + k][c];
        m[i][k] -= facet.z_minus[i][k];
      }
    }
  }
};

}  // namespace

template <int D>
TargetPtr<D> make_bonded() {
  return std::make_unique<Bonded<D>>();
}
template TargetPtr<1> make_bonded<1>();
template TargetPtr<2> make_bonded<2>();
template TargetPtr<3> make_bonded<3>();

}  // namespace cleave::discretisation::spacetime
