#pragma once
/// Equations of state: pressure from relative volume and energy, one file per equation.
///
/// Relative volume v = reference density / density, compression positive pressure, energy per reference
/// volume (v = 1). All equations here are linear in the energy, so that the energy of a step can be solved
/// for exactly. A description is a struct with
///   template <class Real> PressureLine<Real> line(const Real& v) const;

#include <memory>
#include <span>
#include <string_view>

#include "base/lanes.hpp"
#include "deck/card.hpp"
#include "model/material/law.hpp"
#include "model/material/pressure_line.hpp"

namespace cleave::model {

class PressureLaw {
 public:
  virtual ~PressureLaw() = default;
  virtual std::unique_ptr<PressureLaw> clone() const = 0;
  virtual PressureLine<double> line(double volume) const = 0;
  /// One virtual call per tile. @param volume relative volumes [batch], one stride apart from each other in
  /// doubles; @param out [batch].
  virtual void lines(int batch_count, const double* volume, std::ptrdiff_t stride,
                     PressureLine<base::Lanes>* out) const = 0;

  double initial_volume = 1.0;  ///< V0 [-]
  double initial_energy = 0.0;  ///< E0 [energy/reference volume]

  /// Isentropic bulk modulus in the initial state, -v dp/dv at constant entropy [stress].
  double bulk_modulus() const;
};

/// Turns the description of an equation into a PressureLaw.
template <class Description>
class TiledPressureLaw final : public PressureLaw {
 public:
  explicit TiledPressureLaw(Description description) : law_(description) {}

  std::unique_ptr<PressureLaw> clone() const override { return std::make_unique<TiledPressureLaw>(*this); }
  PressureLine<double> line(double volume) const override { return law_.line(volume); }
  void lines(int batch_count, const double* volume, std::ptrdiff_t stride,
             PressureLine<base::Lanes>* out) const override {
    const base::Lanes start(initial_volume);
    for (int b = 0; b < batch_count; ++b) out[b] = law_.line(start * base::Lanes::load(volume + b * stride));
  }

 private:
  Description law_;
};

/// Catalogue entry of an equation of state: one file, one line in eos_catalogue.inc.
struct PressureEntry {
  std::string_view keyword;          ///< canonical, e.g. "EOS_GRUNEISEN"
  std::span<const LawField> fields;  ///< honoured; other given fields are reported
  /// @param density of the material, RO [mass/length^3]. Null after an error.
  std::unique_ptr<PressureLaw> (*build)(const deck::Card& card, double density,
                                        deck::Diagnostics& diagnostics);
  std::string_view source;
};

std::span<const PressureEntry* const> pressure_catalogue();
const PressureEntry* find_pressure_law(std::string_view keyword);  ///< null when there is none

}  // namespace cleave::model
