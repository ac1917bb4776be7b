#include "model/material/hyperelastic.hpp"
#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

/// Compressible foam-like rubber, W = G/2 [I - 3 + (III^-beta - 1) / beta], beta = nu / (1 - 2 nu), with the
/// fixed nu = 0.463: sigma = G [b / J - J^(-1 / (1 - 2 nu)) 1].
/// Source: Blatz & Ko, Trans. Soc. Rheology 6 (1962) 223, with f = 1.
struct BlatzKo {
  static constexpr int state_size = 0, rotated_tensors = 0, plastic_strain = -1;
  static constexpr bool needs_F = true;
  static constexpr std::array<StateName, 0> state_names{};
  static constexpr double poisson = 0.463, exponent = 1.0 / (1.0 - 2.0 * poisson);  ///< of 1/J

  double modulus;  ///< G [stress]

  bool can_fail() const { return false; }
  double shear() const { return modulus; }
  double longitudinal() const { return modulus * 2.0 * (1.0 - poisson) * exponent; }
  void initialise(std::span<double>) const {}

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const Real inverse = Real(1.0) / p.volume_ratio, pressure = pow(inverse, Real(exponent));
    const auto left = left_cauchy_green(p.F);
    p.stress = Real(modulus) * (inverse * left - base::spherical(pressure));
    // lambda_i^2 W_ii / J = G [lambda_i^2 / J + (2 beta + 1) J^-(2 beta + 1)], 2 beta + 1 = exponent.
    p.modulus = Real(modulus) * (greatest_bound(left) * inverse + Real(exponent) * pressure);
    p.modulus = max(p.modulus, Real(longitudinal()));
  }
};

constexpr LawField fields[] = {
    {.name = "G", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "REF", .dimension = "-", .low = 0.0, .high = 0.0},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext&) {
  return std::make_unique<TiledLaw<BlatzKo>>(BlatzKo{.modulus = card["G"]});
}

}  // namespace

extern const LawEntry blatz_ko{"MAT_BLATZ-KO_RUBBER", fields, build, "Blatz & Ko 1962, f = 1"};

}  // namespace cleave::model
