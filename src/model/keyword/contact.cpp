/// *CONTACT_* between surfaces of solids and of shells that do not deform, and *CONTROL_CONTACT.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/keyword/handler.hpp"
#include "model/keyword/over_time.hpp"
#include "model/outer_faces.hpp"

namespace cleave::model {
namespace {

/// Which side of the card is read: the names of its columns.
struct Columns {
  std::string_view name, type, box;
};
constexpr Columns columns_a{"SURFA", "SURFATYP", "SABOXID"}, columns_b{"SURFB", "SURFBTYP", "SBBOXID"};

void faces_to_nodes(ContactSide& side) {
  for (const Segment& face : side.segments) side.nodes.insert(side.nodes.end(), face.node, face.node + 4);
  std::sort(side.nodes.begin(), side.nodes.end());
  side.nodes.erase(std::unique(side.nodes.begin(), side.nodes.end()), side.nodes.end());
}

/// Shells of the parts, each once.
void add_shells(const Mesh& mesh, const std::vector<Index>& parts, std::vector<Segment>& segments) {
  for (const Elements& group : mesh.shells) {
    const auto n = static_cast<std::size_t>(nodes_of(group.shape));
    for (std::size_t e = 0; e < group.count(); ++e) {
      if (!std::binary_search(parts.begin(), parts.end(), group.part[e])) continue;
      const Index* node = &group.node[n * e];
      segments.push_back({{node[0], node[1], node[2], node[n - 1]}});
    }
  }
}

/// The parts a side names; false with an error where there is none.
bool find_parts(Draft& draft, const Entry& entry, std::string_view field, ContactSide& side) {
  if (side.type == 3) {
    const Index part = draft.part(entry, field);
    if (part < 0) return false;
    side.parts = {part};
  } else if (side.type == 5) {
    side.parts.resize(draft.model.parts.size());
    std::iota(side.parts.begin(), side.parts.end(), Index{0});
  } else {
    const auto* set = draft.part_set(entry, field);
    if (!set) return false;
    std::vector<Index> named(*set);
    std::sort(named.begin(), named.end());
    named.erase(std::unique(named.begin(), named.end()), named.end());
    if (side.type == 6) {
      for (Index p = 0; p < static_cast<Index>(draft.model.parts.size()); ++p)
        if (!std::binary_search(named.begin(), named.end(), p)) side.parts.push_back(p);
    } else {
      side.parts = std::move(named);
    }
  }
  if (side.parts.empty()) draft.error(entry, field, "the contact is given no part");
  return !side.parts.empty();
}

bool take_side(Draft& draft, const Entry& entry, const Columns& columns, bool nodes_allowed, bool single,
               ContactSide& side) {
  side.type = static_cast<int>(entry.integer(columns.type));
  const std::string_view field = columns.name;
  if (single && entry.integer(field) == 0 && side.type != 5) side.type = 5;  // number 0: everything
  side.id = side.type == 5 ? 0 : entry.id(side.type == 3 ? IdKind::part : IdKind::set, field);
  switch (side.type) {
    case 0: {
      const auto* set = draft.segment_set(entry, field);
      if (!set) return false;
      side.segments = *set;
      break;
    }
    case 2:
    case 3:
    case 5:
    case 6:
      if (!find_parts(draft, entry, field, side)) return false;
      side.segments = outer_faces(draft.model.mesh, side.parts);
      add_shells(draft.model.mesh, side.parts, side.segments);
      if (side.segments.empty())
        draft.error(entry, field, "the parts of this contact have no surface: they have no elements");
      break;
    case 4: {
      if (!nodes_allowed) {
        draft.error(entry, columns.type, "a set of nodes has no faces that could be met",
                    "give parts (3), part sets (2) or segment sets (0), or use a nodes-to-surface contact");
        return false;
      }
      const auto* set = draft.node_set(entry, field);
      if (!set) return false;
      side.nodes = *set;
      std::sort(side.nodes.begin(), side.nodes.end());
      side.nodes.erase(std::unique(side.nodes.begin(), side.nodes.end()), side.nodes.end());
      if (side.nodes.empty()) draft.error(entry, field, "the set of this contact is empty");
      return !side.nodes.empty();
    }
    case 1:
      draft.refuse(entry, columns.type, "a set of shells", "only solids have surfaces here: parts, segments");
      return false;
    default:
      draft.error(entry, columns.type, "found " + std::to_string(side.type) + ", expected 0 and 2 to 6");
      return false;
  }
  if (side.type == 0 && side.segments.empty()) draft.error(entry, field, "the set of this contact is empty");
  faces_to_nodes(side);
  return !side.segments.empty();
}

/// SABOXID, SBBOXID: of the faces of parts only those whose corners all lie in a box at the start. What is
/// left is a list of faces, and is written back as one.
bool limit_to_box(Draft& draft, const Entry& entry, const Columns& columns, ContactSide& side) {
  if (entry.integer(columns.box) == 0) return true;
  const Box* box = draft.box(entry, columns.box);
  if (!box) return false;
  if (side.parts.empty()) {
    draft.error(entry, columns.box, "a box limits the faces of parts, not a set of faces or nodes",
                "name the part (3) or part set (2), or leave the faces out of the set");
    return false;
  }
  if (entry.keyword().find("_ERODING_") != std::string::npos) {
    draft.refuse(entry, columns.box, "a box for faces that appear when elements are deleted",
                 "give a part of its own to what shall be in contact");
    return false;
  }
  std::erase_if(side.segments, [&](const Segment& face) {
    return std::any_of(face.node, face.node + 4,
                       [&](Index node) { return !box->contains(draft.position(node)); });
  });
  if (side.segments.empty())
    draft.error(entry, columns.box,
                "no face of side " + std::string(columns.name.substr(4)) + " lies in the box");
  side.type = 0;
  side.id = 0;
  side.parts.clear();
  side.nodes.clear();
  faces_to_nodes(side);
  return !side.segments.empty();
}

/// A coefficient that must not be negative.
double coefficient(Draft& draft, const Entry& entry, std::string_view field, Dimension dimension = pure) {
  const double value = entry.real(field, dimension);
  if (value >= 0.0) return value;
  draft.error(entry, field, "found " + std::to_string(value) + ", expected 0 or more",
              "friction by table (*DEFINE_FRICTION, -2) is not computed");
  return 0.0;
}

/// Friction and damping. FS = -1 leaves friction to the parts.
void take_friction(Draft& draft, const Entry& entry, Contact& contact) {
  const double factor = entry.real_or("FSF", pure, 1.0), viscous = entry.real_or("VSF", pure, 1.0);
  contact.damping = 0.01 * coefficient(draft, entry, "VDC");
  if (entry.real("FS", pure) == -1.0) {
    contact.part_friction.resize(draft.model.parts.size());
    for (const auto& [part, friction] : draft.part_friction)
      contact.part_friction[static_cast<std::size_t>(part)] = friction;
    for (const std::string_view field : {"FD", "DC", "VC"})
      if (entry.card().real(field) != 0.0)
        draft.warning(entry, field, "not used with FS -1: friction stands with the parts (*PART_CONTACT)");
    if (factor != 1.0 || viscous != 1.0)
      draft.refuse(entry, factor != 1.0 ? "FSF" : "VSF", "a factor on the friction of parts",
                   "give the friction in *PART_CONTACT as it shall act");
    return;
  }
  contact.static_friction = factor * coefficient(draft, entry, "FS");
  contact.dynamic_friction = factor * coefficient(draft, entry, "FD");
  contact.friction_decay = coefficient(draft, entry, "DC", {0, -1, 1});
  contact.viscous_limit = viscous * coefficient(draft, entry, "VC", {1, -1, -2});
}

void take_method(Draft& draft, const Entry& entry, Contact& contact) {
  contact.ignore = draft.model.control.contact.ignore;
  if (entry.has("SOFT")) {
    contact.soft = static_cast<int>(entry.integer("SOFT"));
    contact.soft_scale = entry.real_or("SOFSCL", pure, 0.1);
    contact.extension = entry.real_or("MAXPAR", pure, 1.025);
    if (contact.extension < 1.0 || contact.extension > 1.2) contact.extension = 1.025;
    if (contact.soft < 0 || contact.soft > 2) {
      draft.refuse(entry, "SOFT", "contact method " + std::to_string(contact.soft),
                   "0, 1 and 2 are computed");
      contact.soft = 0;
    }
  }
  if (entry.has("PENMAX")) {
    contact.release = contact.automatic ? entry.real("PENMAX", pure) : entry.real("PENMAX", a_length);
    if (contact.release < 0.0) draft.error(entry, "PENMAX", "a depth of release cannot be negative");
  }
  if (entry.has("SLDTHK")) {
    contact.solid_thickness = entry.real("SLDTHK", a_length);
    contact.solid_modulus = entry.real("SLDSTF", {1, -1, -2});
    for (const std::string_view field : {"SLDTHK", "SLDSTF"})
      if (entry.card().real(field) < 0.0)
        draft.error(entry, field,
                    "found " + std::to_string(entry.card().real(field)) + ", expected 0 or above");
    if (contact.solid_thickness > 0.0 && !contact.automatic)
      draft.refuse(entry, "SLDTHK", "a thickness of solids in a contact that is not automatic",
                   "only automatic and eroding contacts see thicknesses");
  }
  if (entry.has("IGNORE") && entry.given("IGNORE")) {
    const auto ignore = entry.integer("IGNORE");
    if (ignore < 0 || ignore > 2)
      draft.error(entry, "IGNORE", "found " + std::to_string(ignore) + ", expected 0, 1 or 2");
    contact.ignore = static_cast<int>(ignore);
  }
}

void take_contact(Draft& draft, const Entry& entry) {
  Contact contact;
  const std::string& name = contact.keyword = entry.keyword();
  const auto holds = [&](std::string_view word) { return name.find(word) != std::string::npos; };
  contact.place = entry.place();
  if (entry.has("CID")) {
    contact.id = entry.card().integer("CID");
    contact.title = std::string(entry.card().text("HEADING"));
    contact.named = contact.id > 0;
  }
  if (!contact.named) contact.id = static_cast<Id>(draft.model.contacts.size()) + 1;
  contact.tied = holds("_TIED_");
  contact.offset = contact.tied && name.ends_with("_OFFSET");
  contact.joins = contact.tied && (!contact.offset || name.ends_with("_CONSTRAINED_OFFSET"));
  contact.automatic = holds("_AUTOMATIC_") || holds("_ERODING_");
  // New faces are what this contact is for: they are left out only where the deck says so.
  contact.eroding = holds("_ERODING_") && !(entry.given("EROSOP") && entry.integer("EROSOP") == 0);
  const bool single = holds("_SINGLE_SURFACE"), nodes = holds("NODES_TO_SURFACE");
  contact.search = single                                        ? Contact::Search::single
                   : nodes || holds("_ONE_WAY_") || contact.tied ? Contact::Search::one_way
                                                                 : Contact::Search::two_way;

  const bool a = take_side(draft, entry, columns_a, nodes || contact.tied, single, contact.a);
  const bool b = single || take_side(draft, entry, columns_b, false, false, contact.b);
  if (!a || !b) return;

  if (!limit_to_box(draft, entry, columns_a, contact.a)) return;
  if (!single && !limit_to_box(draft, entry, columns_b, contact.b)) return;

  take_friction(draft, entry, contact);
  contact.birth = entry.real("BT", a_time);
  contact.death = death_time(entry, "DT");
  if (contact.birth < 0.0)
    draft.refuse(entry, "BT", "a birth time below 0", "give the time at which it starts");
  contact.scale_a = entry.real_or("SFSA", pure, 1.0);
  contact.scale_b = entry.real_or("SFSB", pure, 1.0);
  if (contact.scale_a < 0.0 || contact.scale_b < 0.0)
    draft.error(entry, contact.scale_a < 0.0 ? "SFSA" : "SFSB",
                "a scale of the stiffness cannot be negative");
  if (contact.tied && entry.real("SAST", a_length) < 0.0)
    contact.tie_distance = -entry.real("SAST", a_length);
  take_method(draft, entry, contact);
  if (!contact.tied && contact.soft == 2 && contact.a.segments.empty()) {
    draft.warning(entry, "SOFT", "segment to segment contact needs faces on side A",
                  "the stiffness is taken from masses and step (SOFT 1)");
    contact.soft = 1;
  }
  draft.model.contacts.push_back(std::move(contact));
}

void take_control(Draft& draft, const Entry& entry) {
  ContactControl& control = draft.model.control.contact;
  control.stiffness = entry.real_or("SLSFAC", pure, 0.1);
  if (control.stiffness < 0.0) draft.error(entry, "SLSFAC", "the stiffness factor must be above 0");
  draft.wall_penalty = entry.real("RWPNAL", pure);
  if (std::abs(draft.wall_penalty) > 5.0)
    draft.error(entry, "RWPNAL",
                "found " + std::to_string(draft.wall_penalty) +
                    ", expected -5 to 5: stiffer springs would swing faster than the step allows",
                "1 is right for most: half a period in about ten steps for a single node");
  control.penalty = static_cast<int>(entry.integer("PENOPT"));
  if (control.penalty == 0) control.penalty = 1;
  if (control.penalty < 0 || control.penalty > 3) {
    draft.refuse(entry, "PENOPT", "penalty rule " + std::to_string(control.penalty),
                 "1 (softer side), 2 (side B) and 3 (side A) are computed");
    control.penalty = 1;
  }
  control.orient = static_cast<int>(entry.integer("ORIEN"));
  if (control.orient == 0) control.orient = 1;
  control.shell_thickness = static_cast<int>(entry.integer("SHLTHK"));
  if (control.shell_thickness < 0 || control.shell_thickness > 2)
    draft.error(entry, "SHLTHK", "found " + std::to_string(control.shell_thickness) + ", expected 0, 1 or 2");
  if (entry.has("IGNORE")) control.ignore = static_cast<int>(entry.integer("IGNORE"));
  if (control.ignore < 0 || control.ignore > 2)
    draft.error(entry, "IGNORE", "found " + std::to_string(control.ignore) + ", expected 0, 1 or 2");
}

constexpr std::string_view fields =
    "CID HEADING SURFA SURFB SURFATYP SURFBTYP SABOXID SBBOXID FS FD DC VC VDC BT DT SFSA SFSB FSF VSF SOFT "
    "SOFSCL MAXPAR "
    "IGNORE PENMAX SLDTHK SLDSTF EROSOP";
/// Print options, thickness of shells, and how often to sort: pairs are sorted anew whenever motion asks.
constexpr std::string_view unused =
    "SAPR SBPR PENCHK SAST SBST SFSAT SFSBT SBOPT DEPTH BSORT FRCFRQ THKOPT SHLTHK SNLOG ISYM I2D3D IGAP "
    "FLANGL IADJ MPP_IGNORE BCKT LCBCKT NS2TRK INITITR PARMAX CHKSEGS GRPABLE DTPCHK Q2TRI SHLEDG "
    "IGNROFF SHLOFF TIEDID SRNDE";
constexpr std::string_view remark = "between surfaces of solids and rigid shells; see the page on contact";

/// Ties have no friction and one method each.
constexpr std::string_view tied_fields =
    "CID HEADING SURFA SURFB SURFATYP SURFBTYP SABOXID SBBOXID BT DT SFSA SFSB SAST";
constexpr std::string_view tied_unused =
    "SAPR SBPR PENCHK SBST SFSAT SFSBT FS FD DC VC VDC FSF VSF SOFT SOFSCL SBOPT DEPTH BSORT FRCFRQ MAXPAR "
    "THKOPT "
    "SHLTHK SNLOG ISYM I2D3D IGAP IGNORE FLANGL MPP_IGNORE BCKT LCBCKT NS2TRK INITITR PARMAX CHKSEGS GRPABLE "
    "DTPCHK IGNROFF SHLOFF TIEDID";

/// All contacts that push take the same fields.
constexpr Handler pushing(std::string_view keyword) {
  return {keyword, Phase::action, fields, unused, take_contact, nullptr, remark};
}

constexpr Handler tying(std::string_view keyword) {
  return {keyword, Phase::action, tied_fields, tied_unused, take_contact, nullptr, remark};
}

constexpr Handler handlers[] = {
    pushing("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE"),
    pushing("CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE"),
    pushing("CONTACT_AUTOMATIC_NODES_TO_SURFACE"),
    pushing("CONTACT_AUTOMATIC_SINGLE_SURFACE"),
    pushing("CONTACT_SURFACE_TO_SURFACE"),
    pushing("CONTACT_ONE_WAY_SURFACE_TO_SURFACE"),
    pushing("CONTACT_NODES_TO_SURFACE"),
    pushing("CONTACT_SINGLE_SURFACE"),
    pushing("CONTACT_ERODING_SURFACE_TO_SURFACE"),
    pushing("CONTACT_ERODING_NODES_TO_SURFACE"),
    pushing("CONTACT_ERODING_SINGLE_SURFACE"),
    pushing("CONTACT_FORMING_ONE_WAY_SURFACE_TO_SURFACE"),
    tying("CONTACT_TIED_NODES_TO_SURFACE"),
    tying("CONTACT_TIED_SURFACE_TO_SURFACE"),
    tying("CONTACT_TIED_SURFACE_TO_SURFACE_OFFSET"),
    tying("CONTACT_TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET"),
    tying("CONTACT_TIED_NODES_TO_SURFACE_OFFSET"),
    tying("CONTACT_TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET"),
    {.keyword = "CONTROL_CONTACT",
     .phase = Phase::definition,
     .honoured = "SLSFAC RWPNAL PENOPT ORIEN IGNORE SHLTHK",
     .harmless = "ISLCHK THKCHG USRSTR USRFRC NSBCS INTERM XPENE SSTHK ECDT FRCENG SKIPRWG "
                 "OUTSEG SPOTSTP SPOTDEL SPOTHIN ISYM RWGAPS RWGDTH RWKSF SWRADF ITHOFF SHLEDG ITHCNT FTALL "
                 "SHLTRW IGACTC TH TH_SF PTSCL",
     .take = take_control},
};

}  // namespace
extern const Family contact_cards{handlers};

}  // namespace cleave::model
