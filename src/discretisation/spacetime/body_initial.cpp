/// Initial velocity and stress, and body force, of spacetime parts.

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

/// Initial velocities of the vertices; empty where all are at rest.
template <int D>
std::vector<Vector<D>> vertex_velocities(const model::Model& model, const Body<D>& body,
                                         deck::Diagnostics& diagnostics) {
  const auto& given = model.initial_velocity;
  std::vector<Vector<D>> velocity;
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
  if (!moves) velocity.clear();
  return velocity;
}

/// Strain under a stress: E = (W C W)^-1 W sigma.
template <int D>
Voigt<D> strain_under(const Voigt<D>& stress, const Elastic<D>& material) {
  Voigt<D> strain{}, half{};
  for (int i = 0; i < strain_count<D>; ++i)
    for (int j = 0; j < strain_count<D>; ++j)
      half[i] += material.from_energy[i][j] * work_factor<D>(j) * stress[j];
  for (int i = 0; i < strain_count<D>; ++i)
    for (int j = 0; j < strain_count<D>; ++j) strain[i] += material.from_energy[i][j] * half[j];
  return strain;
}

/// Initial strains of the simplices; empty where there are none.
template <int D>
std::vector<Voigt<D>> simplex_strains(const model::Model& model, const Body<D>& body,
                                      deck::Diagnostics& diagnostics) {
  const auto& given = model.initial_stress;
  std::vector<Voigt<D>> strain;
  for (const model::InitialStress& s : given) {
    const double shear = std::max(std::fabs(s.stress[4]), std::fabs(s.stress[5]));
    const std::string name = "element " + std::to_string(s.element);
    if (D == 2 && shear > 0.0)
      diagnostics.error(s.place, "INITIAL_STRESS_SHELL", s.stress[4] != 0.0 ? "SIGYZ" : "SIGZX",
                        name + " has a shear stress across the plane, in which nothing moves", "leave it 0");
    if (D == 2 && s.stress[2] != 0.0)
      diagnostics.warning(s.place, "INITIAL_STRESS_SHELL", "SIGZZ",
                          name + " has a stress across the plane, which takes no part in the motion",
                          "leave it 0: in plane strain it follows from the others");
  }
  if (given.empty() || D == 1) return strain;
  static constexpr int component[3][6] = {{0}, {0, 1, 3}, {0, 1, 2, 3, 4, 5}};
  for (std::size_t s = 0; s < body.element_of_simplex.size(); ++s) {
    const auto at = std::lower_bound(given.begin(), given.end(), body.element_of_simplex[s],
                                     [](const auto& a, model::Id id) { return a.element < id; });
    Voigt<D> stress{};
    if (at != given.end() && at->element == body.element_of_simplex[s])
      for (std::size_t k = 0; k < stress.size(); ++k) stress[k] = at->stress[component[D - 1][k]];
    const auto part = static_cast<std::size_t>(body.mesh.material(static_cast<Simplex>(s)));
    strain.push_back(strain_under<D>(stress, body.problem.materials[part]));
  }
  const bool uniform =
      std::all_of(strain.begin(), strain.end(), [&](const Voigt<D>& e) { return e == strain[0]; });
  for (std::size_t part = 0; part < model.parts.size() && !uniform; ++part)
    if (body.problem.spaces[part].space == LocalSpace::one_field)
      diagnostics.error(given.front().place, "INITIAL_STRESS", "EID",
                        "part " + std::to_string(model.parts[part].id) +
                            " has displacements alone, which fit no stress that jumps between elements",
                        "use SPACE 2 or 3, or give all elements the same strain");
  return strain;
}

}  // namespace

template <int D>
void set_initial_state(const model::Model& model, Body<D>& body, deck::Diagnostics& diagnostics) {
  auto velocity = vertex_velocities<D>(model, body, diagnostics);
  auto strain = simplex_strains<D>(model, body, diagnostics);
  if (velocity.empty() && strain.empty()) return;
  // Displacements count from the state without stress. Under one strain they are one linear field, zero at
  // the first vertex; else each simplex has its own about its middle.
  const bool uniform =
      std::all_of(strain.begin(), strain.end(), [&](const Voigt<D>& e) { return e == strain[0]; });
  body.problem.initial = [&mesh = body.mesh, velocity = std::move(velocity), strain = std::move(strain),
                          uniform](Simplex s, const Event<D>& y) {
    PointState<D> state;
    const auto& vertex = mesh.simplex(s);
    std::array<Point<D>, D + 1> corner;
    for (std::size_t i = 0; i <= D; ++i) corner[i] = mesh.position()[static_cast<std::size_t>(vertex[i])];
    if (!velocity.empty()) {  // linear between the vertices
      const double whole = signed_volume<static_cast<std::size_t>(D)>(corner);
      for (std::size_t i = 0; i <= D; ++i) {
        auto part = corner;
        for (std::size_t k = 0; k < D; ++k) part[i][k] = y[k];
        const double weight = signed_volume<static_cast<std::size_t>(D)>(part) / whole;
        for (std::size_t k = 0; k < D; ++k)
          state.v[k] += weight * velocity[static_cast<std::size_t>(vertex[i])][k];
      }
    }
    if (!strain.empty()) {
      state.strain = strain[static_cast<std::size_t>(s)];
      Point<D> centre = mesh.position()[0];
      for (std::size_t k = 0; k < D && !uniform; ++k) {
        centre[k] = 0.0;
        for (const auto& x : corner) centre[k] += x[k] / (D + 1);
      }
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
          state.u[i] += state.strain[voigt<D>(i, j)] *
                        (y[static_cast<std::size_t>(j)] - centre[static_cast<std::size_t>(j)]);
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
      diagnostics.error(load.place, load.generalized ? "LOAD_BODY_GENERALIZED" : "LOAD_BODY_PARTS", "",
                        "a body force on some of the spacetime parts is not computed",
                        "let it act on all parts");
    if (load.rotation && load.angular != model::BodyLoad::Angular::centrifugal)
      diagnostics.error(load.place, "LOAD_BODY_GENERALIZED", "ANGTYP",
                        "Coriolis and rotational accelerations are not computed for spacetime parts",
                        "CENT, the centrifugal one, is");
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
    const double square = load.generalized ? base::dot(load.direction, load.direction) : 1.0;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        a.arm[i][j] = (i == j ? square : 0.0) - component(load.direction, i) * component(load.direction, j);
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
