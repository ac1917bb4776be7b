/// Plane waves that come in through silent faces.

#include "discretisation/spacetime/body_wave.hpp"

#include "discretisation/spacetime/body_steps.hpp"

namespace cleave::discretisation::spacetime {

/// u = g(t - d.x / c) p, so that v = g' p and E = -sym(g' p d) / c; the stress of the wave, sigma_dd of a
/// pressure wave and sigma_dp of a shear wave, is -rho c g'.
template <int D>
VectorField<D> incident_characteristic(const model::IncidentWave& wave, History stress,
                                       const Elastic<D>& material, const Vector<D>& normal) {
  const bool shear = wave.kind == model::IncidentWave::Kind::shear;
  const model::Vector &moves = shear ? wave.polarisation : wave.direction, &along = wave.direction;
  const double p[] = {moves.x, moves.y, moves.z}, d[] = {along.x, along.y, along.z},
               x0[] = {wave.reference.x, wave.reference.y, wave.reference.z};
  Vector<D> direction;
  for (std::size_t k = 0; k < D; ++k) direction[k] = d[k];
  const double speed = material.speeds(direction)[shear ? 0 : D - 1], impedance = material.density * speed;

  // Velocity, strain and characteristic s + Z v of a unit stress.
  Vector<D> v;
  Voigt<D> strain{};
  for (int i = 0; i < D; ++i) {
    v[i] = -p[i] / impedance;
    for (int j = 0; j <= i; ++j)
      strain[voigt<D>(i, j)] = 0.5 * (p[i] * d[j] + p[j] * d[i]) / (impedance * speed);
  }
  const Voigt<D> sigma = material.stress(strain);
  const Matrix<D> z = material.impedance(normal);
  Vector<D> incoming{};
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) incoming[i] += sigma[voigt<D>(i, j)] * normal[j] + z[i][j] * v[j];

  Vector<D> slowness, reference;
  for (std::size_t k = 0; k < D; ++k) slowness[k] = d[k] / speed, reference[k] = x0[k];
  return [=](const Event<D>& y) {
    double time = y[D];
    for (std::size_t k = 0; k < D; ++k) time -= slowness[k] * (y[k] - reference[k]);
    const double size = stress(time);
    Vector<D> w;
    for (std::size_t k = 0; k < D; ++k) w[k] = size * incoming[k];
    return w;
  };
}

#define CLEAVE_INSTANTIATE(D)                                                                                \
  template VectorField<D> incident_characteristic<D>(const model::IncidentWave&, History, const Elastic<D>&, \
                                                     const Vector<D>&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
