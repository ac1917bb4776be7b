#include "model/material/tiled_law.hpp"

namespace cleave::model {
namespace {

/// Isotropic hypoelasticity: objective stress rate = C : D.
/// Source: Belytschko, Liu & Moran, Nonlinear Finite Elements (2000), eq. 5.4.21.
struct Elastic {
  static constexpr int state_size = 0, rotated_tensors = 0, plastic_strain = -1;
  static constexpr bool needs_F = false;
  static constexpr std::array<StateName, 0> state_names{};

  double bulk_modulus, shear_modulus;  ///< [stress]

  bool can_fail() const { return false; }
  double longitudinal() const { return bulk_modulus + 4.0 / 3.0 * shear_modulus; }
  double shear() const { return shear_modulus; }
  void initialise(std::span<double>) const {}

  template <class P>
  void update(P& p) const {
    using Real = typename P::Scalar;
    const auto& e = p.strain_increment;
    p.stress = p.stress + Real(2.0 * shear_modulus) * e +
               base::spherical(Real(bulk_modulus - 2.0 / 3.0 * shear_modulus) * trace(e));
    p.modulus = Real(longitudinal());
  }
};

constexpr LawField fields[] = {
    {.name = "E", .dimension = "stress", .low = 0.0, .low_open = true, .required = true},
    {.name = "PR", .dimension = "-", .low = -1.0, .high = 0.5, .low_open = true, .high_open = true},
};

std::unique_ptr<Law> build(const deck::Card& card, const LawContext&) {
  const double e = card["E"], nu = card["PR"];
  return std::make_unique<TiledLaw<Elastic>>(
      Elastic{.bulk_modulus = e / (3.0 * (1.0 - 2.0 * nu)), .shear_modulus = e / (2.0 * (1.0 + nu))});
}

}  // namespace

extern const LawEntry elastic{.keyword = "MAT_ELASTIC",
                              .fields = fields,
                              .build = build,
                              .source = "Belytschko, Liu & Moran 2000, eq. 5.4.21",
                              .harmless = "DA DB"};

}  // namespace cleave::model
