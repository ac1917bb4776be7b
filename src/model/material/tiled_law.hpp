#pragma once
/// Turns the scalar description of a law into a Law that walks tiles of lanes.
///
/// A description is a struct with
///   static constexpr int state_size, rotated_tensors, plastic_strain; static constexpr bool needs_F,
///   can_fail; static constexpr std::array<StateName, n> state_names; double longitudinal() const, shear()
///   const; void initialise(std::span<double>) const; template <class P> void update(P& point) const;
/// `update` sets stress, state, modulus, and failed if it can fail. Energy is integrated here from the
/// mean stress over the step, unless the description does it itself (integrates_energy = true: laws with an
/// equation of state, where pressure depends on energy).

#include <utility>

#include "model/material/law.hpp"
#include "model/material/point.hpp"

namespace cleave::model {

namespace detail {

template <class Description>
concept IntegratesEnergy = requires {
  requires Description::integrates_energy;
};

}  // namespace detail

/// One point: update, then the energy of the step by the trapezoidal rule.
/// energy += (mean stress : strain increment) J_mid - q dJ.  [energy/reference volume]
template <class Description, class P>
void update_point(const Description& law, P& p) {
  using Real = typename P::Scalar;
  p.failed = Real(0.0);
  if constexpr (detail::IntegratesEnergy<Description>) {
    law.update(p);
  } else {
    const auto before = p.stress;
    law.update(p);
    const Real work = dot(before + p.stress, p.strain_increment) * Real(0.5);
    const Real volume = (p.volume_ratio + p.volume_ratio_before) * Real(0.5);
    p.energy = p.energy + work * volume - p.bulk_viscosity * (p.volume_ratio - p.volume_ratio_before);
  }
}

template <class Description>
class TiledLaw final : public Law {
 public:
  explicit TiledLaw(Description description) : law_(std::move(description)) {}

  int state_size() const override { return Description::state_size; }
  int rotated_tensors() const override { return Description::rotated_tensors; }
  bool needs_F() const override { return Description::needs_F; }
  bool can_fail() const override { return law_.can_fail(); }
  int plastic_strain() const override { return Description::plastic_strain; }
  std::vector<StateName> state_names() const override {
    return {Description::state_names.begin(), Description::state_names.end()};
  }
  void initialise(std::span<double> state) const override { law_.initialise(state); }
  double longitudinal_modulus() const override { return law_.longitudinal(); }
  double shear_modulus() const override { return law_.shear(); }
  const Description& description() const { return law_; }

  void update(const Tile& tile) const override {
    using base::Lanes, base::lane_count;
    constexpr int n = Description::state_size;
    for (int b = 0; b < tile.batch_count; ++b) {
      const auto at = [](const double* p, int component) { return Lanes::load(p + component * lane_count); };
      Point<Lanes, n> p;
      p.dt = tile.dt;
      p.time = tile.time;
      const double* e = tile.strain_increment + b * tile.scratch_stride_6;
      p.strain_increment = {at(e, 0), at(e, 1), at(e, 2), at(e, 3), at(e, 4), at(e, 5)};
      if constexpr (Description::needs_F) {
        const double* f = tile.deformation_gradient + b * tile.scratch_stride_9;
        for (int i = 0; i < 9; ++i) p.F.m[i / 3][i % 3] = at(f, i);
      }
      const std::ptrdiff_t one = b * tile.scratch_stride_1, record = b * tile.record_stride;
      p.volume_ratio = at(tile.volume_ratio + one, 0);
      p.volume_ratio_before = at(tile.volume_ratio_before + one, 0);
      p.bulk_viscosity = at(tile.bulk_viscosity + one, 0);
      p.length = at(tile.length + one, 0);
      double* s = tile.stress + record;
      p.stress = {at(s, 0), at(s, 1), at(s, 2), at(s, 3), at(s, 4), at(s, 5)};
      double* h = tile.state + record;
      for (int i = 0; i < n; ++i) p.state[i] = at(h, i);
      p.energy = at(tile.energy + record, 0);

      update_point(law_, p);

      const Lanes out[6] = {p.stress.xx, p.stress.yy, p.stress.zz, p.stress.xy, p.stress.yz, p.stress.zx};
      for (int i = 0; i < 6; ++i) out[i].store(s + i * lane_count);
      for (int i = 0; i < n; ++i) p.state[i].store(h + i * lane_count);
      p.energy.store(tile.energy + record);
      p.modulus.store(tile.modulus + one);
      p.failed.store(tile.failed + one);
    }
  }

 private:
  Description law_;
};

}  // namespace cleave::model
