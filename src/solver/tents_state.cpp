#include "solver/tents_state.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"

namespace cleave::solver {

using namespace discretisation::spacetime;
using discretisation::State;

template <int D>
StateFiller<D>::StateFiller(const model::Model& model, const Body& body, const Outside<D>& outside)
    : model_(model), body_(body), outside_(outside) {
  const std::size_t nodes = model.mesh.nodes.count();
  std::vector<char> shown(nodes, 0);
  for (Vertex v = 0; v < body.mesh.vertex_count(); ++v) {
    char& taken = shown[static_cast<std::size_t>(body.node_of_vertex[static_cast<std::size_t>(v)])];
    if (!taken) vertex_.push_back(v);
    taken = 1;
  }
  std::vector<char> watched(nodes, 0);
  for (const model::Index node : model.requests.history_nodes) watched[static_cast<std::size_t>(node)] = 1;
  for (const auto& bound : model.control.end.nodes) watched[static_cast<std::size_t>(bound.node)] = 1;
  for (const Vertex v : vertex_)
    if (watched[static_cast<std::size_t>(body.node_of_vertex[static_cast<std::size_t>(v)])])
      watched_.push_back(v);
  std::vector<char> fixed(nodes, 0);
  for (const auto& held : model.fixed)
    if (held.directions & 7u)
      for (const model::Index node : held.nodes) fixed[static_cast<std::size_t>(node)] = 1;
  for (const auto& motion : model.motions)
    for (const model::Index node : motion.nodes) fixed[static_cast<std::size_t>(node)] = 1;
  for (const BoundaryFace<D>& face : body.mesh.boundary()) {
    held_.push_back(1);
    for (const Vertex v : face.vertex)
      if (!fixed[static_cast<std::size_t>(body.node_of_vertex[static_cast<std::size_t>(v)])])
        held_.back() = 0;
  }
  acceleration_.assign(3 * nodes, 0.0);
  reaction_.assign(3 * nodes, 0.0);
  motion_.resize(model.parts.size());
}

template <int D>
void StateFiller<D>::start(State& state) const {
  state.mass.assign(model_.mesh.nodes.count(), 0.0);
  state.parts.assign(model_.parts.size(), {});
  for (Simplex s = 0; s < body_.mesh.simplex_count(); ++s) {
    std::array<Point<D>, D + 1> corner;
    for (std::size_t c = 0; c <= D; ++c)
      corner[c] = body_.mesh.position()[static_cast<std::size_t>(body_.mesh.simplex(s)[c])];
    const double density = body_.problem.materials[static_cast<std::size_t>(body_.mesh.material(s))].density;
    const double share = density * body_.thickness * std::fabs(signed_volume<D>(corner)) / (D + 1);
    for (const Vertex v : body_.mesh.simplex(s))
      state.mass[static_cast<std::size_t>(body_.node_of_vertex[static_cast<std::size_t>(v)])] += share;
  }
}

template <int D>
void StateFiller<D>::fill_energies(State& state, const Instant<D>& instant, bool resumed) {
  const std::vector<PartSums<D>> sums = instant.sums();
  momentum_ = {};
  double kinetic = 0.0, internal = 0.0;
  for (std::size_t p = 0; p < sums.size(); ++p) {
    motion_[p].mass = body_.thickness * sums[p].mass;
    motion_[p].kinetic = body_.thickness * sums[p].kinetic;
    kinetic += motion_[p].kinetic;
    internal += body_.thickness * sums[p].internal;
    for (std::size_t i = 0; i < D; ++i) {
      motion_[p].momentum[i] = body_.thickness * sums[p].momentum[i];
      momentum_[i] += motion_[p].momentum[i];
    }
  }
  if (resumed) return;
  exchanged_ = instant.exchanged(outside_);
  for (std::size_t p = 0; p < sums.size(); ++p) state.parts[p].internal = body_.thickness * sums[p].internal;
  state.energy.kinetic = kinetic;
  state.energy.internal = internal;
  state.energy.external = body_.thickness * (exchanged_.boundary_work + exchanged_.body_work);
  if (state.cycle == 0) state.energy.initial = kinetic + internal;
}

template <int D>
void StateFiller<D>::fill_nodes(State& state, const Instant<D>& instant, bool every) {
  const std::vector<Vertex>& wanted = every ? vertex_ : watched_;
  base::for_each_range(wanted.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const Vertex v = wanted[k];
      const PlaceState<D> place = instant.at_vertex(v);
      const auto at = 3 * static_cast<std::size_t>(body_.node_of_vertex[static_cast<std::size_t>(v)]);
      for (std::size_t i = 0; i < D; ++i) {
        state.position[at + i] = model_.mesh.nodes.position[at + i] + place.state.u[i];
        state.velocity[at + i] = place.state.v[i];
        acceleration_[at + i] = place.acceleration[i];
      }
    }
  });
}

template <int D>
void StateFiller<D>::fill_reactions(const Instant<D>& instant) {
  std::vector<Vector<D>> force(static_cast<std::size_t>(body_.mesh.vertex_count()), Vector<D>{});
  instant.reactions(outside_, held_, force);
  std::fill(reaction_.begin(), reaction_.end(), 0.0);
  for (std::size_t v = 0; v < force.size(); ++v)
    for (std::size_t i = 0; i < D; ++i)
      reaction_[3 * static_cast<std::size_t>(body_.node_of_vertex[v]) + i] += body_.thickness * force[v][i];
}

template <int D>
double StateFiller<D>::volume_error(double time) const {
  const double wanted = body_.mesh.volume() * time;
  return wanted > 0.0 ? std::fabs(exchanged_.volume - wanted) / wanted : 0.0;
}

template class StateFiller<1>;
template class StateFiller<2>;
template class StateFiller<3>;

}  // namespace cleave::solver
