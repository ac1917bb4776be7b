/// Nodes held or moved as told: *BOUNDARY_SPC, *CONSTRAINED_GLOBAL/LOCAL, *BOUNDARY_PRESCRIBED_MOTION.
///
/// Each node has a list of rows "velocity along d is c". They are made orthonormal one after the other
/// (Gram-Schmidt), so any mixture of frames works; a row that depends on those before it has no say.
/// Motions stand before fixed directions, later motions before earlier ones. A rotation about an axis has a
/// row across the arm as it will be at the end of the step and, unless it may change its length, one along
/// it, so that the node lies on its circle however long the step.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/threads.hpp"
#include "solver/constraint/kinds.hpp"
#include "solver/ordered_sum.hpp"

namespace cleave::solver {
namespace {

using model::FixedNodes;
using model::PrescribedMotion;
using model::Vector;

constexpr double dependent = 1e-10;  // squared sine of the angle below which two directions are one
constexpr std::size_t grain = 512;

double component(const Vector& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

/// One direction of one node.
struct Row {
  Vector direction{1, 0, 0};
  double birth = 0.0, death = model::forever;
  const PrescribedMotion* motion = nullptr;  ///< null: velocity zero
  std::size_t offset = 0;  ///< in memory: displacement at birth, for displacements born late
  int turning = 0;         ///< of a rotation: 1 the direction across the turned arm, 2 the one along it

  bool active(double time) const { return time >= birth && time < death; }
};

/// Two unit vectors across d.
std::pair<Vector, Vector> across(const Vector& d) {
  const Vector least = std::abs(d.x) <= std::abs(d.y) && std::abs(d.x) <= std::abs(d.z) ? Vector{1, 0, 0}
                       : std::abs(d.y) <= std::abs(d.z)                                 ? Vector{0, 1, 0}
                                                                                        : Vector{0, 0, 1};
  const Vector s = base::cross(d, least);
  const Vector first = (1.0 / std::sqrt(base::dot(s, s))) * s;
  return {first, base::cross(d, first)};
}

class HeldNodes final : public Constraint {
 public:
  HeldNodes(const model::Model& model, deck::Diagnostics& diagnostics) : model_(model) {
    std::vector<std::pair<Index, Row>> all = rows_of(model);
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [node, row] : all) {
      if (nodes_.empty() || nodes_.back() != node) {
        nodes_.push_back(node);
        first_row_.push_back(rows_.size());
      }
      rows_.push_back(row);
    }
    first_row_.push_back(rows_.size());
    offset_count_ = 0;
    for (Row& row : rows_)
      if (remembers(row)) row.offset = 3 * nodes_.size() + offset_count_++;
    warn_of_conflicts(diagnostics);
  }

  std::string name() const override { return "held nodes"; }

  base::Array<double> first_memory(const discretisation::State&) const override {
    base::Array<double> memory(3 * nodes_.size() + offset_count_, 0.0);
    std::fill(memory.begin() + static_cast<std::ptrdiff_t>(3 * nodes_.size()), memory.end(),
              std::numeric_limits<double>::quiet_NaN());
    return memory;
  }

  void correct(const Moment& now, std::span<double> memory, std::span<double> acceleration) override {
    base::for_each_range(nodes_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t h = begin; h < end; ++h) correct_node(now, h, memory, acceleration);
    });
  }

  std::span<const Index> corrected() const override { return nodes_; }

  Halves work(const Moment& now, std::span<const double> memory,
              std::span<const double> acceleration) const override {
    return ordered_sum<Halves>(nodes_.size(), grain, [&](std::size_t begin, std::size_t end) {
      Halves sum;
      for (std::size_t h = begin; h < end; ++h) {
        const ImpulseWork work = impulse_work(now, nodes_[h], &memory[3 * h], acceleration);
        sum.before.external += work.before;
        sum.after.external += work.after;
      }
      return sum;
    });
  }

  void report(std::span<const double> memory, Reactions& reactions) const override {
    for (std::size_t h = 0; h < nodes_.size(); ++h)
      for (int i = 0; i < 3; ++i)
        reactions.held[3 * static_cast<std::size_t>(nodes_[h]) + i] = memory[3 * h + i];
  }

 private:
  static bool remembers(const Row& row) {
    return row.motion && !row.motion->rotation && row.motion->kind == PrescribedMotion::Kind::displacement &&
           row.birth > 0.0;
  }

  /// (node, row) in order of precedence for each node.
  static std::vector<std::pair<Index, Row>> rows_of(const model::Model& model) {
    std::vector<std::pair<Index, Row>> all;
    for (auto motion = model.motions.rbegin(); motion != model.motions.rend(); ++motion)
      for (const Index node : motion->nodes) {
        Row row{motion->direction, motion->birth, motion->death, &*motion, 0, 0};
        if (motion->rotation) {
          row.turning = 1;
          all.emplace_back(node, row);
          row.turning = 2;
          if (!motion->radial_free) all.emplace_back(node, row);
          continue;
        }
        all.emplace_back(node, row);
        if (motion->only_direction) continue;
        row.motion = nullptr;
        const auto [first, second] = across(motion->direction);
        row.direction = first;
        all.emplace_back(node, row);
        row.direction = second;
        all.emplace_back(node, row);
      }
    for (const FixedNodes& fixed : model.fixed)
      for (const Index node : fixed.nodes)
        for (int i = 0; i < 3; ++i)
          if (fixed.directions >> i & 1u) {
            const Vector global{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
            all.emplace_back(node, Row{fixed.local ? fixed.frame.axis[i] : global, fixed.birth, fixed.death,
                                       nullptr, 0, 0});
          }
    return all;
  }

  /// A motion that another motion or a fixed direction of the same node contradicts is said once.
  void warn_of_conflicts(deck::Diagnostics& diagnostics) const {
    for (std::size_t h = 0; h < nodes_.size(); ++h)
      for (std::size_t p = first_row_[h]; p < first_row_[h + 1]; ++p)
        for (std::size_t q = p + 1; q < first_row_[h + 1]; ++q) {
          if (rows_[p].turning != 0 || rows_[q].turning != 0)
            continue;  // directions of their own in each step
          if (!rows_[p].motion || rows_[p].birth >= rows_[q].death || rows_[q].birth >= rows_[p].death)
            continue;
          const double cosine = base::dot(rows_[p].direction, rows_[q].direction);
          if (1.0 - cosine * cosine > dependent) continue;
          diagnostics.warning({}, "BOUNDARY_PRESCRIBED_MOTION", "",
                              "node " +
                                  std::to_string(model_.mesh.nodes.id[static_cast<std::size_t>(nodes_[h])]) +
                                  " (and perhaps more) is told to move twice in the same direction",
                              "the last motion is used, and a motion prevails over a fixed direction");
          return;
        }
  }

  double displacement_along(const Moment& now, const Vector& direction, std::size_t at) const {
    double displacement = 0.0;
    for (int i = 0; i < 3; ++i)
      displacement += (now.position[at + i] - model_.mesh.nodes.position[at + i]) * component(direction, i);
    return displacement;
  }

  /// By how much a rotation turns in the step to come [radian].
  double turn(const Moment& now, const PrescribedMotion& motion, const Vector& arm, std::size_t at) const {
    const model::Curve& curve = model_.curves[static_cast<std::size_t>(motion.curve)];
    const double since = now.time - std::max(motion.birth, 0.0), scale = motion.scale;
    if (motion.kind == PrescribedMotion::Kind::displacement)
      return scale * (curve.value(since + now.step) - curve.value(std::max(since, 0.0)));
    if (motion.kind == PrescribedMotion::Kind::velocity)
      return now.step * scale * load_value(curve, since + 0.5 * now.step, now.step);
    // The last step was the chord of an arc: its angle gives the speed of rotation half a step ago.
    const double square = base::dot(arm, arm);
    const Vector v{now.velocity[at], now.velocity[at + 1], now.velocity[at + 2]};
    double speed = square > 0.0 ? base::dot(motion.direction, base::cross(arm, v)) / square : 0.0;
    if (now.step_before > 0.0 && square > 0.0) {
      const Vector past = arm - now.step_before * v;
      speed = std::atan2(base::dot(motion.direction, base::cross(past, arm)), base::dot(past, arm)) /
              now.step_before;
    }
    return now.step * (speed + now.interval() * scale * load_value(curve, since, now.step));
  }

  /// Row of a rotation in the step to come: its direction, and the velocity along it that takes the node
  /// there.
  double turned(const Moment& now, const Row& row, Index node, Vector& direction) const {
    const PrescribedMotion& motion = *row.motion;
    const std::size_t at = 3 * static_cast<std::size_t>(node);
    const Vector from = Vector{now.position[at], now.position[at + 1], now.position[at + 2]} - motion.centre;
    const Vector arm = from - base::dot(from, motion.direction) * motion.direction;
    const double length = std::sqrt(base::dot(arm, arm));
    if (length == 0.0) {  // on the axis: it stays there
      const auto [first, second] = across(motion.direction);
      direction = row.turning == 1 ? first : second;
      return 0.0;
    }
    const double angle = turn(now, motion, arm, at);
    const Vector side = base::cross(motion.direction, arm);
    const Vector to = std::cos(angle) * arm + std::sin(angle) * side;
    direction = (1.0 / length) * (row.turning == 1 ? base::cross(motion.direction, to) : to);
    return base::dot(to - arm, direction) / now.step;
  }

  /// Velocity that a row wants along its direction over the step to come [length/time].
  double wanted(const Moment& now, const Row& row, Index node, std::span<double> memory) const {
    if (!row.motion) return 0.0;
    const PrescribedMotion& motion = *row.motion;
    const model::Curve& curve = model_.curves[static_cast<std::size_t>(motion.curve)];
    const double start = std::max(row.birth, 0.0);  // the curve begins when the motion is born
    const std::size_t at = 3 * static_cast<std::size_t>(node);
    if (motion.kind == PrescribedMotion::Kind::velocity)
      return motion.scale * load_value(curve, now.time - start + 0.5 * now.step, now.step);
    if (motion.kind == PrescribedMotion::Kind::velocity_by_displacement) {
      // At the displacement that the velocity found here leads to in half a step: second order.
      const double here = displacement_along(now, row.direction, at);
      const double half = 0.5 * now.step * motion.scale * curve.value(here);
      return motion.scale * curve.value(here + half);
    }
    if (motion.kind == PrescribedMotion::Kind::acceleration) {
      const double* v = &now.velocity[at];
      const double along = v[0] * row.direction.x + v[1] * row.direction.y + v[2] * row.direction.z;
      return along + now.interval() * motion.scale * load_value(curve, now.time - start, now.step);
    }
    const double displacement = displacement_along(now, row.direction, at);
    double target = motion.scale * curve.value(now.time + now.step - start);
    if (remembers(row)) {
      double& offset = memory[row.offset];
      if (std::isnan(offset)) offset = displacement;
      target += offset;
    }
    return (target - displacement) / now.step;
  }

  void correct_node(const Moment& now, std::size_t h, std::span<double> memory,
                    std::span<double> acceleration) const {
    const Index node = nodes_[h];
    const std::size_t at = 3 * static_cast<std::size_t>(node);
    const double interval = now.interval(), middle = now.time + 0.5 * now.step;
    double* a = &acceleration[at];
    const double* early = &now.velocity[at];
    Vector velocity{early[0] + a[0] * interval, early[1] + a[1] * interval, early[2] + a[2] * interval};
    const Vector free = velocity;

    // Orthonormal directions so far, and the velocity along each.
    Vector axis[3];
    double value[3];
    int count = 0;
    for (std::size_t r = first_row_[h]; r < first_row_[h + 1] && count < 3; ++r) {
      if (!rows_[r].active(middle)) continue;
      Vector d = rows_[r].direction;
      double rest =
          rows_[r].turning != 0 ? turned(now, rows_[r], node, d) : wanted(now, rows_[r], node, memory);
      const Vector own = d;
      for (int k = 0; k < count; ++k) {
        const double share = base::dot(own, axis[k]);
        d = d - share * axis[k];
        rest -= share * value[k];
      }
      const double square = base::dot(d, d);
      if (square < dependent) continue;
      const double length = std::sqrt(square);
      axis[count] = (1.0 / length) * d;
      value[count] = rest / length;
      velocity = velocity + (value[count] - base::dot(velocity, axis[count])) * axis[count];
      ++count;
    }

    double* reaction = &memory[3 * h];
    for (int i = 0; i < 3; ++i) reaction[i] = 0.0;
    if (count == 0) return;
    const double mass = now.mass[static_cast<std::size_t>(node)];
    for (int i = 0; i < 3; ++i) {
      const double change = component(velocity, i) - component(free, i);
      if (change == 0.0) continue;  // leave free components their very bits
      reaction[i] = mass * change / interval;
      a[i] = (component(velocity, i) - early[i]) / interval;
    }
  }

  const model::Model& model_;
  std::vector<Index> nodes_;            // ascending
  std::vector<std::size_t> first_row_;  // [held + 1]
  std::vector<Row> rows_;
  std::size_t offset_count_ = 0;
};

}  // namespace

void add_held_nodes(const model::Model& model, ConstraintList& list, deck::Diagnostics& diagnostics) {
  if (model.fixed.empty() && model.motions.empty()) return;
  list.push_back(std::make_unique<HeldNodes>(model, diagnostics));
}

}  // namespace cleave::solver
