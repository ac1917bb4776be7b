#pragma once
/// Where a block keeps what: records of points and of elements, and the memory of a tile.

#include "discretisation/fem/solid_element.hpp"
#include "model/material/law.hpp"

namespace cleave::discretisation::fem {

/// One integration point: stress, the law's state, energy per reference volume, J, modulus, bulk viscosity.
/// [component][lane]
struct PointLayout {
  int state_size = 0;
  static constexpr int stress = 0, state = 6;
  int energy() const { return 6 + state_size; }
  int volume_ratio() const { return 7 + state_size; }
  int modulus() const { return 8 + state_size; }
  int viscosity() const { return 9 + state_size; }
  int size() const { return 10 + state_size; }
};

/// One element: hourglass energy, cube root of the reference volume, reference volume of each point, then
/// what the element description keeps of its own.
struct ElementLayout {
  int point_count = 1;
  static constexpr int hourglass_energy = 0, reference_size = 1, reference_volume = 2;
  int own() const { return 2 + point_count; }
};

/// What one point of a batch hands to the law and gets back; the layout the law walks with strides.
template <class Real>
struct PointScratch {
  Real strain[6], F[9];
  Real volume_ratio, volume_ratio_before, length, modulus, failed;
  Real viscosity;       ///< at the end of the step, part of the total stress [stress]
  Real mean_viscosity;  ///< of its two ends: what the volume change of the step works against [stress]
};

/// The tile's view for the law: arrays inside PointScratch and inside the point records.
inline model::Tile law_tile(PointScratch<Lanes>* points, int count, double* record, const PointLayout& layout,
                            double dt, double time) {
  const auto in = [](Lanes& first) { return reinterpret_cast<double*>(&first); };
  constexpr std::ptrdiff_t stride = sizeof(PointScratch<Lanes>) / sizeof(double);
  model::Tile tile;
  tile.batch_count = count;
  tile.dt = dt;
  tile.time = time;
  tile.strain_increment = in(points->strain[0]);
  tile.deformation_gradient = in(points->F[0]);
  tile.volume_ratio = in(points->volume_ratio);
  tile.volume_ratio_before = in(points->volume_ratio_before);
  tile.bulk_viscosity = in(points->mean_viscosity);
  tile.length = in(points->length);
  tile.modulus = in(points->modulus);
  tile.failed = in(points->failed);
  tile.stress = record + PointLayout::stress * lane_count;
  tile.state = record + PointLayout::state * lane_count;
  tile.energy = record + layout.energy() * lane_count;
  tile.scratch_stride_6 = tile.scratch_stride_9 = tile.scratch_stride_1 = stride;
  tile.record_stride = layout.size() * lane_count;
  return tile;
}

/// Cube root of a ratio near one, by two steps of Halley's method from one: exact at one, 1e-6 between 1/2
/// and 2, 1e-2 between 1/10 and 10. It only measures sizes.
template <class Real>
Real near_cube_root(const Real& ratio) {
  const Real one(1.0), two(2.0);
  const Real r = (one + two * ratio) / (two + ratio);
  const Real cube = r * r * r;
  return r * (cube + two * ratio) / (two * cube + ratio);
}

}  // namespace cleave::discretisation::fem
