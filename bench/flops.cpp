#include "flops.hpp"

#include <vector>

#include "counted.hpp"
#include "discretisation/fem/hex8_one_point.hpp"
#include "discretisation/fem/solid_kernel.hpp"

namespace cleave::discretisation::fem {

/// Records of one counted element: loads and stores are not operations.
template <>
struct Record<bench::Counted> {
  double* at;
  bench::Counted get(int component) const { return at[component]; }
  void set(int component, bench::Counted value) const { at[component] = value.value; }
  Record from(int component) const { return {at + component}; }
};

}  // namespace cleave::discretisation::fem

namespace cleave::bench {

long hex_operations(double hourglass_coefficient) {
  namespace fem = discretisation::fem;
  using Element = fem::HexOnePoint<fem::ViscousHourglass>;
  const Element element{{hourglass_coefficient}, false};
  fem::SolidOptions options;
  options.density = options.shear = 1.0;
  fem::PointLayout layout{1};
  std::vector<double> point(static_cast<std::size_t>(layout.size()), 1.0);
  std::vector<double> own(static_cast<std::size_t>(fem::ElementLayout{1}.own() + element.own_size()), 1.0);
  const fem::BatchRecords<Counted> records{{point.data()}, {own.data()}};
  static constexpr double corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                          {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  fem::Vec3<Counted> x[8], v[8], force[8];
  for (int a = 0; a < 8; ++a) {
    x[a] = {corner[a][0], corner[a][1], corner[a][2]};
    v[a] = {0.01 * corner[a][1], -0.02 * corner[a][0], -0.01 * corner[a][2]};
  }
  fem::Kept<Counted, Element> kept;
  fem::PointScratch<Counted> scratch{};
  fem::ForceAnswer<Counted> answer;
  Counted::operations = 0;
  fem::strain_pass(element, options, layout, x, v, 0.1, records, true, kept, &scratch);
  scratch.modulus = 1.0;
  fem::force_pass(element, options, layout, 0.1, records, kept, &scratch, force, answer);
  return Counted::operations;
}

}  // namespace cleave::bench
