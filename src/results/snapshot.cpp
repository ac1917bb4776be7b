#include "results/snapshot.hpp"

#include <algorithm>

#include "base/threads.hpp"

namespace cleave::results {
namespace {

constexpr std::size_t grain = 8192;

/// Sums over nodes in ranges of fixed size, then over the ranges in order: the same bits for any thread
/// count.
/// @param node_of  entry -> node
/// @param mass_of  entry -> mass
template <class NodeOf, class MassOf>
Motion sum(std::size_t count, const solver::NodeVelocity& velocity, const NodeOf& node_of,
           const MassOf& mass_of) {
  std::vector<Motion> ranges((count + grain - 1) / grain);
  base::for_each_range(count, grain, [&](std::size_t begin, std::size_t end) {
    Motion range;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t at = 3 * node_of(i);
      const double v[3] = {velocity[at], velocity[at + 1], velocity[at + 2]};
      const double m = mass_of(i);
      range.mass += m;
      for (int k = 0; k < 3; ++k) range.momentum[k] += m * v[k];
      range.kinetic += 0.5 * m * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    ranges[begin / grain] = range;
  });
  Motion all;
  for (const Motion& range : ranges) {
    all.mass += range.mass;
    for (int k = 0; k < 3; ++k) all.momentum[k] += range.momentum[k];
    all.kinetic += range.kinetic;
  }
  return all;
}

}  // namespace

Masses::Masses(const discretisation::World& world, std::span<const solver::PartMotion> motion)
    : parts_(world.model->parts.size()),
      elements_(world.node_count(), 0.0),
      points_(world.node_count(), 0.0) {
  const base::Array<double> reference(world.model->mesh.nodes.position.begin(),
                                      world.model->mesh.nodes.position.end());
  // From the reference state, not the current one: a restarted run must find the same shares.
  std::vector<std::vector<double>> of_part(parts_.size());
  for (const auto& block : world.blocks) {
    discretisation::BlockState fresh;
    if (!block->initialise(reference, fresh).ok) continue;  // the run itself has refused this state
    auto& mass = of_part[static_cast<std::size_t>(block->part())];
    mass.resize(elements_.size(), 0.0);
    block->add_mass(fresh, mass);
  }
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (std::size_t a = 0; a < of_part[p].size(); ++a)
      if (of_part[p][a] > 0.0) {
        parts_[p].node.push_back(static_cast<model::Index>(a));
        parts_[p].mass.push_back(of_part[p][a]);
        parts_[p].total += of_part[p][a];
        elements_[a] += of_part[p][a];
      }
  for (const discretisation::RigidBody& body : world.bodies) {
    rigid_.resize(elements_.size(), 0);
    for (const model::Index a : body.node) rigid_[static_cast<std::size_t>(a)] = 1;
    for (std::size_t k = 0; k < body.part.size(); ++k) {
      Part& part = parts_[static_cast<std::size_t>(body.part[k])];
      part.node.clear();
      part.mass.clear();
      part.total = body.of_part[k].mass;
    }
    total_ += body.whole.mass;
  }
  for (const model::PointMass& point : world.model->point_masses)
    points_[static_cast<std::size_t>(point.node)] += point.mass;
  for (std::size_t a = 0; a < elements_.size(); ++a)
    if (!rigid(a)) total_ += elements_[a] + points_[a];
  for (std::size_t p = 0; p < motion.size(); ++p) {
    parts_[p].total = motion[p].mass;
    total_ += motion[p].mass;
  }
}

const Motion& Snapshot::whole() const {
  if (!have_whole_ && !frame_.motion.empty()) {
    for (const Motion& part : parts()) {
      whole_.mass += part.mass;
      for (int k = 0; k < 3; ++k) whole_.momentum[k] += part.momentum[k];
      whole_.kinetic += part.kinetic;
    }
    have_whole_ = true;
  }
  if (!have_whole_) {
    const double* mass = state().mass.data();
    whole_ = sum(
        state().mass.size(), frame_.velocity, [](std::size_t a) { return a; },
        [&](std::size_t a) { return masses_.rigid(a) ? 0.0 : mass[a]; });
    for (const solver::BodyMotion& body : frame_.bodies) {
      whole_.mass += body.mass;
      for (int k = 0; k < 3; ++k) whole_.momentum[k] += body.mass * body.velocity[k];
      whole_.kinetic += body.kinetic;
    }
    have_whole_ = true;
  }
  return whole_;
}

const std::vector<Motion>& Snapshot::parts() const {
  if (!parts_.empty()) return parts_;
  for (const solver::PartMotion& part : frame_.motion)
    parts_.push_back({part.mass, {part.momentum[0], part.momentum[1], part.momentum[2]}, part.kinetic});
  if (!parts_.empty()) return parts_;
  const double* now = state().mass.data();
  const double *elements = masses_.elements().data(), *points = masses_.points().data();
  for (const Masses::Part& part : masses_.parts()) {
    const auto node_of = [&](std::size_t i) { return static_cast<std::size_t>(part.node[i]); };
    const auto mass_of = [&](std::size_t i) {
      const std::size_t a = node_of(i);
      if (masses_.rigid(a) || now[a] == elements[a] + points[a]) return part.mass[i];
      return std::max(0.0, now[a] - points[a]) * (part.mass[i] / elements[a]);
    };
    parts_.push_back(sum(part.node.size(), frame_.velocity, node_of, mass_of));
  }
  const auto& bodies = frame_.world.bodies;
  for (std::size_t b = 0; b < frame_.bodies.size(); ++b)
    for (std::size_t k = 0; k < bodies[b].part.size(); ++k)
      parts_[static_cast<std::size_t>(bodies[b].part[k])] = of_rigid(b, k);
  return parts_;
}

Motion Snapshot::of_rigid(std::size_t b, std::size_t part) const {
  using base::cross;
  using model::Vector;
  const discretisation::RigidBody& fixed = frame_.world.bodies[b];
  const solver::BodyMotion& body = frame_.bodies[b];
  const discretisation::RigidMass& own = fixed.of_part[part];
  const auto vector = [](const double(&v)[3]) { return Vector{v[0], v[1], v[2]}; };
  const Vector u{body.quaternion[1], body.quaternion[2], body.quaternion[3]};
  const auto turned = [&](const Vector& r, double sign) {
    const Vector c = cross(sign * u, r);
    return r + 2.0 * (body.quaternion[0] * c + cross(sign * u, c));
  };
  const Vector spin = vector(body.spin), at_start = turned(spin, -1.0);
  const Vector v = vector(body.velocity) + cross(spin, turned(own.centre - fixed.whole.centre, 1.0));
  const auto& t = own.tensor;
  const Vector l{t.xx * at_start.x + t.xy * at_start.y + t.zx * at_start.z,
                 t.xy * at_start.x + t.yy * at_start.y + t.yz * at_start.z,
                 t.zx * at_start.x + t.yz * at_start.y + t.zz * at_start.z};
  return {own.mass,
          {own.mass * v.x, own.mass * v.y, own.mass * v.z},
          0.5 * (own.mass * dot(v, v) + dot(at_start, l))};
}

const discretisation::Memory* find_memory(const discretisation::State& state, std::string_view name) {
  for (const discretisation::Memory& memory : state.memory)
    if (memory.name == name) return &memory;
  return nullptr;
}

}  // namespace cleave::results
