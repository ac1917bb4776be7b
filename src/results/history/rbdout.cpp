/// rbdout: position, velocity, acceleration and rotation of each rigid body.

#include <cmath>

#include "results/history.hpp"
#include "results/text.hpp"

namespace cleave::results {
namespace {

/// Rotation since the start as a vector along its axis [radian].
void rotation_vector(const double (&q)[4], double (&out)[3]) {
  const double sine = std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double angle = 2.0 * std::atan2(q[0] < 0.0 ? -sine : sine, std::abs(q[0]));
  for (int k = 0; k < 3; ++k) out[k] = sine > 0.0 ? angle * q[k + 1] / sine : 0.0;
}

/// The body's own axes now, as columns; m[row][column]. Those of the deck, or the global ones at the start.
void matrix(const double (&q)[4], const model::RigidBody& body, double (&m)[3][3]) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  for (int j = 0; j < 3; ++j) {
    const model::Vector& a = body.axes.axis[j];
    for (int i = 0; i < 3; ++i) m[i][j] = turn[i][0] * a.x + turn[i][1] * a.y + turn[i][2] * a.z;
  }
}

class Rbdout final : public History {
 public:
  explicit Rbdout(const model::Model& model) : model_(model) {}
  std::string_view name() const override { return "rbdout"; }
  bool per_entity() const override { return true; }
  std::vector<std::string> columns() const override {
    std::vector<std::string> names;
    for (const char* what : {"coordinate", "displacement", "velocity", "acceleration", "rotation", "spin",
                             "spin_rate", "angular_momentum", "holding_force", "holding_moment"})
      for (const char* axis : {"x_", "y_", "z_"}) names.push_back(std::string(axis) + what);
    for (const char* name : {"mass", "kinetic_energy"}) names.emplace_back(name);
    return names;
  }
  void legend(std::string& ascii) const override { append_titles(ascii, model_.rigid_bodies); }

  void write(const Snapshot& now, std::string& ascii, Rows& rows) override {
    append_format(ascii, "\n\n r i g i d   b o d y   m o t i o n   a t  cycle=%8lld  time=%13.6E\n",
                  static_cast<long long>(now.state().cycle), column(now.state().time));
    for (std::size_t b = 0; b < now.frame().bodies.size(); ++b) {
      const solver::BodyMotion& body = now.frame().bodies[b];
      double rotation[3], axes[3][3];
      rotation_vector(body.quaternion, rotation);
      matrix(body.quaternion, model_.rigid_bodies[b], axes);
      std::vector<double> values;
      const auto add = [&](const double(&v)[3]) { values.insert(values.end(), v, v + 3); };
      add(body.position);
      add(body.displacement);
      add(body.velocity);
      add(body.acceleration);
      add(rotation);
      add(body.spin);
      add(body.spin_rate);
      add(body.momentum);
      add(body.force);
      add(body.moment);
      values.push_back(body.mass);
      values.push_back(body.kinetic);
      const model::RigidBody& asked = model_.rigid_bodies[b];
      rows.row(asked.id, values);
      append_format(ascii, "\n %s rigid body%8lld\n", asked.parts.empty() ? "nodal" : "     ",
                    static_cast<long long>(asked.id));
      const auto line = [&](const char* what, const double(&v)[3]) {
        append_format(ascii, "   %-15s%14.4E%14.4E%14.4E", what, column(v[0]), column(v[1]), column(v[2]));
      };
      ascii +=
          "   global                  x             y             z                       x-rot"
          "         y-rot         z-rot\n";
      line("coordinates:", body.position);
      ascii += '\n';
      line("displacements:", body.displacement);
      line("", rotation);
      ascii += '\n';
      line("velocities:", body.velocity);
      line("", body.spin);
      ascii += '\n';
      line("accelerations:", body.acceleration);
      line("", body.spin_rate);
      ascii +=
          "\n\n principal or user defined local coordinate direction vectors\n"
          "                     a             b             c\n";
      const char* names[3] = {"row 1", "row 2", "row 3"};
      for (int i = 0; i < 3; ++i)
        append_format(ascii, "   %s%14.4E%14.4E%14.4E\n", names[i], column(axes[i][0]), column(axes[i][1]),
                      column(axes[i][2]));
    }
  }

 private:
  const model::Model& model_;
};

std::unique_ptr<Writer> build(const Context& context) {
  if (context.model.rigid_bodies.empty()) return nullptr;
  return history_writer<Rbdout>(context, context.model.requests.rbdout);
}

}  // namespace

extern const WriterEntry rbdout{"rbdout", build};

}  // namespace cleave::results
