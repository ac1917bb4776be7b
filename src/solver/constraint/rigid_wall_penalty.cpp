#include "solver/constraint/rigid_wall_penalty.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "solver/constraint/rigid_wall_friction.hpp"
#include "solver/field.hpp"

namespace cleave::solver {
namespace {

using model::Vector;

constexpr std::size_t grain = 2048;
constexpr double share = 0.1;  // of m / dt^2, as SOFSCL of contacts

}  // namespace

WallPenalty::WallPenalty(const model::RigidWall& wall, std::vector<Index> nodes, double scale)
    : wall_(wall), nodes_(std::move(nodes)), scale_(scale) {
  found_.resize((nodes_.size() + grain - 1) / grain);
}

const std::vector<WallPenalty::Push>& WallPenalty::push(const Moment& now, double travel, double move,
                                                        std::span<double> memory,
                                                        std::span<double> acceleration) {
  pushes_.clear();
  if (nodes_.empty()) return pushes_;
  const bool first = memory[begun] == 0.0;
  memory[begun] = 1.0;
  memory[least_step] = first ? now.step : std::min(memory[least_step], now.step);
  const double per_mass = stiffness(now, memory[least_step]);

  base::for_each_range(nodes_.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Push>& found = found_[begin / grain];
    found.clear();
    for (std::size_t k = begin; k < end; ++k) {
      const Index node = nodes_[k];
      const double mass = now.mass[static_cast<std::size_t>(node)];
      if (!(mass > 0.0)) continue;
      double* own = &memory[node_state + slots * k];
      if (first && !wall_.finite)
        own[level] =
            std::min(base::dot(vector_at(now.position, node) - wall_.origin, wall_.normal) - travel, 0.0);
      Push one{node, {0, 0, 0}};
      if (!push_one(now, travel, move, per_mass, node, own, one.force)) continue;
      for (std::size_t i = 0; i < 3; ++i)
        acceleration[3 * static_cast<std::size_t>(node) + i] += one.force[i] / mass;
      found.push_back(one);
    }
  });
  for (const auto& found : found_) pushes_.insert(pushes_.end(), found.begin(), found.end());
  return pushes_;
}

/// Of the spring of a node, in units of its mass [1/time^2].
double WallPenalty::stiffness(const Moment& now, double step) const {
  double ratio = 0.0;
  if (wall_.mass > 0.0)
    for (const Index node : nodes_) ratio += now.mass[static_cast<std::size_t>(node)] / wall_.mass;
  return share * scale_ / (step * step * (1.0 + ratio));
}

bool WallPenalty::push_one(const Moment& now, double travel, double move, double per_mass, Index node,
                           double* own, double (&force)[3]) const {
  const Vector &n = wall_.normal, from = vector_at(now.position, node) - wall_.origin;
  const Vector v = vector_at(now.velocity, node), moved = now.step_before * v;
  const double distance = base::dot(from, n) - travel;
  const auto let_go = [&] { return own[state] = own[slip] = own[slip + 1] = own[slip + 2] = 0.0, false; };

  // Who is behind: without end everything beyond its own level; else what came through, until it is beside.
  if (own[state] != welded) {
    if (distance >= own[level]) {
      own[level] = std::min(distance, 0.0);
      return let_go();
    }
    if (wall_.finite) {
      const double slack = 1e-6 * (wall_.length_l + wall_.length_m);
      const double before = distance - base::dot(moved, n) + move;
      if (own[state] == apart && before < -slack) return false;
      const double l = base::dot(from, wall_.edge_l), m = base::dot(from, wall_.edge_m);
      if (l < 0.0 || l > wall_.length_l || m < 0.0 || m > wall_.length_m) return let_go();
    }
  }
  if (own[state] == apart) {
    const bool welds = wall_.friction == 2.0 || wall_.friction == 3.0;
    const double towards = now.step_before > 0.0 ? (move - base::dot(moved, n)) / now.step_before : 0.0;
    own[state] = welds && towards > wall_.velocity_limit ? welded : touches;
  }

  const double k = per_mass * now.mass[static_cast<std::size_t>(node)];
  const double normal = k * (own[level] - distance);
  const Vector along = moved - base::dot(moved, n) * n;
  const Vector sliding = v - base::dot(v, n) * n;
  const Vector stretch = Vector{own[slip], own[slip + 1], own[slip + 2]} + along;
  const Vector friction =
      friction_change(wall_, k * stretch, std::sqrt(base::dot(sliding, sliding)), normal, n, now.position);
  own[slip] = -friction.x / k, own[slip + 1] = -friction.y / k, own[slip + 2] = -friction.z / k;
  const Vector sum = normal * n + friction;
  force[0] = sum.x, force[1] = sum.y, force[2] = sum.z;
  return true;
}

}  // namespace cleave::solver
