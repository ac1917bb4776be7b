/// *DEFINE_COORDINATE_*, *DEFINE_VECTOR, *DEFINE_BOX, *DEFINE_TRANSFORMATION.

#include <numbers>

#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

void add_frame(Draft& draft, const Entry& entry, const Vector& origin, const Vector& x,
               const Vector& in_plane) {
  const Id id = entry.id(IdKind::definition, "CID");
  if (!draft.claim(entry, "coordinate system", id, "CID")) return;
  Frame frame;
  if (!make_frame(x, in_plane, frame))
    return draft.error(entry, "CID",
                       "the x axis and the vector in the xy plane are parallel, or one has no length");
  frame.origin = origin;
  draft.frames.emplace(id, frame);
}

/// Origin, a point on the local x axis, a point in the local xy plane.
void take_system(Draft& draft, const Entry& entry) {
  if (entry.integer("CIDL") != 0)
    draft.refuse(entry, "CIDL", "a coordinate system given in another one",
                 "give its points in global coordinates");
  const Vector origin = entry.point("XO", "YO", "ZO");
  add_frame(draft, entry, origin, entry.point("XL", "YL", "ZL") - origin,
            entry.point("XP", "YP", "ZP") - origin);
}

/// Two vectors from the origin: x axis, and one in the xy plane.
void take_vector_system(Draft& draft, const Entry& entry) {
  if (entry.integer("NID") != 0)
    draft.refuse(entry, "NID", "axes that turn with a node", "nodes of solids do not turn; leave NID blank");
  const auto vector = [&](std::string_view x, std::string_view y, std::string_view z) {
    return entry.motion().direction({entry.card().real(x), entry.card().real(y), entry.card().real(z)});
  };
  add_frame(draft, entry, {0, 0, 0}, vector("XX", "YX", "ZX"), vector("XV", "YV", "ZV"));
}

/// Nodes N1 (origin), N2 (on the axis DIR) and N3 (in the plane of DIR and the next axis).
void take_node_system(Draft& draft, const Entry& entry) {
  const Index n1 = draft.node(entry, "N1"), n2 = draft.node(entry, "N2"), n3 = draft.node(entry, "N3");
  if (n1 < 0 || n2 < 0 || n3 < 0) return;
  if (entry.integer("FLAG") != 0)
    draft.refuse(entry, "FLAG", "axes that follow their nodes",
                 "set FLAG to 0: axes of the start configuration");
  const Vector origin = draft.position(n1), along = draft.position(n2) - origin,
               other = draft.position(n3) - origin;
  const auto direction = entry.card().text("DIR");
  const Id id = entry.id(IdKind::definition, "CID");
  if (!draft.claim(entry, "coordinate system", id, "CID")) return;
  Frame made;
  if (!make_frame(along, other, made))
    return draft.error(entry, "N1", "the three nodes of the coordinate system lie on a line");
  // DIR names the axis that N1-N2 makes; the two others follow it cyclically.
  const int first = direction == "Y" || direction == "y" ? 1 : direction == "Z" || direction == "z" ? 2 : 0;
  Frame frame;
  frame.origin = origin;
  for (int k = 0; k < 3; ++k) frame.axis[(first + k) % 3] = made.axis[k];
  draft.frames.emplace(id, frame);
}

void take_vector(Draft& draft, const Entry& entry) {
  const Id id = entry.id(IdKind::definition, "VID");
  if (!draft.claim(entry, "vector", id, "VID")) return;
  const Frame* frame = draft.frame(entry, "CID");
  if (!frame) return;
  const Vector tail = {entry.card().real("XT"), entry.card().real("YT"), entry.card().real("ZT")};
  const Vector head = {entry.card().real("XH"), entry.card().real("YH"), entry.card().real("ZH")};
  const Vector v = entry.motion().direction(to_global(*frame, head - tail));
  if (length(v) == 0.0)
    return draft.error(entry, "XH", "the vector has no length: head and tail are the same");
  draft.vectors.emplace(id, unit(v));
}

void take_vector_nodes(Draft& draft, const Entry& entry) {
  const Id id = entry.id(IdKind::definition, "VID");
  if (!draft.claim(entry, "vector", id, "VID")) return;
  const Index tail = draft.node(entry, "NODET"), head = draft.node(entry, "NODEH");
  if (tail < 0 || head < 0) return;
  const Vector v = draft.position(head) - draft.position(tail);
  if (length(v) == 0.0)
    return draft.error(entry, "NODEH", "the vector has no length: both nodes are at one place");
  draft.vectors.emplace(id, unit(v));
}

void take_box(Draft& draft, const Entry& entry) {
  const Id id = entry.id(IdKind::definition, "BOXID");
  if (!draft.claim(entry, "box", id, "BOXID")) return;
  Box box;
  box.low = {entry.real("XMN", a_length), entry.real("YMN", a_length), entry.real("ZMN", a_length)};
  box.high = {entry.real("XMX", a_length), entry.real("YMX", a_length), entry.real("ZMX", a_length)};
  if (box.low.x > box.high.x || box.low.y > box.high.y || box.low.z > box.high.z)
    draft.warning(entry, "XMN", "a lower bound is above its upper bound: nothing lies in the box");
  if (entry.keyword() == "DEFINE_BOX_LOCAL") {
    const Vector x = {entry.card().real("XX"), entry.card().real("YX"), entry.card().real("ZX")};
    const Vector v = {entry.card().real("XV"), entry.card().real("YV"), entry.card().real("ZV")};
    if (!make_frame(x, v, box.frame))
      return draft.error(entry, "XX",
                         "the local x axis and the vector in the xy plane are parallel, or have no length");
    box.frame.origin = {entry.real("CX", a_length), entry.real("CY", a_length), entry.real("CZ", a_length)};
  }
  if (entry.motion().turns())
    draft.refuse(entry, "", "a box inside a file that *DEFINE_TRANSFORMATION turns or scales",
                 "move the box out of the transformed include file");
  box.frame.origin = box.frame.origin + entry.motion().shift;
  draft.boxes.emplace(id, box);
}

/// Rows act one after the other. Refused: what is not listed here.
void take_transformation(Draft& draft, const Entry& entry) {
  const Id id = entry.card().integer("TRANID");
  if (!draft.claim(entry, "transformation", id, "TRANID")) return;
  Affine whole;
  for (std::size_t row = 0; row < entry.card().row_count("OPTION"); ++row) {
    const auto a = [&](int k) { return entry.card().real("A" + std::to_string(k), row); };
    const std::string_view option = entry.card().text("OPTION", row);
    Affine step;
    if (option == "TRANSL") {
      step.shift = {a(1), a(2), a(3)};
    } else if (option == "SCALE") {
      for (int i = 0; i < 3; ++i) step.linear.m[i][i] = a(i + 1) == 0.0 ? 1.0 : a(i + 1);
    } else if (option == "ROTATE") {
      // Axis A1-A3, a point on it A4-A6, angle A7 in degrees. Nodes may stand for both when A6 and A7 are 0.
      const Vector axis = {a(1), a(2), a(3)};
      if (length(axis) == 0.0 || a(7) == 0.0) {
        draft.refuse(entry, "OPTION", "ROTATE by points or nodes", "give axis, point and angle in A1 to A7");
        continue;
      }
      step = rotation(axis, {a(4), a(5), a(6)}, a(7) * std::numbers::pi / 180.0);
    } else if (option == "MIRROR") {
      // The plane through the point A1-A3 with its normal towards the point A4-A6.
      const Vector point = {a(1), a(2), a(3)}, n = unit(Vector{a(4), a(5), a(6)} - point);
      const double c[3] = {n.x, n.y, n.z};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) step.linear.m[i][j] -= 2.0 * c[i] * c[j];
      step.shift = point - step.direction(point);
      draft.refuse(entry, "OPTION", "MIRROR turns elements inside out and is not corrected here",
                   "mirror the mesh before it is read");
    } else if (option.empty()) {
      continue;
    } else {
      draft.refuse(entry, "OPTION", "the transformation " + std::string(option),
                   "use TRANSL, SCALE or ROTATE");
      continue;
    }
    whole = followed_by(whole, step);
  }
  draft.transformations.emplace(id, whole);
}

constexpr Handler handlers[] = {
    {.keyword = "DEFINE_COORDINATE_SYSTEM",
     .phase = Phase::frame,
     .honoured = "TITLE CID XO YO ZO XL YL ZL CIDL XP YP ZP",
     .take = take_system},
    {.keyword = "DEFINE_COORDINATE_VECTOR",
     .phase = Phase::frame,
     .honoured = "TITLE CID XX YX ZX XV YV ZV NID",
     .take = take_vector_system},
    {.keyword = "DEFINE_COORDINATE_NODE*",
     .phase = Phase::frame,
     .honoured = "TITLE CID N1 N2 N3 FLAG DIR",
     .take = take_node_system},
    {.keyword = "DEFINE_VECTOR",
     .phase = Phase::vector,
     .honoured = "TITLE VID XT YT ZT XH YH ZH CID",
     .take = take_vector},
    {.keyword = "DEFINE_VECTOR_NODES",
     .phase = Phase::vector,
     .honoured = "TITLE VID NODET NODEH",
     .take = take_vector_nodes},
    {.keyword = "DEFINE_BOX",
     .phase = Phase::frame,
     .honoured = "TITLE BOXID XMN XMX YMN YMX ZMN ZMX",
     .take = take_box},
    {.keyword = "DEFINE_BOX_LOCAL",
     .phase = Phase::frame,
     .honoured = "TITLE BOXID XMN XMX YMN YMX ZMN ZMX XX YX ZX XV YV ZV CX CY CZ",
     .take = take_box},
    {.keyword = "DEFINE_TRANSFORMATION",
     .phase = Phase::transformation,
     .honoured = "TITLE TRANID OPTION A1 A2 A3 A4 A5 A6 A7",
     .take = take_transformation},
};

}  // namespace
extern const Family define_cards{handlers};

}  // namespace cleave::model
