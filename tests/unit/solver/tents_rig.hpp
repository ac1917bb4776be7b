#pragma once
/// Spacetime bodies made by hand, run by the tents solver with an observer that keeps what it sees.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../discretisation/spacetime_meshes.hpp"
#include "solver/tents.hpp"

namespace cleave::solver::test {

using namespace discretisation::spacetime;

/// What an observer saw at one instant.
struct Seen {
  double time;
  discretisation::Energy energy;
  base::Array<double> position, velocity;
  std::vector<double> acceleration, reaction;
  PartMotion motion;
  std::vector<Fact> facts;
  double fact(std::string_view name) const {
    for (const Fact& f : facts)
      if (f.name == name) return f.value;
    ADD_FAILURE() << "no fact " << name;
    return 0.0;
  }
};

struct Watcher final : Observer {
  std::vector<Seen> seen;
  Ending ending = Ending::end_time;
  discretisation::StepStatus status;
  CellFields last_cells;
  std::function<void(const Frame&)> on_step;

  void begin(const Frame& frame) override { add(frame); }
  void after_step(const Frame& frame) override {
    add(frame);
    if (on_step) on_step(frame);
  }
  void finish(const Frame& frame, Ending end, const discretisation::StepStatus& how) override {
    ending = end;
    status = how;
    last_cells = frame.cells->cells();
    frame.save();
  }

 private:
  void add(const Frame& f) {
    f.evaluate(everything);
    seen.push_back({f.state.time,
                    f.state.energy,
                    f.state.position,
                    f.state.velocity,
                    {f.acceleration.begin(), f.acceleration.end()},
                    {f.reaction.begin(), f.reaction.end()},
                    f.motion[0],
                    {f.facts.begin(), f.facts.end()}});
  }
};

/// A model of one part on a mesh, its world, and what a body needs; density and fastest speed 1.
template <int D>
struct Rig {
  model::Model model;
  discretisation::World world;
  SpaceMeshInput<D> input;
  SpaceChoice space{LocalSpace::three_field, 3};
  std::function<PointState<D>(Simplex, const Event<D>&)> initial;
  VectorField<D> body_force;
  std::function<TargetPtr<D>(const BoundaryFace<D>&)> target;
  bool verify = true;
  double thickness = 1.0;
  int simplices_per_element = 1;
  bool repeat = false;  ///< equal tents where the mesh has few shapes

  explicit Rig(SpaceMeshInput<D> mesh, double end, double every) : input(std::move(mesh)) {
    for (std::size_t v = 0; v < input.vertex.size(); ++v) {
      model.mesh.nodes.id.push_back(static_cast<model::Id>(v) + 1);
      for (std::size_t k = 0; k < 3; ++k)
        model.mesh.nodes.position.push_back(k < D ? input.vertex[v][k] : 0.0);
    }
    model.initial_velocity.assign(model.mesh.nodes.position.size(), 0.0);
    model.parts.resize(1);
    model.parts[0].id = 1;
    model.parts[0].density = 1.0;
    model.control.end.time = end;
    model.requests.glstat.every = every;
    world.model = &model;
  }
  Rig(const Rig&) = delete;

  std::unique_ptr<Body<D>> body() const {
    auto body = std::make_unique<Body<D>>();
    EXPECT_TRUE(body->mesh.build(input).ok);
    Elastic<D> elastic;
    // lambda + 2 mu = 1
    EXPECT_EQ(make_isotropic<D>(1.0, D == 1 ? 1.0 : 5.0 / 6.0, D == 1 ? 0.0 : 0.25,
                                D == 1 ? PlaneKind::stress : PlaneKind::strain, elastic),
              "");
    body->problem.materials = {elastic};
    body->problem.spaces = {space};
    body->problem.initial = initial;
    body->problem.body_force = body_force;
    for (const BoundaryFace<D>& face : body->mesh.boundary()) {
      body->target.push_back(target ? target(face) : make_traction<D>({}));
      body->problem.targets.push_back(body->target.back().get());
    }
    body->end_time = model.control.end.time;
    body->verify = verify;
    body->pitch.repeat = repeat;
    body->thickness = thickness;
    for (Vertex v = 0; v < body->mesh.vertex_count(); ++v)
      body->node_of_vertex.push_back(body->mesh.origin(v));
    for (Simplex s = 0; s < body->mesh.simplex_count(); ++s)
      body->element_of_simplex.push_back(s / simplices_per_element + 1);
    return body;
  }

  discretisation::State fresh() const {
    discretisation::State state;
    EXPECT_TRUE(discretisation::initialise(world, state).ok);
    return state;
  }
  Outcome run(discretisation::State& state, Watcher& watcher, const Options& options = {}) const {
    Wishes wishes;
    return run(state, watcher, wishes, options);
  }
  Outcome run(discretisation::State& state, Watcher& watcher, Wishes& wishes,
              const Options& options = {}) const {
    Observer* const observers[] = {&watcher};
    return make_tents<D>(world, body(), options)->advance(state, observers, wishes);
  }
};

/// A standing wave along x between ends at 0 and 1 that are held, one half wave: u = sin(pi x) sin(pi t) /
/// pi.
template <int D>
PointState<D> standing_wave(const Event<D>& y) {
  constexpr double pi = std::numbers::pi;
  PointState<D> s;
  s.u[0] = std::sin(pi * y[0]) * std::sin(pi * y[D]) / pi;
  s.v[0] = std::sin(pi * y[0]) * std::cos(pi * y[D]);
  s.strain[0] = std::cos(pi * y[0]) * std::sin(pi * y[D]);
  return s;
}

/// The targets under which standing_wave() is exact: held ends, symmetry planes along the other axes.
template <int D>
TargetPtr<D> standing_wave_target(const BoundaryFace<D>& face) {
  return std::abs(face.normal[0]) > 0.5 ? make_velocity<D>({}) : make_symmetry<D>();
}

template <int D>
void make_standing_wave(Rig<D>& rig) {
  rig.initial = [](Simplex, const Event<D>& y) { return standing_wave<D>(y); };
  rig.target = standing_wave_target<D>;
}

}  // namespace cleave::solver::test
