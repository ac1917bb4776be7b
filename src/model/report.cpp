#include "model/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "model/material/law.hpp"
#include "model/solid_geometry.hpp"

namespace cleave::model {
namespace {

/// Density and Young's modulus of steel in the consistent unit systems.
struct UnitSystem {
  std::string_view name;
  double density, modulus;
};
constexpr UnitSystem systems[] = {
    {"kg m s", 7.83e3, 2.07e11},        {"kg mm ms", 7.83e-6, 2.07e2}, {"g mm ms", 7.83e-3, 2.07e5},
    {"tonne mm s", 7.83e-9, 2.07e5},    {"g cm us", 7.83, 2.07},       {"g cm s", 7.83, 2.07e12},
    {"lbf-s2/in in s", 7.33e-4, 3.0e7}, {"slug ft s", 15.2, 4.32e9},
};

/// Smallest height of a triangle or tetrahedron, length of a line; of a quadrilateral cut in two along the
/// diagonal that leaves more of it. [length]
double least_height(Shape shape, std::span<const Corner> x) {
  const auto area = [&](int a, int b, int c) {
    const Corner n = base::cross(x[b] - x[a], x[c] - x[a]);
    return 0.5 * std::sqrt(base::dot(n, n));
  };
  const auto triangle = [&](int a, int b, int c) {
    double longest = 0.0;
    for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
      longest = std::max(longest, base::dot(x[q] - x[p], x[q] - x[p]));
    return longest > 0.0 ? 2.0 * area(a, b, c) / std::sqrt(longest) : 0.0;
  };
  switch (shape) {
    case Shape::line2:
      return shortest_edge(shape, x);
    case Shape::tri3:
      return triangle(0, 1, 2);
    case Shape::quad4:
      return std::max(std::min(triangle(0, 1, 2), triangle(0, 2, 3)),
                      std::min(triangle(1, 2, 3), triangle(3, 0, 1)));
    case Shape::tet4: {
      const double largest = std::max({area(0, 1, 2), area(0, 1, 3), area(0, 2, 3), area(1, 2, 3)});
      return largest > 0.0 ? 3.0 * std::fabs(volume(shape, x)) / largest : 0.0;
    }
    default:
      return 0.0;
  }
}

/// Elements of one shape to the lines of their parts.
void add(const Model& model, const Elements& group, ModelReport& r) {
  std::array<Corner, 10> x;
  const int n = nodes_of(group.shape);
  const bool solid = group.shape <= Shape::tet10;
  for (std::size_t e = 0; e < group.count(); ++e) {
    for (int a = 0; a < n; ++a) {
      const double* at =
          model.mesh.nodes.position.data() + 3 * static_cast<std::size_t>(group.node[e * n + a]);
      x[a] = {at[0], at[1], at[2]};
    }
    const std::span<const Corner> corner(x.data(), n);
    const Part& of = model.parts[group.part[e]];
    PartReport& part = r.parts[group.part[e]];
    const bool spacetime = spacetime_dimension(of.section) != 0;
    const bool shell = !spacetime && (group.shape == Shape::tri3 || group.shape == Shape::quad4);
    const double area_or_volume = volume(group.shape, corner);
    const double v = area_or_volume * (spacetime ? spacetime_thickness(of.section)
                                       : shell   ? of.section.number("T1", 0.0)
                                                 : 1.0);
    ++part.elements;
    part.volume += v;
    part.mass += v * of.density + (shell ? area_or_volume * of.section.number("MAREA", 0.0) : 0.0);
    const double jacobian = solid ? jacobian_ratio(group.shape, corner) : 1.0,
                 aspect = aspect_ratio(group.shape, corner);
    if (part.worst_jacobian_element == 0 || jacobian < part.worst_jacobian)
      part.worst_jacobian = jacobian, part.worst_jacobian_element = group.id[e];
    if (part.worst_aspect_element == 0 || aspect > part.worst_aspect)
      part.worst_aspect = aspect, part.worst_aspect_element = group.id[e];
    const double height = spacetime ? least_height(group.shape, corner) : 0.0;
    if (spacetime && (part.least_height_element == 0 || height < part.least_height))
      part.least_height = height, part.least_height_element = group.id[e];
    if (part.sound_speed > 0.0 && v > 0.0 && !of.rigid && !shell) {
      const double step = (spacetime ? height : shortest_edge(group.shape, corner)) / part.sound_speed;
      if (r.least_time_step_element == 0 || step < r.least_time_step)
        r.least_time_step = step, r.least_time_step_element = group.id[e];
    }
  }
}

}  // namespace

std::string guess_units(double density, double modulus) {
  // Metals are 0.2 to 2.5 times as dense as steel and 0.15 to 2 times as stiff.
  std::string_view found;
  for (const UnitSystem& s : systems) {
    const double d = density / s.density, m = modulus / s.modulus;
    if (d < 0.2 || d > 2.5 || m < 0.15 || m > 2.0) continue;
    if (!found.empty()) return {};
    found = s.name;
  }
  return std::string(found);
}

ModelReport report(const Model& model) {
  ModelReport r;
  r.nodes = model.mesh.nodes.count();
  const auto& p = model.mesh.nodes.position;
  for (int i = 0; i < 3 && r.nodes > 0; ++i) r.low[i] = r.high[i] = p[i];
  for (std::size_t i = 0; i < p.size(); ++i) {
    r.low[i % 3] = std::min(r.low[i % 3], p[i]);
    r.high[i % 3] = std::max(r.high[i % 3], p[i]);
  }

  for (const Part& part : model.parts) {
    PartReport line;
    line.id = part.id;
    line.title = part.title;
    if (part.law && part.density > 0.0) {
      const double shear = part.law->shear_modulus(), bulk = part.law->bulk_modulus();
      line.sound_speed = std::sqrt(part.law->longitudinal_modulus() / part.density);
      line.units = guess_units(part.density, 9.0 * bulk * shear / (3.0 * bulk + shear));
    }
    r.parts.push_back(line);
  }

  for (const auto* groups : {&model.mesh.solids, &model.mesh.shells, &model.mesh.beams})
    for (const Elements& group : *groups) add(model, group, r);

  for (std::size_t i = 0; i < model.parts.size(); ++i)
    if (model.parts[i].inertia) r.parts[i].mass = model.parts[i].inertia->mass;

  std::set<std::string> units;
  for (const PartReport& part : r.parts) {
    r.elements += part.elements;
    r.volume += part.volume;
    r.mass += part.mass;
    if (!part.units.empty()) units.insert(part.units);
  }
  for (const PointMass& m : model.point_masses) r.mass += m.mass;
  if (units.size() == 1) r.units = *units.begin();
  return r;
}

}  // namespace cleave::model
