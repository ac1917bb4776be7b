#pragma once
/// Turns the scalar description of a law into a Law that walks tiles of lanes.
///
/// A description is a struct with
///   static constexpr int state_size, rotated_tensors, plastic_strain; static constexpr bool needs_F;
///   static constexpr std::array<StateName, n> state_names; bool can_fail() const; double longitudinal()
///   const, shear() const; void initialise(std::span<double>) const; template <class P> void update(P& point)
///   const;
/// `update` sets stress, state, modulus, and failed if it can fail. Energy is integrated here from the
/// mean stress over the step, unless the description does it itself (integrates_energy = true: laws with an
/// equation of state, where pressure depends on energy). uses_pressure = true asks for Point::pressure.

#include <algorithm>
#include <type_traits>
#include <utility>

#include "base/dual.hpp"
#include "model/material/eos.hpp"
#include "model/material/law.hpp"
#include "model/material/point.hpp"

namespace cleave::model {

namespace detail {

template <class Description>
concept IntegratesEnergy = requires {
  requires Description::integrates_energy;
};

template <class Description>
concept UsesPressure = requires {
  requires Description::uses_pressure;
};

/// The value at one address of a tile: eight lanes, or one of them.
template <class Real>
Real load(const double* p, int lane) {
  if constexpr (std::is_same_v<Real, base::Lanes>) {
    return base::Lanes::load(p);
  } else {
    return Real(p[lane]);
  }
}
inline void store(const base::Lanes& a, double* p, int) {
  a.store(p);
}
inline void store(double a, double* p, int lane) {
  p[lane] = a;
}

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
  explicit TiledLaw(Description description, const PressureLaw* pressure = nullptr)
      : law_(std::move(description)), pressure_(pressure ? pressure->clone() : nullptr) {}

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

  // Flattened: at -O2 the compiler leaves small tensor functions as calls, which costs more than the law.
  [[gnu::flatten]] void update(const Tile& tile) const override {
    if constexpr (detail::UsesPressure<Description>) {
      PressureLine<base::Lanes> lines[batches_at_once];
      for (int first = 0; first < tile.batch_count; first += batches_at_once) {
        const int count = std::min(batches_at_once, tile.batch_count - first);
        pressure_->lines(count, tile.volume_ratio + first * tile.scratch_stride_1, tile.scratch_stride_1,
                         lines);
        for (int b = 0; b < count; ++b) move<base::Lanes>(tile, first + b, 0, lines[b]);
      }
    } else {
      for (int b = 0; b < tile.batch_count; ++b) move<base::Lanes>(tile, b, 0, {});
    }
  }

  void update_scalar(const Tile& tile) const override {
    for (int b = 0; b < tile.batch_count; ++b)
      for (int lane = 0; lane < base::lane_count; ++lane) {
        PressureLine<double> line{};
        if constexpr (detail::UsesPressure<Description>)
          line = pressure_->line(pressure_->initial_volume *
                                 tile.volume_ratio[b * tile.scratch_stride_1 + lane]);
        move<double>(tile, b, lane, line);
      }
  }

  void tangent(const Tile& tile, std::span<double> out) const override {
    constexpr int size = Description::needs_F ? 9 : 6;
    for (int b = 0; b < tile.batch_count; ++b)
      for (int lane = 0; lane < base::lane_count; ++lane) {
        auto p = load_point<base::Dual<size>>(tile, b, lane);
        vary(p);
        update_point(law_, p);
        const base::Dual<size> stress[6] = {p.stress.xx, p.stress.yy, p.stress.zz,
                                            p.stress.xy, p.stress.yz, p.stress.zx};
        for (int i = 0; i < 6; ++i)
          for (int j = 0; j < size; ++j)
            out[((b * 6 + i) * size + j) * base::lane_count + lane] = stress[i].partial[j];
      }
  }

 private:
  static constexpr int n = Description::state_size;
  static constexpr int batches_at_once = 8;

  template <class Real>
  static Point<Real, n> load_point(const Tile& tile, int b, int lane) {
    const auto at = [lane](const double* from, int component) {
      return detail::load<Real>(from + component * base::lane_count, lane);
    };
    const std::ptrdiff_t one = b * tile.scratch_stride_1, record = b * tile.record_stride;
    Point<Real, n> p;
    p.dt = tile.dt;
    p.time = tile.time;
    const double* e = tile.strain_increment + b * tile.scratch_stride_6;
    p.strain_increment = {at(e, 0), at(e, 1), at(e, 2), at(e, 3), at(e, 4), at(e, 5)};
    if constexpr (Description::needs_F) {
      const double* f = tile.deformation_gradient + b * tile.scratch_stride_9;
      for (int i = 0; i < 9; ++i) p.F.m[i / 3][i % 3] = at(f, i);
    }
    p.volume_ratio = at(tile.volume_ratio + one, 0);
    p.volume_ratio_before = at(tile.volume_ratio_before + one, 0);
    p.bulk_viscosity = at(tile.bulk_viscosity + one, 0);
    p.length = at(tile.length + one, 0);
    const double* s = tile.stress + record;
    p.stress = {at(s, 0), at(s, 1), at(s, 2), at(s, 3), at(s, 4), at(s, 5)};
    for (int i = 0; i < n; ++i) p.state[i] = at(tile.state + record, i);
    p.energy = at(tile.energy + record, 0);
    return p;
  }

  template <class Real>
  void move(const Tile& tile, int b, int lane, const PressureLine<Real>& line) const {
    auto p = load_point<Real>(tile, b, lane);
    p.pressure = line;
    update_point(law_, p);

    const std::ptrdiff_t one = b * tile.scratch_stride_1, record = b * tile.record_stride;
    const auto put = [lane](const Real& a, double* to, int component) {
      detail::store(a, to + component * base::lane_count, lane);
    };
    const Real stress[6] = {p.stress.xx, p.stress.yy, p.stress.zz, p.stress.xy, p.stress.yz, p.stress.zx};
    for (int i = 0; i < 6; ++i) put(stress[i], tile.stress + record, i);
    for (int i = 0; i < n; ++i) put(p.state[i], tile.state + record, i);
    put(p.energy, tile.energy + record, 0);
    put(p.modulus, tile.modulus + one, 0);
    put(p.failed, tile.failed + one, 0);
  }

  /// Makes the input of a point the independent variables of the tangent.
  template <int size>
  void vary(Point<base::Dual<size>, n>& p) const {
    using Real = base::Dual<size>;
    if constexpr (Description::needs_F) {
      for (int i = 0; i < 9; ++i) p.F.m[i / 3][i % 3].partial[i] = 1.0;
      p.volume_ratio = determinant(p.F);
    } else {
      auto& e = p.strain_increment;
      Real* component[6] = {&e.xx, &e.yy, &e.zz, &e.xy, &e.yz, &e.zx};
      for (int i = 0; i < 6; ++i) component[i]->partial[i] = 1.0;
      for (int i = 0; i < 3; ++i) p.volume_ratio.partial[i] = p.volume_ratio.value;
    }
    if constexpr (detail::UsesPressure<Description>) {
      const Real v = Real(pressure_->initial_volume) * p.volume_ratio;
      const auto line = pressure_->line(v.value);
      p.pressure = {Real::chain(v, line.cold, line.cold_slope),
                    Real::chain(v, line.thermal, line.thermal_slope), Real(line.cold_slope),
                    Real(line.thermal_slope)};
    }
  }

  Description law_;
  std::unique_ptr<const PressureLaw> pressure_;
};

}  // namespace cleave::model
