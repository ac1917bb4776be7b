/// Initial velocity and body force of spacetime parts.

#include <algorithm>

#include "discretisation/spacetime/body_motion.hpp"
#include "discretisation/spacetime/body_steps.hpp"

namespace cleave::discretisation::spacetime {
namespace {

double component(const model::Vector& v, int k) {
  return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

/// One *LOAD_BODY: an acceleration along a direction, or away from an axis.
template <int D>
struct Acceleration {
  History history;
  bool rotation;
  Vector<D> direction{};  ///< of the acceleration
  Vector<D> centre{};     ///< of a rotation
  Matrix<D> arm{};        ///< from a position relative to the centre to that relative to the axis
};

}  // namespace

template <int D>
void set_initial_state(const model::Model& model, Body<D>& body, deck::Diagnostics& diagnostics) {
  const auto& given = model.initial_velocity;
  std::vector<Vector<D>> velocity;  // [vertex]
  bool moves = false;
  std::vector<model::Id> across;
  for (std::size_t v = 0; v < body.node_of_vertex.size(); ++v) {
    const auto at = 3 * static_cast<std::size_t>(body.node_of_vertex[v]);
    Vector<D> value{};
    for (std::size_t k = 0; k < 3 && at + k < given.size(); ++k) {
      if (k < D)
        value[k] = given[at + k];
      else if (given[at + k] != 0.0 &&
               (across.empty() || across.back() != body.mesh.vertex_id(static_cast<Vertex>(v))))
        across.push_back(body.mesh.vertex_id(static_cast<Vertex>(v)));
    }
    moves = moves || norm(value) > 0.0;
    velocity.push_back(value);
  }
  if (!across.empty())
    diagnostics.error(
        {}, "INITIAL_VELOCITY", D == 2 ? "VZ" : "VY",
        "nodes have an initial velocity out of the plane or line of the body: " + listed(across),
        "leave it 0");
  if (!moves) return;
  body.problem.initial = [&mesh = body.mesh, velocity = std::move(velocity)](Simplex s, const Event<D>& y) {
    // Linear between the vertices.
    const auto& vertex = mesh.simplex(s);
    std::array<Point<D>, D + 1> corner;
    for (std::size_t i = 0; i <= D; ++i) corner[i] = mesh.position()[static_cast<std::size_t>(vertex[i])];
    const double whole = signed_volume<static_cast<std::size_t>(D)>(corner);
    PointState<D> state;
    for (std::size_t i = 0; i <= D; ++i) {
      auto part = corner;
      for (std::size_t k = 0; k < D; ++k) part[i][k] = y[k];
      const double weight = signed_volume<static_cast<std::size_t>(D)>(part) / whole;
      for (std::size_t k = 0; k < D; ++k)
        state.v[k] += weight * velocity[static_cast<std::size_t>(vertex[i])][k];
    }
    return state;
  };
}

template <int D>
void set_body_force(const model::Model& model, Body<D>& body, deck::Diagnostics& diagnostics) {
  std::vector<Acceleration<D>> list;
  for (const model::BodyLoad& load : model.body_loads) {
    const bool everywhere =
        load.nodes.empty() ||
        std::all_of(body.node_of_vertex.begin(), body.node_of_vertex.end(),
                    [&](model::Index i) { return load.nodes[static_cast<std::size_t>(i)]; });
    if (!everywhere)
      diagnostics.error(load.place, "LOAD_BODY_PARTS", "PSID",
                        "a body force on some of the spacetime parts is not computed",
                        "let it act on all parts");
    Acceleration<D> a{.history = History(model.curves[static_cast<std::size_t>(load.curve)], load.scale, 0.0,
                                         History::Kind::value),
                      .rotation = load.rotation};
    double along = 0.0, out = 0.0;  // parts of the axis in the body's plane or line, and across it
    for (int k = 0; k < 3; ++k) {
      (k < D ? along : out) += component(load.direction, k) * component(load.direction, k);
      if (k < D) a.direction[k] = -component(load.direction, k), a.centre[k] = component(load.centre, k);
    }
    const bool fits = !load.rotation ? out < 1e-18 : D == 3 || (D == 2 && along < 1e-18);
    if (!fits)
      diagnostics.error(load.place, "LOAD_BODY", "",
                        "this body force points out of the plane or line of the body",
                        load.rotation ? "in the plane only a rotation about z is possible" : "leave it out");
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        a.arm[i][j] = (i == j ? 1.0 : 0.0) - component(load.direction, i) * component(load.direction, j);
    list.push_back(a);
  }
  if (list.empty()) return;
  body.problem.body_force = [list = std::move(list)](const Event<D>& y) {
    Vector<D> sum{};
    for (const Acceleration<D>& a : list) {
      const double value = a.history(y[D]);
      for (int i = 0; i < D; ++i) {
        if (!a.rotation) sum[i] += value * a.direction[i];
        for (int j = 0; j < D && a.rotation; ++j)
          sum[i] += value * value * a.arm[i][j] * (y[j] - a.centre[j]);
      }
    }
    return sum;
  };
}

#define CLEAVE_INSTANTIATE(D)                                                            \
  template void set_initial_state<D>(const model::Model&, Body<D>&, deck::Diagnostics&); \
  template void set_body_force<D>(const model::Model&, Body<D>&, deck::Diagnostics&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
