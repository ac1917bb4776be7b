#pragma once
/// The two passes over a batch of solid elements, before and after the law. Templates on Real.

#include "discretisation/fem/point_record.hpp"
#include "discretisation/fem/viscosity.hpp"
#include "discretisation/formulation.hpp"

namespace cleave::discretisation::fem {

/// What is the same for all elements of a block.
struct SolidOptions {
  double density = 0.0;     ///< reference [mass/length^3]
  double shear = 0.0;       ///< reference shear modulus, for damping and hourglass forms [stress]
  int rotated_tensors = 0;  ///< of the law's state
  bool needs_F = false;
  BulkCoefficients bulk;
  StiffnessDamping damping;
};

/// Options of the part's material and viscosities.
inline SolidOptions solid_options(const PartElements& elements) {
  const auto& part = elements.model.parts[static_cast<std::size_t>(elements.part)];
  return {.density = part.density,
          .shear = part.law->shear_modulus(),
          .rotated_tensors = part.law->rotated_tensors(),
          .needs_F = part.law->needs_F(),
          .bulk = {part.hourglass.quadratic_bulk, part.hourglass.linear_bulk},
          .damping = {part.stiffness_damping}};
}

/// What the strain pass leaves for the force pass, per batch, besides the PointScratch of each point.
template <class Real, class Element>
struct Kept {
  typename Element::template Carried<Real> carried;
  Real rate[Element::point_count];  ///< trace of D [1/time]
  Real volume, size, length, least;
};

/// Records of one batch.
template <class Real>
struct BatchRecords {
  Record<Real> point;  ///< of the first point
  Record<Real> element;
};

/// Before the law: motion of the points, stress turned with the body, viscosity.
/// @param active  lanes of living elements; the others are frozen where they were
/// @param point   [point] of the batch
/// @param means   null unless the element takes averages at its nodes
template <class Real, class Element, class Truth>
void strain_pass(const Element& element, const SolidOptions& options, const PointLayout& layout,
                 const Vec3<Real>* x, const Vec3<Real>* v, double dt, const BatchRecords<Real>& records,
                 Truth active, Kept<Real, Element>& kept, PointScratch<Real>* point,
                 const NodeMeans<Real>* means = nullptr) {
  constexpr int points = Element::point_count;
  const ElementLayout own{points};
  Real reference_volume[points];
  for (int p = 0; p < points; ++p)
    reference_volume[p] = records.element.get(ElementLayout::reference_volume + p);

  ElementMotion<Real, points> motion;
  element.strain(ElementInput<Real>{x, v, reference_volume, dt, options.needs_F, means},
                 records.element.from(own.own()), motion, kept.carried);
  const Real zero(0.0), one(1.0);
  const bool everyone = all(active);
  kept.volume = motion.volume;
  kept.length = motion.length;
  kept.least = motion.least;
  Real total = reference_volume[0];
  for (int p = 1; p < points; ++p) total = total + reference_volume[p];
  const Real size = records.element.get(ElementLayout::reference_size);
  kept.size = size * near_cube_root(select(active, motion.volume / total, one));

  StepRotation<Real> rotation[points];
  const Real per_time(dt > 0.0 ? 1.0 / dt : 0.0), per_density(1.0 / options.density);
  for (int p = 0; p < points; ++p) {
    auto& at = motion.point[p];
    const Record<Real> record = records.point.from(p * layout.size());
    PointScratch<Real>& out = point[p];
    out.volume_ratio_before = record.get(layout.volume_ratio());
    if (!everyone) {
      for (auto& line : at.gradient.m)
        for (Real& entry : line) entry = select(active, entry, zero);
      at.volume_ratio = select(active, at.volume_ratio, out.volume_ratio_before);
    }

    // Turn what belongs to the material; the strain is that of the middle of the step and turns half way.
    rotation[p] = step_rotation(spin(at.gradient));
    const auto strain = rotate(rotation[p].half, symmetric_part(at.gradient));
    out.strain[0] = strain.xx;
    out.strain[1] = strain.yy;
    out.strain[2] = strain.zz;
    out.strain[3] = strain.xy;
    out.strain[4] = strain.yz;
    out.strain[5] = strain.zx;
    set_tensor(record, PointLayout::stress,
               rotate(rotation[p].whole, get_tensor(record, PointLayout::stress)));
    for (int t = 0; t < options.rotated_tensors; ++t)
      set_tensor(record, PointLayout::state + 6 * t,
                 rotate(rotation[p].whole, get_tensor(record, PointLayout::state + 6 * t)));

    // rho c^2 = modulus, so rho c = sqrt(rho modulus).
    kept.rate[p] = trace(symmetric_part(at.gradient)) * per_time;
    const Real modulus = record.get(layout.modulus());
    const Real density = Real(options.density) / at.volume_ratio;
    const Real speed = sqrt(modulus * at.volume_ratio * per_density);
    out.volume_ratio = at.volume_ratio;
    out.viscosity = bulk_viscosity(options.bulk, density, motion.length, speed, kept.rate[p]);
    out.mean_viscosity = Real(0.5) * (record.get(layout.viscosity()) + out.viscosity);
    record.set(layout.viscosity(), out.viscosity);
    out.length = kept.size;
    record.set(layout.volume_ratio(), at.volume_ratio);
    if (options.needs_F)
      for (int i = 0; i < 9; ++i) out.F[i] = at.F.m[i / 3][i % 3];
  }
  element.turn(rotation, records.element.from(own.own()), kept.carried);
}

/// What the force pass answers besides forces.
template <class Real>
struct ForceAnswer {
  Real stable_step;  ///< [time]
  Real failed;       ///< how many points ask for deletion
  Real internal;     ///< internal energy of the element [energy]
  Real hourglass;    ///< hourglass energy of the element since the start [energy]
  Real damping;      ///< dissipated by stiffness damping in the step [energy]
};

/// After the law: total stress, nodal forces (internal), energies, stable step.
template <class Real, class Element>
void force_pass(const Element& element, const SolidOptions& options, const PointLayout& layout, double dt,
                const BatchRecords<Real>& records, Kept<Real, Element>& kept, const PointScratch<Real>* point,
                Vec3<Real>* force, ForceAnswer<Real>& answer) {
  constexpr int points = Element::point_count;
  const ElementLayout own{points};
  const Real per_time(dt > 0.0 ? 1.0 / dt : 0.0);
  ElementAnswer<Real, points> e;
  e.volume = kept.volume;
  e.size = kept.size;
  e.shear = Real(options.shear);
  e.dt = dt;

  // The stiffest point and the strongest compression decide the step.
  Real ratio(0.0), modulus = point[0].modulus, rate = kept.rate[0];
  answer.failed = Real(0.0);
  for (int p = 0; p < points; ++p) {
    ratio = ratio + point[p].volume_ratio * Real(1.0 / points);
    modulus = max(modulus, point[p].modulus);
    rate = min(rate, kept.rate[p]);
    answer.failed = answer.failed + point[p].failed;
  }
  e.density = Real(options.density) / ratio;
  e.modulus = modulus;
  const Real speed = sqrt(modulus / e.density);
  answer.stable_step = stable_step(options.bulk, kept.length, speed, rate);

  Real beta(0.0);
  answer.internal = Real(0.0);
  answer.damping = Real(0.0);
  if (options.damping.active()) {
    beta = options.damping.beta(kept.length / speed);
    answer.stable_step = answer.stable_step * StiffnessDamping::reduction(beta, kept.length / speed);
  }
  for (int p = 0; p < points; ++p) {
    const Record<Real> record = records.point.from(p * layout.size());
    const PointScratch<Real>& in = point[p];
    const Real reference_volume = records.element.get(ElementLayout::reference_volume + p);
    record.set(layout.modulus(), in.modulus);
    e.stress[p] = get_tensor(record, PointLayout::stress) - base::spherical(in.viscosity);
    answer.internal = answer.internal + record.get(layout.energy()) * reference_volume;
    if (options.damping.active()) {
      const Sym3<Real> strain{in.strain[0], in.strain[1], in.strain[2],
                              in.strain[3], in.strain[4], in.strain[5]};
      const auto viscous = viscous_stress(beta, in.modulus, e.shear, per_time * strain);
      e.stress[p] = e.stress[p] + viscous;
      answer.damping = answer.damping + dot(viscous, strain) * in.volume_ratio * reference_volume;
    }
  }
  Real work;
  element.force(e, records.element.from(own.own()), kept.carried, force, work);
  answer.hourglass = records.element.get(ElementLayout::hourglass_energy) + work;
  records.element.set(ElementLayout::hourglass_energy, answer.hourglass);
}

}  // namespace cleave::discretisation::fem
