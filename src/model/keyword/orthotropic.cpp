#include "model/keyword/orthotropic.hpp"

#include <cmath>
#include <numbers>

#include "model/keyword/handler.hpp"
#include "model/keyword/honoured.hpp"

namespace cleave::model {
namespace {

bool read_constants(Draft& draft, const Entry& entry, Elasticity& constants) {
  bool good = true;
  const auto positive = [&](std::string_view field, double& to) {
    to = entry.card().real(field);
    if (to > 0.0) return;
    good = false;
    if (!entry.card().unreadable(field)) draft.error(entry, field, "the modulus must be above 0");
  };
  positive("EA", constants.modulus[0]);
  positive("EB", constants.modulus[1]);
  positive("EC", constants.modulus[2]);
  positive("GAB", constants.shear_ab);
  positive("GBC", constants.shear_bc);
  positive("GCA", constants.shear_ca);
  constants.poisson_ba = entry.card().real("PRBA");
  constants.poisson_ca = entry.card().real("PRCA");
  constants.poisson_cb = entry.card().real("PRCB");
  if (!(entry.card().real("RO") > 0.0)) {
    draft.error(entry, "RO", "the density must be above 0",
                "in the units of the deck, e.g. 7.85e-9 tonne/mm3 for steel");
    good = false;
  }
  if (!good) return false;
  // Leading minors of the compliance, scaled to a unit diagonal.
  const auto& e = constants.modulus;
  const double ab = constants.poisson_ba * std::sqrt(e[0] / e[1]),
               ac = constants.poisson_ca * std::sqrt(e[0] / e[2]),
               bc = constants.poisson_cb * std::sqrt(e[1] / e[2]);
  const bool stable = std::fabs(ab) < 1.0 && 1.0 - ab * ab - ac * ac - bc * bc - 2.0 * ab * ac * bc > 1e-12 &&
                      std::fabs(ac) < 1.0;
  if (!stable)
    draft.error(entry, "PRBA", "with these Poisson's ratios the material would gain energy when strained",
                "PRBA is the strain along a over that along b when b is pulled: PRBA^2 must be below EB/EA, "
                "and likewise for the others");
  return stable;
}

/// Direction of three fields, turned with its file.
Vector direction(const Entry& entry, std::string_view x, std::string_view y, std::string_view z) {
  return entry.motion().direction({entry.card().real(x), entry.card().real(y), entry.card().real(z)});
}

bool read_axes(Draft& draft, const Entry& entry, const Part& part, Elasticity& constants) {
  const double option = entry.card().real("AOPT");
  const bool solid = spacetime_dimension(part.section) == 3;
  constants.angle = entry.card().real("BETA") * std::numbers::pi / 180.0;
  if (option < 0.0) {
    constants.axes = Elasticity::Axes::frame;
    const auto at = draft.frames.find(entry.offset(IdKind::definition, static_cast<Id>(-option)));
    if (at != draft.frames.end()) constants.frame = at->second;
    if (at == draft.frames.end())
      draft.error(entry, "AOPT",
                  "coordinate system " + std::to_string(static_cast<Id>(-option)) + " is not defined",
                  "add a *DEFINE_COORDINATE_SYSTEM, _NODES or _VECTOR");
    return at != draft.frames.end();
  }
  if (option == 2.0) {
    constants.axes = Elasticity::Axes::frame;
    const bool made =
        make_frame(direction(entry, "A1", "A2", "A3"), direction(entry, "D1", "D2", "D3"), constants.frame);
    if (!made)
      draft.error(entry, "A1", "the vectors a and d of the material axes are parallel, or one has no length");
    return made;
  }
  if (option == 0.0 || option == 3.0) {
    if (solid) {
      draft.refuse(
          entry, "AOPT",
          "axes that follow each element (AOPT " + std::to_string(static_cast<int>(option)) + ") in solids",
          "give them by two vectors (AOPT 2) or a coordinate system (AOPT < 0)");
      return false;
    }
    constants.axes = option == 0.0 ? Elasticity::Axes::element : Elasticity::Axes::across;
    if (option == 0.0) return true;
    constants.reference = direction(entry, "V1", "V2", "V3");
    const bool flat =
        std::hypot(constants.reference.x, constants.reference.y) > 1e-9 * length(constants.reference);
    if (!flat) draft.error(entry, "V1", "the vector v of the material axes stands across the plane");
    return flat;
  }
  draft.refuse(entry, "AOPT", "material axes by AOPT " + std::to_string(static_cast<int>(option)),
               "give them by two vectors (AOPT 2), a vector and an angle (3) or a coordinate system (< 0)");
  return false;
}

}  // namespace

std::shared_ptr<const Elasticity> read_orthotropic(Draft& draft, const Entry& entry, const Part& part) {
  const double option = entry.card().real("AOPT");
  report_unused(draft, entry, account_of(*draft.account, entry.keyword()), [&](std::string_view name) {
    if (names("MID RO EA EB EC PRBA PRCA PRCB GAB GBC GCA AOPT TITLE", name)) return FieldUse::honoured;
    const bool used = names("A1 A2 A3 D1 D2 D3", name) ? option == 2.0
                      : names("V1 V2 V3", name)        ? option == 3.0
                      : name == "BETA"                 ? option == 3.0 || option == 0.0
                                                       : false;
    if (used) return FieldUse::honoured;
    return names("XP YP ZP A1 A2 A3 D1 D2 D3 V1 V2 V3 BETA", name) ? FieldUse::harmless : FieldUse::ignored;
  });
  Elasticity constants;
  constants.isotropic = false;
  constants.place = entry.place("EA");
  const bool good = read_constants(draft, entry, constants);
  if (!read_axes(draft, entry, part, constants) || !good) return nullptr;
  return std::make_shared<const Elasticity>(constants);
}

}  // namespace cleave::model
