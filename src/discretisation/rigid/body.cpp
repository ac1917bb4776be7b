#include "discretisation/rigid/body.hpp"

#include <algorithm>
#include <cmath>

#include "base/symmetric_eigen.hpp"

namespace cleave::discretisation {

using base::cross;
using model::Vector;

namespace {

constexpr double slight = 1e-12;  // of the largest moment: below it a body has no inertia about an axis

void principal_axes(RigidBody& body) {
  const auto& t = body.whole.tensor;
  double a[3][3] = {{t.xx, t.xy, t.zx}, {t.xy, t.yy, t.yz}, {t.zx, t.yz, t.zz}};
  base::symmetric_eigen<3>(a, body.axis);
  const double largest = std::max({a[0][0], a[1][1], a[2][2], 0.0});
  for (int k = 0; k < 3; ++k) {
    body.moment[k] = a[k][k] > slight * largest ? a[k][k] : 0.0;
    body.inverse[k] = body.moment[k] > 0.0 ? 1.0 / body.moment[k] : 0.0;
  }
  const auto& e = body.axis;  // a right-handed system
  const Vector first{e[0][0], e[1][0], e[2][0]}, second{e[0][1], e[1][1], e[2][1]};
  const Vector third = cross(first, second);
  body.axis[0][2] = third.x, body.axis[1][2] = third.y, body.axis[2][2] = third.z;
}

/// Components along the principal axes.
Vector to_axes(const RigidBody& body, const Vector& v) {
  const auto& e = body.axis;
  return {e[0][0] * v.x + e[1][0] * v.y + e[2][0] * v.z, e[0][1] * v.x + e[1][1] * v.y + e[2][1] * v.z,
          e[0][2] * v.x + e[1][2] * v.y + e[2][2] * v.z};
}
Vector from_axes(const RigidBody& body, const Vector& v) {
  const auto& e = body.axis;
  return {e[0][0] * v.x + e[0][1] * v.y + e[0][2] * v.z, e[1][0] * v.x + e[1][1] * v.y + e[1][2] * v.z,
          e[2][0] * v.x + e[2][1] * v.y + e[2][2] * v.z};
}

class Maker {
 public:
  Maker(const model::Model& model, const std::vector<std::unique_ptr<const Block>>& blocks,
        deck::Diagnostics& diagnostics)
      : model_(model), diagnostics_(diagnostics), rigid_(count()), other_(count()) {
    const std::vector<Index> body = model::body_of_nodes(model.rigid_bodies, count());
    const base::Array<double> position(model.mesh.nodes.position.begin(), model.mesh.nodes.position.end());
    for (const auto& block : blocks) {
      const auto nodes = block->connectivity();
      if (std::none_of(nodes.begin(), nodes.end(),
                       [&](Index a) { return body[static_cast<std::size_t>(a)] >= 0; }))
        continue;
      BlockState fresh;
      if (!block->initialise(position, fresh).ok) continue;  // the run itself refuses this state
      const bool rigid = model.parts[static_cast<std::size_t>(block->part())].rigid != nullptr;
      block->add_mass(fresh, rigid ? rigid_ : other_);
    }
    for (const model::PointMass& point : model.point_masses)
      other_[static_cast<std::size_t>(point.node)] += point.mass;
    integrate_parts();
  }

  RigidBody make(const model::RigidBody& asked) const {
    RigidBody body;
    body.node = asked.nodes;
    bool stated = asked.inertia != nullptr;
    if (stated) body.whole = of(*asked.inertia);
    for (const Index p : asked.parts) {
      const auto& given = model_.parts[static_cast<std::size_t>(p)].inertia;
      stated = stated || given;
      body.part.push_back(p);
      body.of_part.push_back(given ? of(*given) : part_[static_cast<std::size_t>(p)]);
      body.whole += body.of_part.back();
    }
    for (const Index a : stated ? asked.added : asked.nodes)
      body.whole += point_mass(other_[static_cast<std::size_t>(a)], position(a));
    if (!(body.whole.mass > 0.0))
      diagnostics_.error(asked.place, asked.parts.empty() ? "CONSTRAINED_NODAL_RIGID_BODY" : "PART",
                         asked.parts.empty() ? "NSID" : "PID",
                         "rigid body " + std::to_string(asked.id) + " has no mass",
                         "give it elements, masses at its nodes, or a stated inertia");
    principal_axes(body);
    weigh_nodes(body);
    start(asked, body);
    return body;
  }

 private:
  std::size_t count() const { return model_.mesh.nodes.count(); }
  Vector position(Index a) const {
    const double* x = &model_.mesh.nodes.position[3 * static_cast<std::size_t>(a)];
    return {x[0], x[1], x[2]};
  }
  static RigidMass of(const model::RigidInertia& stated) {
    return {stated.mass, stated.centre, stated.tensor};
  }

  void integrate_parts() {
    part_.resize(model_.parts.size());
    std::vector<Vector> corner;
    for (const auto* groups : {&model_.mesh.solids, &model_.mesh.shells})
      for (const model::Elements& group : *groups) {
        const auto n = static_cast<std::size_t>(model::nodes_of(group.shape));
        corner.resize(n);
        for (std::size_t e = 0; e < group.count(); ++e) {
          const auto p = static_cast<std::size_t>(group.part[e]);
          if (!model_.parts[p].rigid) continue;
          for (std::size_t a = 0; a < n; ++a) corner[a] = position(group.node[n * e + a]);
          part_[p] += element_mass(model_.parts[p], group.shape, corner);
        }
      }
  }

  /// Kinetic energy of lumped masses in the six motions of the body, in units of that of the body: its
  /// largest eigenvalue says how much too heavy they are.
  double heaviest(const RigidBody& body) const {
    double form[6][6] = {};
    double unit[6];
    for (int k = 0; k < 3; ++k) {
      unit[k] = body.whole.mass > 0.0 ? 1.0 / std::sqrt(body.whole.mass) : 0.0;
      unit[3 + k] = std::sqrt(body.inverse[k]);
    }
    for (std::size_t i = 0; i < body.node.size(); ++i) {
      const Vector r = to_axes(body, position(body.node[i]) - body.whole.centre);
      const double row[3][6] = {{1, 0, 0, 0, r.z, -r.y}, {0, 1, 0, -r.z, 0, r.x}, {0, 0, 1, r.y, -r.x, 0}};
      for (int p = 0; p < 6; ++p)
        for (int q = 0; q < 6; ++q)
          for (int k = 0; k < 3; ++k)
            form[p][q] += body.node_mass[i] * row[k][p] * unit[p] * row[k][q] * unit[q];
    }
    double vectors[6][6], most = 0.0;
    base::symmetric_eigen<6>(form, vectors);
    for (int k = 0; k < 6; ++k) most = std::max(most, form[k][k]);
    return most;
  }

  void weigh_nodes(RigidBody& body) const {
    std::size_t bare = 0;
    for (const Index a : body.node)
      bare += rigid_[static_cast<std::size_t>(a)] + other_[static_cast<std::size_t>(a)] > 0.0 ? 0 : 1;
    const double share = bare > 0 ? body.whole.mass / static_cast<double>(body.node.size()) : 0.0;
    std::vector<double> own;
    for (const Index a : body.node) {
      const auto at = static_cast<std::size_t>(a);
      own.push_back(rigid_[at] + other_[at] > 0.0 ? rigid_[at] : share);
      body.node_mass.push_back(own.back() + other_[at]);
    }
    const double most = heaviest(body);
    const double scale = most > 1.0 + 1e-12 ? 1.0 / most : 1.0;
    for (std::size_t i = 0; i < own.size(); ++i)
      body.node_mass[i] = other_[static_cast<std::size_t>(body.node[i])] + scale * own[i];
  }

  /// Velocity and spin at the start: as given, or with the momentum of the nodes.
  void start(const model::RigidBody& asked, RigidBody& body) const {
    body.velocity = asked.velocity;
    body.spin = asked.spin;
    if (asked.has_velocity || model_.initial_velocity.empty()) return;
    RigidBody lumped;
    Vector momentum{0, 0, 0}, angular{0, 0, 0};
    const auto velocity = [&](Index a) {
      const double* v = &model_.initial_velocity[3 * static_cast<std::size_t>(a)];
      return Vector{v[0], v[1], v[2]};
    };
    for (std::size_t i = 0; i < body.node.size(); ++i)
      lumped.whole += point_mass(body.node_mass[i], position(body.node[i]));
    if (!(lumped.whole.mass > 0.0)) return;
    for (std::size_t i = 0; i < body.node.size(); ++i)
      momentum = momentum + body.node_mass[i] * velocity(body.node[i]);
    const Vector mean = (1.0 / lumped.whole.mass) * momentum;
    for (std::size_t i = 0; i < body.node.size(); ++i)
      angular = angular + body.node_mass[i] * cross(position(body.node[i]) - lumped.whole.centre,
                                                    velocity(body.node[i]) - mean);
    principal_axes(lumped);
    const Vector l = to_axes(lumped, angular);
    body.spin =
        from_axes(lumped, {lumped.inverse[0] * l.x, lumped.inverse[1] * l.y, lumped.inverse[2] * l.z});
    body.velocity = mean + cross(body.spin, body.whole.centre - lumped.whole.centre);
  }

  const model::Model& model_;
  deck::Diagnostics& diagnostics_;
  std::vector<double> rigid_, other_;  // [node] lumped masses of rigid elements; of all else
  std::vector<RigidMass> part_;
};

}  // namespace

std::vector<RigidBody> make_bodies(const model::Model& model,
                                   const std::vector<std::unique_ptr<const Block>>& blocks,
                                   deck::Diagnostics& diagnostics) {
  std::vector<RigidBody> bodies;
  if (model.rigid_bodies.empty()) return bodies;
  const Maker maker(model, blocks, diagnostics);
  for (const model::RigidBody& asked : model.rigid_bodies) bodies.push_back(maker.make(asked));
  return bodies;
}

}  // namespace cleave::discretisation
