#pragma once
/// A constitutive law: one virtual call per tile of points, templates on the value type inside.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/lanes.hpp"
#include "deck/card.hpp"
#include "model/curve.hpp"

namespace cleave::model {

/// Points of one law, in batches of eight. Every array is [batch][component][lane], 64-byte aligned.
/// The strides count doubles from one batch to the next, so arrays may lie inside larger records.
struct Tile {
  int batch_count = 0;
  double dt = 0.0, time = 0.0;
  const double* strain_increment = nullptr;                ///< 6 components
  const double* deformation_gradient = nullptr;            ///< 9, row-major; may be null unless needs_F
  const double* volume_ratio = nullptr;                    ///< 1
  const double* volume_ratio_before = nullptr;             ///< 1
  const double* bulk_viscosity = nullptr;                  ///< 1
  const double* length = nullptr;                          ///< 1
  double* stress = nullptr;                                ///< 6
  double* state = nullptr;                                 ///< state_size
  double* energy = nullptr;                                ///< 1
  double* modulus = nullptr;                               ///< 1, out
  double* failed = nullptr;                                ///< 1, out
  std::ptrdiff_t scratch_stride_6 = 6 * base::lane_count;  ///< of strain_increment
  std::ptrdiff_t scratch_stride_9 = 9 * base::lane_count;
  std::ptrdiff_t scratch_stride_1 = base::lane_count;  ///< of the one-component scratch arrays
  std::ptrdiff_t record_stride = 0;                    ///< of stress, state and energy: the point record
};

/// One history variable, for output by name.
struct StateName {
  std::string_view name;
  int first = 0, size = 1;
};

class Law {
 public:
  virtual ~Law() = default;
  virtual int state_size() const = 0;
  virtual int rotated_tensors() const = 0;  ///< the first so many groups of 6 state values turn with the body
  virtual bool needs_F() const = 0;
  virtual bool can_fail() const = 0;  ///< may it ever answer failed = 1?
  virtual std::vector<StateName> state_names() const = 0;
  /// Index of the effective plastic strain in the state, -1 if the law has none.
  virtual int plastic_strain() const = 0;
  /// Start values of one point's state (size state_size).
  virtual void initialise(std::span<double> state) const = 0;
  virtual void update(const Tile& tile) const = 0;
  /// The same, point by point in plain doubles: what lanes are checked against.
  virtual void update_scalar(const Tile& tile) const = 0;
  /// Derivative of the updated stress; moves nothing. With respect to the strain increment (the volume ratio
  /// follows its trace), or to the deformation gradient if the law needs it.
  /// @param out [batch][6 times 6 or 9, row-major][lane] [stress]
  virtual void tangent(const Tile& tile, std::span<double> out) const = 0;
  virtual double longitudinal_modulus() const = 0;  ///< in the reference state, K + 4G/3 [stress]
  virtual double shear_modulus() const = 0;         ///< in the reference state [stress]
  virtual double bulk_modulus() const { return longitudinal_modulus() - 4.0 / 3.0 * shear_modulus(); }
  /// How many points of an element must answer failed = 1 before it is deleted.
  virtual int failed_points_needed() const { return 1; }
};

class PressureLaw;  ///< equation of state, see eos.hpp

/// What a law's builder may ask for besides its card.
struct LawContext {
  const std::vector<Curve>& curves;
  const std::vector<Table>& tables;
  const PressureLaw* pressure = nullptr;  ///< equation of state of the part, null for none
  deck::Diagnostics& diagnostics;
  Id function_offset = 0;  ///< of the included file the card stands in (*INCLUDE_TRANSFORM IDFOFF)

  const Curve* curve(Id id) const;  ///< by the number on the card; null when absent
  const Table* table(Id id) const;
};

/// A field of the keyword the law honours, with its admissible range.
struct LawField {
  std::string_view name;
  std::string_view dimension;
  double low = -1e300, high = 1e300;  ///< exclusive bounds where `low_open`/`high_open`
  bool low_open = false, high_open = false;
  bool required = false;
};

/// Catalogue entry of a law: one file, one line in catalogue.inc.
struct LawEntry {
  std::string_view keyword;          ///< canonical, e.g. "MAT_ELASTIC"
  std::span<const LawField> fields;  ///< honoured; other given fields are reported
  std::unique_ptr<Law> (*build)(const deck::Card& card, const LawContext& context);
  std::string_view source;      ///< paper and equation
  bool needs_pressure = false;  ///< refuses a part without an equation of state
  bool takes_pressure = false;  ///< honours one if given
  std::string_view harmless{};  ///< fields that act on shells or beams only, blank between
};

std::span<const LawEntry* const> law_catalogue();
const LawEntry* find_law(std::string_view keyword);  ///< null when there is none

}  // namespace cleave::model
