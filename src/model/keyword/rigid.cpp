/// Keywords of rigid bodies: kept as they are read, made into bodies by finish_rigid().

#include "model/keyword/handler.hpp"
#include "model/keyword/rigid_cards.hpp"

namespace cleave::model {
namespace {

template <std::vector<Entry> RigidDraft::*list>
void keep(Draft& draft, const Entry& entry) {
  (draft.rigid.*list).push_back(entry);
}

constexpr std::string_view motion = "ID HEADING PID DOF VAD LCID SF VID DEATH BIRTH";
constexpr std::string_view nodal = "TITLE PID CID NSID";
constexpr std::string_view nodal_held = "TITLE PID CID NSID CMO CON1 CON2";
constexpr std::string_view stated =
    "TITLE PID CID NSID XC YC ZC TM IRCS NODEID IXX IXY IXZ IYY IYZ IZZ VTX VTY VTZ VRX VRY VRZ XL YL ZL "
    "XLIP YLIP ZLIP CID2";
constexpr std::string_view stated_held =
    "TITLE PID CID NSID CMO CON1 CON2 XC YC ZC TM IRCS NODEID IXX IXY IXZ IYY IYZ IZZ VTX VTY VTZ VRX VRY "
    "VRZ XL YL ZL XLIP YLIP ZLIP CID2";
constexpr std::string_view print_only = "PNODE IPRT";
constexpr auto keep_nodal = keep<&RigidDraft::nodal>;

constexpr Handler handlers[] = {
    {.keyword = "CONSTRAINED_RIGID_BODIES", .honoured = "PIDL PIDC", .take = keep<&RigidDraft::merges>},
    {.keyword = "CONSTRAINED_EXTRA_NODES_NODE",
     .honoured = "PID NID IFLAG",
     .take = keep<&RigidDraft::extra>},
    {.keyword = "CONSTRAINED_EXTRA_NODES_SET",
     .honoured = "PID NSID IFLAG",
     .take = keep<&RigidDraft::extra>},
    {.keyword = "CONSTRAINED_NODAL_RIGID_BODY",
     .honoured = nodal,
     .harmless = print_only,
     .take = keep_nodal},
    {.keyword = "CONSTRAINED_NODAL_RIGID_BODY_SPC",
     .honoured = nodal_held,
     .harmless = print_only,
     .take = keep_nodal},
    {.keyword = "CONSTRAINED_NODAL_RIGID_BODY_INERTIA",
     .honoured = stated,
     .harmless = print_only,
     .take = keep_nodal},
    {.keyword = "CONSTRAINED_NODAL_RIGID_BODY_SPC_INERTIA",
     .honoured = stated_held,
     .harmless = print_only,
     .take = keep_nodal},
    {.keyword = "BOUNDARY_PRESCRIBED_MOTION_RIGID", .honoured = motion, .take = keep<&RigidDraft::motions>},
    {.keyword = "BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL",
     .honoured = motion,
     .take = keep<&RigidDraft::motions>},
    {.keyword = "INITIAL_VELOCITY_RIGID_BODY",
     .honoured = "PID VX VY VZ VXR VYR VZR ICID",
     .take = keep<&RigidDraft::velocities>},
    {.keyword = "LOAD_RIGID_BODY",
     .honoured = "ID HEADING PID DOF LCID SF CID M1 M2 M3",
     .take = keep<&RigidDraft::loads>},
};

/// Local axes of a stated tensor: CID2 or CID, else XL..ZL and XLIP..ZLIP. False with an error.
bool inertia_axes(Draft& draft, const Entry& entry, Frame& axes) {
  const std::string_view system = entry.has("CID2") ? "CID2" : "CID";
  if (entry.integer(system) != 0) {
    const Frame* frame = draft.frame(entry, system);
    if (frame) axes = *frame;
    return frame != nullptr;
  }
  const auto vector = [&](std::string_view x, std::string_view y, std::string_view z) {
    return entry.motion().direction({entry.card().real(x), entry.card().real(y), entry.card().real(z)});
  };
  if (make_frame(vector("XL", "YL", "ZL"), vector("XLIP", "YLIP", "ZLIP"), axes)) return true;
  draft.error(entry, "XL", "the local axes of the inertia are parallel or have no length",
              "give the x axis in XL YL ZL and a vector in the xy plane in XLIP YLIP ZLIP");
  return false;
}

}  // namespace

std::shared_ptr<RigidInertia> read_inertia(Draft& draft, const Entry& entry) {
  auto stated = std::make_shared<RigidInertia>();
  draft.refuse_turned(entry, "a tensor of inertia");
  stated->centre = entry.point("XC", "YC", "ZC");
  if (entry.integer("NODEID") != 0) {
    stated->node = draft.node(entry, "NODEID");
    if (stated->node < 0) return nullptr;
    stated->centre = draft.position(stated->node);
  }
  stated->mass = entry.real("TM", a_mass);
  if (!(stated->mass > 0.0)) {
    draft.error(entry, "TM", "the mass of a rigid body must be above 0");
    return nullptr;
  }
  constexpr Dimension inertia{1, 2, 0};
  const auto value = [&](std::string_view field) { return entry.real(field, inertia); };
  base::Sym3<double> tensor{value("IXX"), value("IYY"), value("IZZ"),
                            value("IXY"), value("IYZ"), value("IXZ")};
  if (entry.integer("IRCS") != 0) {
    Frame axes;
    if (!inertia_axes(draft, entry, axes)) return nullptr;
    base::Mat3<double> turn;  // columns are the local axes
    for (int k = 0; k < 3; ++k) {
      turn.m[0][k] = axes.axis[k].x;
      turn.m[1][k] = axes.axis[k].y;
      turn.m[2][k] = axes.axis[k].z;
    }
    tensor = base::rotate(turn, tensor);
  }
  // Positive definite: the leading minors are above 0.
  const double minor = tensor.xx * tensor.yy - tensor.xy * tensor.xy;
  const base::Mat3<double> full{{{tensor.xx, tensor.xy, tensor.zx},
                                 {tensor.xy, tensor.yy, tensor.yz},
                                 {tensor.zx, tensor.yz, tensor.zz}}};
  if (!(tensor.xx > 0.0 && minor > 0.0 && base::determinant(full) > 0.0)) {
    draft.error(entry, "IXX", "the tensor of inertia is not positive definite",
                "give the moments IXX IYY IZZ about the centre, and products much smaller than they are");
    return nullptr;
  }
  stated->tensor = tensor;
  constexpr Dimension rate{0, 0, -1};
  stated->velocity = {entry.real("VTX", a_velocity), entry.real("VTY", a_velocity),
                      entry.real("VTZ", a_velocity)};
  stated->spin = {entry.real("VRX", rate), entry.real("VRY", rate), entry.real("VRZ", rate)};
  return stated;
}

bool read_hold(Draft& draft, const Entry& entry, RigidHold& hold) {
  const double mode = entry.card().real("CMO");
  const auto code = [&](std::string_view field) {
    return static_cast<std::int64_t>(entry.card().real(field));
  };
  if (mode == 0.0) return true;
  if (mode == 1.0) {
    for (const std::string_view field : {"CON1", "CON2"})
      if (code(field) < 0 || code(field) > 7) {
        draft.error(entry, field, "found " + std::to_string(code(field)) + ", expected 0 to 7");
        return false;
      }
    hold.directions = direction_bits(code("CON1")) | direction_bits(code("CON2")) << 3;
    return true;
  }
  if (mode != -1.0) {
    draft.error(entry, "CMO", "expected 1 (global directions), -1 (local) or 0 (free)");
    return false;
  }
  const auto frame = draft.frames.find(code("CON1") + id_offset(entry.transform(), IdKind::definition));
  if (code("CON1") != 0 && frame == draft.frames.end()) {
    draft.error(entry, "CON1", "coordinate system " + std::to_string(code("CON1")) + " is not defined",
                "add a *DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR");
    return false;
  }
  hold.local = code("CON1") != 0;
  if (hold.local) hold.frame = frame->second;
  hold.frame.origin = {0, 0, 0};
  std::int64_t digits = code("CON2");
  for (unsigned k = 6; k-- > 0; digits /= 10) {
    if (digits % 10 != 0 && digits % 10 != 1) {
      draft.error(entry, "CON2", "found " + std::to_string(code("CON2")) + ", expected six digits 0 or 1",
                  "x y z and the rotations about them, e.g. 110111");
      return false;
    }
    if (digits % 10 == 1) hold.directions |= 1u << k;
  }
  return true;
}

std::shared_ptr<const RigidMaterial> read_rigid_material(Draft& draft, const Entry& entry) {
  auto material = std::make_shared<RigidMaterial>();
  if (!read_hold(draft, entry, material->hold)) return nullptr;
  const auto real = [&](std::string_view field) { return entry.card().real(field); };
  const Vector a{real("LCO"), real("A2"), real("A3")}, v{real("V1"), real("V2"), real("V3")};
  if (length(v) == 0.0 && a.y == 0.0 && a.z == 0.0) {
    if (a.x == 0.0) return material;
    const Id id = static_cast<Id>(a.x) + id_offset(entry.transform(), IdKind::definition);
    const auto frame = draft.frames.find(id);
    if (frame == draft.frames.end()) {
      draft.error(entry, "LCO", "coordinate system " + std::to_string(id) + " is not defined",
                  "add a *DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR");
      return nullptr;
    }
    material->axes = frame->second;
  } else if (!make_frame(entry.motion().direction(a), entry.motion().direction(v), material->axes)) {
    draft.error(entry, "LCO", "the vectors A and V are parallel, or one has no length");
    return nullptr;
  }
  material->has_axes = true;
  material->axes.origin = {0, 0, 0};
  return material;
}

extern const Family rigid_cards{handlers};

}  // namespace cleave::model
