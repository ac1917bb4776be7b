/// Rigid bodies, their motions and loads.

#include <algorithm>

#include "model/write/references.hpp"

namespace cleave::model {
namespace {

double value_of(const MaterialCard& card, std::string_view name) {
  for (const auto& value : card.values)
    if (value.name == name || value.name.substr(0, value.name.find('/')) == name) return value.number;
  return 0.0;
}

/// Coordinate systems that the cards of *MAT_RIGID name by number.
std::vector<std::pair<Id, Frame>> named_frames(const Model& model) {
  std::vector<std::pair<Id, Frame>> named;
  const auto add = [&](double number, const Frame& frame) {
    const Id id = static_cast<Id>(number);
    if (std::none_of(named.begin(), named.end(), [&](const auto& one) { return one.first == id; }))
      named.emplace_back(id, frame);
  };
  for (const Part& part : model.parts) {
    if (!part.rigid) continue;
    const auto card = std::find_if(model.materials.begin(), model.materials.end(), [&](const auto& m) {
      return m.id == part.material_id && m.keyword == "MAT_RIGID";
    });
    if (card == model.materials.end()) continue;
    if (part.rigid->hold.local) add(value_of(*card, "CON1"), part.rigid->hold.frame);
    const bool vectors = value_of(*card, "V1") != 0.0 || value_of(*card, "V2") != 0.0 ||
                         value_of(*card, "V3") != 0.0 || value_of(*card, "A2") != 0.0 ||
                         value_of(*card, "A3") != 0.0;
    if (part.rigid->has_axes && !vectors) add(value_of(*card, "LCO"), part.rigid->axes);
  }
  return named;
}

class RigidWriter {
 public:
  RigidWriter(const Model& model, References& references, DeckText& out)
      : model_(model), references_(references), out_(out) {}

  void body(const RigidBody& b) {
    if (b.parts.empty()) {
      nodal(b);
    } else {
      for (std::size_t k = 1; k < b.parts.size(); ++k) {
        out_.keyword("CONSTRAINED_RIGID_BODIES");
        out_.line({b.id, part(b.parts[k])});
      }
      for (const Index a : b.extra) {
        out_.keyword("CONSTRAINED_EXTRA_NODES_NODE");
        out_.line({b.id, node(a), std::binary_search(b.added.begin(), b.added.end(), a) ? 1 : 0});
      }
    }
    if (!b.has_velocity) return;
    const RigidInertia* stated = b.parts.empty() ? b.inertia.get() : lead(b).inertia.get();
    const auto same = [](const Vector& p, const Vector& q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
    if (stated && same(stated->velocity, b.velocity) && same(stated->spin, b.spin)) return;
    out_.keyword("INITIAL_VELOCITY_RIGID_BODY");
    out_.line({b.id, b.velocity.x, b.velocity.y, b.velocity.z, b.spin.x, b.spin.y, b.spin.z});
  }

  void motion(const RigidMotion& m) {
    int dof = m.only_direction && !m.local ? axis_of(m.direction) : 0;
    const Id vid = dof == 0 ? references_.vector(m.direction) : 0;
    if (dof == 0) dof = 4;
    if (m.rotation) dof += 4;
    if (!m.only_direction) dof = -dof;
    const int vad = m.kind == PrescribedMotion::Kind::velocity       ? 0
                    : m.kind == PrescribedMotion::Kind::acceleration ? 1
                                                                     : 2;
    const bool named = m.id != 0 || !m.title.empty();
    out_.keyword(std::string("BOUNDARY_PRESCRIBED_MOTION_RIGID") + (m.local ? "_LOCAL" : "") +
                 (named ? "_ID" : ""));
    if (named) out_.id_line(m.id, m.title);
    out_.line({id(m.body), dof, vad, curve_id(model_, m.curve), m.scale, vid, m.death, m.birth});
  }

  void load(const RigidLoad& l) {
    int dof = l.follower ? 4 : axis_of(l.direction);
    const Id cid = dof == 0 ? references_.frame_along(l.direction) : 0;
    if (dof == 0) dof = 1;
    if (l.moment) dof += 4;
    const bool named = l.id != 0 || !l.title.empty();
    const auto follow = [&](int k) { return l.follow[k] < 0 ? Id(0) : node(l.follow[k]); };
    out_.keyword(std::string("LOAD_RIGID_BODY") + (named ? "_ID" : ""));
    if (named) out_.id_line(l.id, l.title);
    out_.line({id(l.body), dof, curve_id(model_, l.curve), l.scale, cid, follow(0), follow(1), follow(2)});
  }

  /// Stated velocities that gave way to those of the nodes (IRIGID).
  void resets() {
    int code = 0;
    for (const RigidBody& b : model_.rigid_bodies) {
      if (b.has_velocity) continue;
      if (b.parts.empty() ? b.inertia != nullptr : lead(b).inertia != nullptr)
        code |= b.parts.empty() ? 2 : 1;
    }
    if (code == 0) return;
    out_.keyword("INITIAL_VELOCITY");
    out_.line({0, 0, 0, code});
    out_.line({0.0, 0.0, 0.0});
  }

 private:
  void nodal(const RigidBody& b) {
    const auto* set = set_of(model_.node_sets, b.extra);
    const Id axes = b.has_axes ? references_.frame(b.axes) : 0;
    const bool held = b.hold.directions != 0;
    const Id frame = held && b.hold.local ? references_.frame(b.hold.frame) : 0;
    out_.keyword(
        std::string("CONSTRAINED_NODAL_RIGID_BODY") + (held ? "_SPC" : "") + (b.inertia ? "_INERTIA" : ""),
        b.title);
    out_.line({b.id, axes, set ? set->id : 0});
    if (held) {
      int digits = 0;
      for (unsigned k = 0; k < 6; ++k) digits = 10 * digits + static_cast<int>(b.hold.directions >> k & 1u);
      out_.line({-1.0, static_cast<double>(frame), static_cast<double>(digits)});
    }
    if (b.inertia) write_inertia(*b.inertia, model_, out_);
  }

  const Part& lead(const RigidBody& b) const { return model_.parts[static_cast<std::size_t>(b.parts[0])]; }
  Id node(Index a) const { return model_.mesh.nodes.id[static_cast<std::size_t>(a)]; }
  Id part(Index p) const { return model_.parts[static_cast<std::size_t>(p)].id; }
  Id id(Index b) const { return model_.rigid_bodies[static_cast<std::size_t>(b)].id; }

  const Model& model_;
  References& references_;
  DeckText& out_;
};

}  // namespace

void write_inertia(const RigidInertia& s, const Model& model, DeckText& out) {
  const Id node = s.node < 0 ? Id(0) : model.mesh.nodes.id[static_cast<std::size_t>(s.node)];
  out.line({s.centre.x, s.centre.y, s.centre.z, s.mass, 0, node});
  out.line({s.tensor.xx, s.tensor.xy, s.tensor.zx, s.tensor.yy, s.tensor.yz, s.tensor.zz});
  out.line({s.velocity.x, s.velocity.y, s.velocity.z, s.spin.x, s.spin.y, s.spin.z});
}

Id write_named_frames(const Model& model, DeckText& out) {
  Id last = 0;
  for (const auto& [id, frame] : named_frames(model)) {
    const Vector &x = frame.axis[0], &y = frame.axis[1];
    out.keyword("DEFINE_COORDINATE_VECTOR");
    out.line({id, x.x, x.y, x.z, y.x, y.y, y.z});
    last = std::max(last, id);
  }
  return last;
}

void write_rigid(const Model& model, References& references, DeckText& out) {
  RigidWriter write(model, references, out);
  for (const RigidBody& body : model.rigid_bodies) write.body(body);
  for (const RigidMotion& motion : model.rigid_motions) write.motion(motion);
  for (const RigidLoad& load : model.rigid_loads) write.load(load);
  write.resets();
}

}  // namespace cleave::model
