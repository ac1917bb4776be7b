/// Constraints, motions, loads, walls, damping, masses, initial velocities.

#include <algorithm>

#include "model/write/references.hpp"

namespace cleave::model {
namespace {

class ActionWriter {
 public:
  ActionWriter(const Model& model, DeckText& out)
      : model_(model), out_(out), references_(out, write_named_frames(model, out)) {}

  void rigid() { write_rigid(model_, references_, out_); }

  void fixed(const FixedNodes& f) {
    const Id cid = f.local ? references_.frame(f.frame) : 0;
    const bool timed = f.birth != 0.0 || f.death < forever, named = f.id != 0 || !f.title.empty();
    const auto* set = f.nodes.size() == 1 ? nullptr : set_of(model_.node_sets, f.nodes);
    const std::string name = std::string("BOUNDARY_SPC_") + (set ? "SET" : "NODE") +
                             (timed ? "_BIRTH_DEATH" : "") + (named ? "_ID" : "");
    const auto bit = [&](unsigned k) { return static_cast<int>(f.directions >> k & 1u); };
    const auto row = [&](Id id) {
      if (named) out_.id_line(f.id, f.title);
      out_.line({id, cid, bit(0), bit(1), bit(2), bit(3), bit(4), bit(5)});
      if (timed) out_.line({f.birth, f.death});
    };
    out_.keyword(name);
    if (set) return row(set->id);
    for (const Index i : f.nodes) row(node(i));
  }

  void motion(const PrescribedMotion& m) {
    int dof = m.only_direction ? axis_of(m.direction) : 0;
    const Id vid = dof == 0 ? references_.vector(m.direction) : 0;
    if (dof == 0) dof = m.only_direction ? 4 : -4;
    const Vector &d = m.direction, &c = m.centre;
    if (m.rotation) dof = (m.radial_free ? -1 : 1) * (8 + axis_of(d));
    const int vad = static_cast<int>(m.kind);
    const bool named = m.id != 0 || !m.title.empty();
    const auto* set = m.nodes.size() == 1 ? nullptr : set_of(model_.node_sets, m.nodes);
    const auto row = [&](Id id) {
      if (named) out_.id_line(m.id, m.title);
      out_.line({id, dof, vad, curve(m.curve), m.scale, vid, m.death, m.birth});
      if (m.rotation && d.x == 1) out_.line({c.y, c.z});
      if (m.rotation && d.y == 1) out_.line({c.z, c.x});
      if (m.rotation && d.z == 1) out_.line({c.x, c.y});
    };
    out_.keyword(std::string("BOUNDARY_PRESCRIBED_MOTION_") + (set ? "SET" : "NODE") + (named ? "_ID" : ""));
    if (set) return row(set->id);
    for (const Index i : m.nodes) row(node(i));
  }

  void load(const NodeLoad& l) {
    int dof = l.follower ? 4 : axis_of(l.direction);
    const Id cid = dof == 0 ? references_.frame_along(l.direction) : 0;
    if (dof == 0) dof = 1;
    const auto* set = l.nodes.size() == 1 ? nullptr : set_of(model_.node_sets, l.nodes);
    const auto row = [&](Id id) {
      const auto follow = [&](int k) { return l.follow[k] < 0 ? Id(0) : node(l.follow[k]); };
      out_.line({id, dof, curve(l.curve), l.scale, cid, follow(0), follow(1), follow(2)});
    };
    out_.keyword(set ? "LOAD_NODE_SET" : "LOAD_NODE_POINT");
    if (set) return row(set->id);
    for (const Index i : l.nodes) row(node(i));
  }

  void pressure(const SegmentLoad& l) {
    if (const auto* set = l.quadratic.empty() ? set_of(model_.segment_sets, l.segments) : nullptr) {
      out_.keyword("LOAD_SEGMENT_SET");
      return out_.line({set->id, curve(l.curve), l.scale, l.arrival});
    }
    out_.keyword("LOAD_SEGMENT");
    for (const Segment& s : l.segments)
      out_.line({curve(l.curve), l.scale, l.arrival, node(s.node[0]), node(s.node[1]), node(s.node[2]),
                 node(s.node[3])});
    for (const auto& f : l.quadratic) {
      out_.line(
          {curve(l.curve), l.scale, l.arrival, node(f[0]), node(f[1]), node(f[2]), node(f[2]), node(f[3])});
      out_.line({node(f[4]), node(f[5]), 0});
    }
  }

  void body(const BodyLoad& l) {
    if (l.generalized) return generalized(l);
    const int axis = axis_of(l.direction);
    static constexpr std::string_view names[] = {"", "X", "Y", "Z"};
    if (!l.rotation && axis == 0) {
      out_.keyword("LOAD_BODY_VECTOR");
      out_.line({curve(l.curve), l.scale});
      return out_.line({l.direction.x, l.direction.y, l.direction.z});
    }
    const Id cid = axis == 0 ? references_.frame_along(l.direction) : 0;
    out_.keyword(std::string("LOAD_BODY_") + (l.rotation ? "R" : "") +
                 std::string(names[axis == 0 ? 1 : axis]));
    out_.line({curve(l.curve), l.scale, 0, l.centre.x, l.centre.y, l.centre.z, cid});
  }

  void generalized(const BodyLoad& l) {
    const auto* set = set_of(model_.node_sets, flagged(l.nodes));
    if (!set) return;
    static constexpr std::string_view types[] = {"CENT", "CORI", "ROTA"};
    const Vector none{0, 0, 0}, &d = l.direction;
    const Vector straight = l.rotation ? none : d, turning = l.rotation ? d : none;
    out_.keyword("LOAD_BODY_GENERALIZED_SET_NODE");
    out_.line({set->id, 0, curve(l.curve), 0, l.centre.x, l.centre.y, l.centre.z});
    out_.line({straight.x, straight.y, straight.z, turning.x, turning.y, turning.z, 0,
               types[static_cast<int>(l.angular)]});
  }

  /// The part set whose nodes the body loads are limited to.
  void body_parts() {
    for (const BodyLoad& l : model_.body_loads) {
      if (l.nodes.empty() || l.generalized) continue;
      for (const auto& set : model_.part_sets) {
        std::vector<bool> flags(l.nodes.size(), false);
        for (const auto* groups : {&model_.mesh.solids, &model_.mesh.shells, &model_.mesh.beams})
          for (const Elements& group : *groups) {
            const int n = nodes_of(group.shape);
            for (std::size_t e = 0; e < group.count(); ++e)
              if (std::find(set.members.begin(), set.members.end(), group.part[e]) != set.members.end())
                for (int a = 0; a < n; ++a) flags[group.node[e * n + a]] = true;
          }
        if (flags != l.nodes) continue;
        out_.keyword("LOAD_BODY_PARTS");
        return out_.line({set.id, ""});
      }
    }
  }

  void wall(const RigidWall& w) {
    if (w.geometric) return geometric_wall(w);
    const bool named = w.id != 0 || !w.title.empty();
    out_.keyword(std::string("RIGIDWALL_PLANAR") + (w.orthotropic ? "_ORTHO" : "") +
                 (w.finite ? "_FINITE" : "") + (w.mass > 0.0 ? "_MOVING" : "") +
                 (w.soft_cycles > 0 ? "_FORCES" : "") + (named ? "_ID" : ""));
    if (named) out_.id_line(w.id, w.title);
    const Vector head = w.origin + w.normal, edge = w.origin + w.edge_l;
    out_.line({wall_nodes(w), 0, 0, 0.0, w.birth, w.death});
    out_.line({w.origin.x, w.origin.y, w.origin.z, head.x, head.y, head.z, w.friction, w.velocity_limit});
    if (w.orthotropic) {
      out_.line({w.static_friction[0], w.static_friction[1], w.dynamic_friction[0], w.dynamic_friction[1],
                 w.friction_decay[0], w.friction_decay[1]});
      const auto at = [&](int k) { return w.friction_node[k] < 0 ? Id(0) : node(w.friction_node[k]); };
      out_.line({at(0), at(1), w.friction_axis.x, w.friction_axis.y, w.friction_axis.z});
    }
    if (w.finite) out_.line({edge.x, edge.y, edge.z, w.length_l, w.length_m});
    if (w.mass > 0.0) out_.line({w.mass, w.speed});
    if (w.soft_cycles > 0) out_.line({w.soft_cycles, 0});
  }

  void geometric_wall(const RigidWall& w) {
    using Shape = RigidWall::Shape;
    const bool named = w.id != 0 || !w.title.empty(), round = w.shape >= Shape::cylinder;
    static constexpr std::string_view names[] = {"FLAT", "PRISM", "CYLINDER", "SPHERE"};
    out_.keyword("RIGIDWALL_GEOMETRIC_" + std::string(names[static_cast<int>(w.shape)]) +
                 (w.interior ? "_INTERIOR" : "") + (w.motion >= 0 ? "_MOTION" : "") + (named ? "_ID" : ""));
    if (named) out_.id_line(w.id, w.title);
    const Vector head = w.origin + w.normal, edge = w.origin + w.edge_l;
    out_.line({wall_nodes(w), 0, 0, w.birth, w.death});
    out_.line({w.origin.x, w.origin.y, w.origin.z, head.x, head.y, head.z, w.friction});
    if (w.shape == Shape::plane) out_.line({edge.x, edge.y, edge.z, w.length_l, w.length_m});
    if (w.shape == Shape::prism) out_.line({edge.x, edge.y, edge.z, w.length_l, w.length_m, w.length_n});
    if (round) out_.line({w.radius, w.length_n});
    if (w.motion >= 0)
      out_.line({curve(w.motion), w.motion_is_displacement ? 1 : 0, w.motion_direction.x,
                 w.motion_direction.y, w.motion_direction.z});
  }

  /// Friction and damping are written as they act, so their scale factors are 1.
  void contact(const Contact& c) {
    const bool single = c.search == Contact::Search::single;
    out_.keyword(c.keyword + (c.named ? "_ID" : ""));
    if (c.named) out_.id_line(c.id, c.title);
    out_.line({c.a.id, single ? Id(0) : c.b.id, c.a.type, single ? 0 : c.b.type});
    out_.line({c.part_friction.empty() ? c.static_friction : -1.0, c.dynamic_friction, c.friction_decay,
               c.viscous_limit, 100.0 * c.damping, 0, c.birth, c.death});
    out_.line({c.scale_a, c.scale_b, c.tie_distance > 0.0 ? -c.tie_distance : 0.0});
    if (c.keyword.find("_ERODING_") != std::string::npos) out_.line({0, c.eroding ? 1 : 0, 1});
    if (c.tied) return;
    out_.line({c.soft, c.soft_scale, 0, c.extension});
    out_.line({c.release, 0, 0, 0, 0, 0, c.solid_thickness, c.solid_modulus});
    out_.line({0, c.ignore});
  }

  void damping() {
    for (const GlobalDamping& d : model_.global_damping) {
      out_.keyword("DAMPING_GLOBAL");
      out_.line({curve(d.curve), d.value, d.factor[0], d.factor[1], d.factor[2]});
    }
    for (const Part& p : model_.parts) {
      if (p.mass_damping_curve >= 0) {
        out_.keyword("DAMPING_PART_MASS");
        out_.line({p.id, curve(p.mass_damping_curve), p.mass_damping, 1});
        out_.line({p.mass_damping_factor[0], p.mass_damping_factor[1], p.mass_damping_factor[2]});
      }
      if (p.stiffness_damping != 0.0) {
        out_.keyword("DAMPING_PART_STIFFNESS");
        out_.line({p.id, p.stiffness_damping});
      }
    }
  }

  void masses() {
    if (model_.point_masses.empty()) return;
    out_.keyword("ELEMENT_MASS");
    for (const PointMass& m : model_.point_masses) out_.line({m.id, node(m.node), m.mass});
  }

  void velocities() {
    const auto& v = model_.initial_velocity;
    if (std::all_of(v.begin(), v.end(), [](double c) { return c == 0.0; })) return;
    bool uniform = true;
    for (std::size_t i = 3; i < v.size() && uniform; ++i) uniform = v[i] == v[i - 3];
    if (uniform) {
      out_.keyword("INITIAL_VELOCITY");
      out_.line({0, 0});
      return out_.line({v[0], v[1], v[2]});
    }
    out_.keyword("INITIAL_VELOCITY_NODE");
    for (std::size_t i = 0; i < v.size(); i += 3)
      if (v[i] != 0.0 || v[i + 1] != 0.0 || v[i + 2] != 0.0)
        out_.line({node(static_cast<Index>(i / 3)), v[i], v[i + 1], v[i + 2]});
  }

  void precrack(const Precrack& c) {
    out_.keyword("BOUNDARY_PRECRACK");
    out_.line({c.part, 1, static_cast<Id>(c.points.size())});
    for (const Vector& p : c.points) out_.line({p.x, p.y, p.z});
  }

  void incident(const IncidentWave& w) {
    const auto* set = set_of(model_.segment_sets, w.segments);
    if (!set) return;
    const bool shear = w.kind == IncidentWave::Kind::shear;
    out_.keyword("LOAD_INCIDENT_WAVE");
    out_.line({set->id, shear ? 2 : 1, curve(w.curve), w.scale, w.arrival});
    out_.line({w.direction.x, w.direction.y, w.direction.z, w.reference.x, w.reference.y, w.reference.z});
    if (shear) out_.line({w.polarisation.x, w.polarisation.y, w.polarisation.z});
  }

  void stresses() {
    for (const InitialStress& s : model_.initial_stress) {
      const auto& c = s.stress;
      out_.keyword(s.shell ? "INITIAL_STRESS_SHELL" : "INITIAL_STRESS_SOLID");
      if (s.shell) {
        out_.line({s.element, 1, 1});
        out_.line({0.0, c[0], c[1], c[2], c[3], c[4], c[5]});
      } else {
        out_.line({s.element, 1});
        out_.line({c[0], c[1], c[2], c[3], c[4], c[5]});
      }
    }
  }

  void absorbing(const AbsorbingFaces& a) {
    const auto* set = set_of(model_.segment_sets, a.segments);
    if (!set) return;
    out_.keyword("BOUNDARY_NON_REFLECTING");
    out_.line({set->id, a.dilatational ? 0.0 : 1.0, a.shear ? 0.0 : 1.0});
  }

 private:
  Id node(Index i) const { return model_.mesh.nodes.id[i]; }
  Id curve(Index i) const { return curve_id(model_, i); }
  /// Node set of a wall, 0 for all nodes.
  Id wall_nodes(const RigidWall& w) const {
    std::size_t rigid = 0;  // nodes of rigid bodies are no wall's
    for (const RigidBody& body : model_.rigid_bodies) rigid += body.nodes.size();
    const bool all = w.nodes.size() + rigid == model_.mesh.nodes.count();
    const auto* set = all ? nullptr : set_of(model_.node_sets, w.nodes);
    return set ? set->id : 0;
  }

  const Model& model_;
  DeckText& out_;
  References references_;
};

}  // namespace

void write_actions(const Model& model, DeckText& out) {
  ActionWriter write(model, out);
  for (const auto& f : model.fixed) write.fixed(f);
  for (const auto& m : model.motions) write.motion(m);
  for (const auto& l : model.node_loads) write.load(l);
  for (const auto& l : model.segment_loads) write.pressure(l);
  for (const auto& l : model.body_loads) write.body(l);
  write.body_parts();
  for (const auto& w : model.walls) write.wall(w);
  for (const auto& c : model.contacts) write.contact(c);
  for (const auto& a : model.absorbing) write.absorbing(a);
  for (const auto& c : model.precracks) write.precrack(c);
  for (const auto& w : model.incident_waves) write.incident(w);
  write.rigid();
  write.damping();
  write.masses();
  write.velocities();
  write.stresses();
}

}  // namespace cleave::model
