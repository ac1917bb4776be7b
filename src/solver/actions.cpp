#include "solver/action.hpp"
#include "solver/constraint/kinds.hpp"
#include "solver/load/kinds.hpp"

namespace cleave::solver {

std::vector<std::unique_ptr<Load>> make_loads(const model::Model& model) {
  LoadList list;
  add_node_loads(model, list);
  add_segment_loads(model, list);
  add_body_loads(model, list);
  return list;
}

std::vector<std::unique_ptr<Constraint>> make_constraints(const discretisation::World& world,
                                                          deck::Diagnostics& diagnostics) {
  ConstraintList list;
  add_dashpots(world, list, diagnostics);
  add_tied_nodes(world, list, diagnostics);
  add_rigid_walls(world, list, diagnostics);
  add_held_nodes(*world.model, list, diagnostics);
  add_rigid_bodies(world, list, diagnostics);
  return list;
}

double load_value(const model::Curve& curve, double time, double step) {
  const double last = curve.x.empty() ? 0.0 : curve.x.back();
  return curve.value_or_zero(time > last && time - last <= step ? last : time);
}

}  // namespace cleave::solver
