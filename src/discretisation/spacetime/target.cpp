#include "discretisation/spacetime/target.hpp"

#include "discretisation/spacetime/target_projection.hpp"

namespace cleave::discretisation::spacetime {
namespace {

template <int D>
Matrix<D> product(const Matrix<D>& a, const Matrix<D>& b) {
  Matrix<D> c{};
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < D; ++k)
      for (int j = 0; j < D; ++j) c[i][j] += a[i][k] * b[k][j];
  return c;
}

template <int D>
Vector<D> product(const Matrix<D>& a, const Vector<D>& x) {
  Vector<D> y{};
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < D; ++k) y[i] += a[i][k] * x[k];
  return y;
}

/// P (P Y P + 1 - P)^-1 P: from a velocity defect along the fixed directions to the traction that mends it.
template <int D>
Matrix<D> stiffened(const Matrix<D>& fixed, const Matrix<D>& mobility) {
  Matrix<D> inside = product<D>(product<D>(fixed, mobility), fixed);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) inside[i][j] += (i == j ? 1.0 : 0.0) - fixed[i][j];
  return product<D>(product<D>(fixed, inverse<D>(inside)), fixed);
}

}  // namespace

template <int D>
Star<D> StarMap<D>::apply(const Traces<D>& traces, const Star<D>& load) const {
  const Vector<D>* input[] = {&traces.v_minus, &traces.s_minus, &traces.v_plus, &traces.s_plus};
  Star<D> out = load;
  Vector<D>* output[] = {&out.s, &out.v_minus, &out.v_plus};
  for (int r = 0; r < 3; ++r)
    for (int i = 0; i < D; ++i)
      for (int c = 0; c < 4; ++c)
        for (int j = 0; j < D; ++j) (*output[r])[i] += map[r * D + i][c * D + j] * (*input[c])[j];
  return out;
}

template <int D>
void characteristic_velocities(const Interface<D>& facet, StarMap<D>& map) {
  for (int side = 0; side < (facet.plus ? 2 : 1); ++side) {
    const Matrix<D> y = inverse<D>(side == 0 ? facet.z_minus : facet.z_plus);
    const double sign = side == 0 ? 1.0 : -1.0;  // v*- = v- + Y (s* - s-), v*+ = v+ + Y (s+ - s*)
    for (int i = 0; i < D; ++i) {
      auto& row = map.map[(1 + side) * D + i];
      row = {};
      row[2 * side * D + i] = 1.0;
      for (int k = 0; k < D; ++k) {
        for (int c = 0; c < 4 * D; ++c) row[c] += sign * y[i][k] * map.map[k][c];
        row[(2 * side + 1) * D + k] -= sign * y[i][k];
      }
    }
  }
}

template <int D>
void characteristic_velocities(const Interface<D>& facet, Star<D>& load) {
  load.v_minus = product<D>(inverse<D>(facet.z_minus), load.s);
  if (facet.plus) {
    load.v_plus = product<D>(inverse<D>(facet.z_plus), load.s);
    for (double& x : load.v_plus) x = -x;
  }
}

template <int D>
void projected_map(const Interface<D>& facet, const Matrix<D>& fixed, StarMap<D>& map) {
  const Matrix<D> y = inverse<D>(facet.z_minus), mend = stiffened<D>(fixed, y), from_s = product<D>(mend, y);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) map.map[i][j] = -mend[i][j], map.map[i][D + j] = from_s[i][j];
  characteristic_velocities(facet, map);
}

template <int D>
void projected_load(const Interface<D>& facet, const Matrix<D>& fixed, const Vector<D>& velocity,
                    const Vector<D>& traction, Star<D>& load) {
  const Matrix<D> y = inverse<D>(facet.z_minus);
  Vector<D> free = traction;
  const Vector<D> held = product<D>(fixed, traction);
  for (int i = 0; i < D; ++i) free[i] -= held[i];
  Vector<D> defect = product<D>(y, free);
  for (int i = 0; i < D; ++i) defect[i] = velocity[i] - defect[i];
  load.s = product<D>(stiffened<D>(fixed, y), defect);
  for (int i = 0; i < D; ++i) load.s[i] += free[i];
  characteristic_velocities(facet, load);
}

#define CLEAVE_INSTANTIATE(D)                                                                                \
  template struct StarMap<D>;                                                                                \
  template void characteristic_velocities<D>(const Interface<D>&, StarMap<D>&);                              \
  template void characteristic_velocities<D>(const Interface<D>&, Star<D>&);                                 \
  template void projected_map<D>(const Interface<D>&, const Matrix<D>&, StarMap<D>&);                        \
  template void projected_load<D>(const Interface<D>&, const Matrix<D>&, const Vector<D>&, const Vector<D>&, \
                                  Star<D>&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
