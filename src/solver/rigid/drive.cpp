#include "solver/rigid/drive.hpp"

#include <algorithm>

namespace cleave::solver {

using base::cross;
using base::dot;

namespace {

constexpr double dependent = 1e-10;  // squared sine of the angle below which two directions are one

/// A unit vector across one.
Vector across(const Vector& d) {
  const Vector least = std::abs(d.x) <= std::abs(d.y) && std::abs(d.x) <= std::abs(d.z) ? Vector{1, 0, 0}
                       : std::abs(d.y) <= std::abs(d.z)                                 ? Vector{0, 1, 0}
                                                                                        : Vector{0, 0, 1};
  const Vector s = cross(d, least);
  return (1.0 / std::sqrt(dot(s, s))) * s;
}

}  // namespace

void Known::add(const Vector& direction, double wanted) {
  if (count == 3) return;
  Vector d = direction;
  double rest = wanted;
  for (int k = 0; k < count; ++k) {
    const double share = dot(direction, axis[k]);
    d = d - share * axis[k];
    rest -= share * value[k];
  }
  const double square = dot(d, d);
  if (square < dependent) return;
  const double length = std::sqrt(square);
  axis[count] = (1.0 / length) * d;
  value[count++] = rest / length;
}

Vector Known::sum() const {
  Vector all{0, 0, 0};
  for (int k = 0; k < count; ++k) all = all + value[k] * axis[k];
  return all;
}

int Known::free(Vector (&out)[3]) const {
  if (count == 3) return 0;
  if (count == 2) {
    out[0] = cross(axis[0], axis[1]);
    return 1;
  }
  if (count == 1) {
    out[0] = across(axis[0]);
    out[1] = cross(axis[0], out[0]);
    return 2;
  }
  out[0] = {1, 0, 0}, out[1] = {0, 1, 0}, out[2] = {0, 0, 1};
  return 3;
}

Drives::Drives(const model::Model& model) : model_(model) {
  for (std::size_t b = 0; b < model.rigid_bodies.size(); ++b) {
    first_.push_back(rows_.size());
    for (auto motion = model.rigid_motions.rbegin(); motion != model.rigid_motions.rend(); ++motion)
      if (motion->body == static_cast<Index>(b)) add(*motion, rows_);
    const model::RigidHold& hold = model.rigid_bodies[b].hold;
    for (int k = 0; k < 6; ++k)
      if (hold.directions >> k & 1u)
        rows_.push_back({hold.frame.axis[k % 3], k >= 3, false, 0.0, model::forever, nullptr});
  }
  first_.push_back(rows_.size());
}

void Drives::add(const model::RigidMotion& motion, std::vector<Row>& rows) const {
  Row row{motion.direction, motion.rotation, motion.local, motion.birth, motion.death, &motion};
  rows.push_back(row);
  if (motion.only_direction) return;
  row.motion = nullptr;
  row.direction = across(motion.direction);
  rows.push_back(row);
  row.direction = cross(motion.direction, row.direction);
  rows.push_back(row);
}

void Drives::warn_of_conflicts(deck::Diagnostics& diagnostics) const {
  const auto clash = [](const Row& first, const Row& second) {
    if (!first.motion || first.rotation != second.rotation || first.local != second.local) return false;
    if (first.birth >= second.death || second.birth >= first.death) return false;
    const double cosine = dot(first.direction, second.direction);
    return 1.0 - cosine * cosine <= dependent;
  };
  for (std::size_t b = 0; b + 1 < first_.size(); ++b) {
    const Row* told = nullptr;
    bool held = false;
    for (std::size_t p = first_[b]; p < first_[b + 1] && !told; ++p)
      for (std::size_t q = p + 1; q < first_[b + 1] && !told; ++q)
        if (clash(rows_[p], rows_[q])) told = &rows_[p], held = !rows_[q].motion;
    if (told)
      diagnostics.warning(told->motion->place, "BOUNDARY_PRESCRIBED_MOTION_RIGID", "",
                          "rigid body " + std::to_string(model_.rigid_bodies[b].id) +
                              (held ? " is held and told to " : " is told twice to ") +
                              (told->rotation ? "turn about" : "move along") +
                              " the same direction at the same time",
                          "the last motion is used, and a motion prevails over what is held");
  }
}

double Drives::wanted(const Row& row, std::size_t number, const Moment& now, const BodyNow& at,
                      std::span<double> memory) const {
  if (!row.motion) return 0.0;
  using Kind = model::PrescribedMotion::Kind;
  const model::RigidMotion& motion = *row.motion;
  const model::Curve& curve = model_.curves[static_cast<std::size_t>(motion.curve)];
  const double start = std::max(row.birth, 0.0);  // the curve begins when the motion is born
  if (motion.kind == Kind::velocity)
    return motion.scale * load_value(curve, now.time - start + 0.5 * now.step, now.step);
  if (motion.kind == Kind::acceleration)
    return dot(row.rotation ? at.spin : at.velocity, direction(row, at)) +
           now.interval() * motion.scale * load_value(curve, now.time - start, now.step);
  double &path = memory[2 * number], &born = memory[2 * number + 1];
  // The way of the centre along a direction fixed in space is where it is.
  const double travelled = row.rotation || row.local ? path : dot(at.displacement, row.direction);
  if (std::isnan(born)) born = row.birth > 0.0 ? travelled : 0.0;
  return (motion.scale * curve.value(now.time + now.step - start) + born - travelled) / now.step;
}

Known Drives::known(std::size_t body, bool rotation, const Moment& now, const BodyNow& at,
                    std::span<double> memory) const {
  Known all;
  const double middle = now.time + 0.5 * now.step;
  for (std::size_t r = first_[body]; r < first_[body + 1]; ++r)
    if (rows_[r].rotation == rotation && middle >= rows_[r].birth && middle < rows_[r].death)
      all.add(direction(rows_[r], at), wanted(rows_[r], r, now, at, memory));
  return all;
}

void Drives::advance(std::size_t body, const Moment& now, const BodyNow& at, const Vector& velocity,
                     const Vector& spin, std::span<double> memory) const {
  for (std::size_t r = first_[body]; r < first_[body + 1]; ++r)
    memory[2 * r] += now.step * dot(rows_[r].rotation ? spin : velocity, direction(rows_[r], at));
}

}  // namespace cleave::solver
