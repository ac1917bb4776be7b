#include "model/check.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "model/keyword/row_place.hpp"
#include "model/material/law.hpp"
#include "model/report.hpp"
#include "model/solid_geometry.hpp"

namespace cleave::model {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// "12, 15, 19 and 4 more".
std::string list(const std::vector<Id>& ids) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(ids.size(), 5); ++i)
    text += (i ? ", " : "") + std::to_string(ids[i]);
  return ids.size() > 5 ? text + " and " + std::to_string(ids.size() - 5) + " more" : text;
}

void check_elements(const Model& model, const deck::Deck& deck, deck::Diagnostics& diagnostics) {
  std::vector<Id> bad;
  std::vector<std::size_t> count(model.parts.size(), 0);
  std::array<Corner, 10> x;
  for (const Elements& group : model.mesh.solids) {
    const int n = nodes_of(group.shape);
    for (std::size_t e = 0; e < group.count(); ++e) {
      ++count[group.part[e]];
      for (int a = 0; a < n; ++a) {
        const double* p =
            model.mesh.nodes.position.data() + 3 * static_cast<std::size_t>(group.node[e * n + a]);
        x[a] = {p[0], p[1], p[2]};
      }
      if (!(centre_volume(group.shape, {x.data(), static_cast<std::size_t>(n)}) > 0.0))
        bad.push_back(group.id[e]);
    }
  }
  for (const auto* groups : {&model.mesh.shells, &model.mesh.beams})
    for (const Elements& group : *groups)
      for (const Index part : group.part) ++count[part];
  // Each at its line; of very many the first ones tell what is wrong.
  constexpr std::size_t most = 100;
  const std::size_t count_bad = bad.size();
  bad.resize(std::min(most, count_bad));
  for (const auto& [id, place] : row_places(deck, "ELEMENT_SOLID", IdKind::element, bad))
    diagnostics.error(place, "ELEMENT_SOLID", "EID",
                      "element " + std::to_string(id) + " has volume 0 or less" +
                          (count_bad > 1 ? ", one of " + std::to_string(count_bad) : ""),
                      "number the nodes of the bottom face counter-clockwise seen from the top face");
  for (std::size_t i = 0; i < count.size(); ++i)
    if (count[i] == 0)
      diagnostics.warning(model.parts[i].place, "PART", "PID",
                          "part " + std::to_string(model.parts[i].id) + " has no elements");
}

/// Shells without area and bars without length; shells numbered the other way round than others of their
/// part.
void check_thin_elements(const Model& model, const deck::Deck& deck, deck::Diagnostics& diagnostics) {
  std::vector<std::size_t> total(model.parts.size(), 0);
  std::vector<std::vector<Id>> clockwise(model.parts.size());
  std::vector<Id> flat[2];  // shells, bars
  std::array<Corner, 4> x;
  for (const auto* groups : {&model.mesh.shells, &model.mesh.beams})
    for (const Elements& group : *groups) {
      const int n = nodes_of(group.shape);
      for (std::size_t e = 0; e < group.count(); ++e) {
        double longest = 0.0;
        for (int a = 0; a < n; ++a) {
          const double* p =
              model.mesh.nodes.position.data() + 3 * static_cast<std::size_t>(group.node[e * n + a]);
          x[a] = {p[0], p[1], p[2]};
          for (int b = 0; b < a; ++b) longest = std::max(longest, base::dot(x[a] - x[b], x[a] - x[b]));
        }
        const bool bar = group.shape == Shape::line2;
        const double size = volume(group.shape, {x.data(), static_cast<std::size_t>(n)});
        if (!(size > 0.0) || (!bar && size <= 1e-12 * longest)) flat[bar].push_back(group.id[e]);
        if (bar || spacetime_dimension(model.parts[group.part[e]].section) == 0) continue;
        double twice = 0.0;  // area seen from above
        for (int a = 1; a + 1 < n; ++a) twice += base::cross(x[a] - x[0], x[a + 1] - x[0]).z;
        ++total[group.part[e]];
        if (twice < 0.0) clockwise[group.part[e]].push_back(group.id[e]);
      }
    }
  constexpr std::size_t most = 100;  // of very many the first ones tell what is wrong
  const auto report = [&](std::vector<Id> ids, const char* keyword, const char* what, const char* instead) {
    const std::size_t count = ids.size();
    ids.resize(std::min(most, count));
    for (const auto& [id, place] : row_places(deck, keyword, IdKind::element, ids))
      diagnostics.error(
          place, keyword, "EID",
          "element " + std::to_string(id) + what + (count > 1 ? ", one of " + std::to_string(count) : ""),
          instead);
  };
  report(flat[0], "ELEMENT_SHELL", " has no area: its corners lie in one line",
         "repeated or misplaced nodes");
  report(flat[1], "ELEMENT_BEAM", " has no length", "repeated or misplaced nodes");
  for (std::size_t p = 0; p < clockwise.size(); ++p)
    if (clockwise[p].size() < total[p])
      report(clockwise[p], "ELEMENT_SHELL",
             " is inverted: others of its part are numbered the other way round",
             "number all shells of a part counter-clockwise seen from above, or all clockwise");
}

void check_nodes(const Model& model, const deck::Deck& deck, deck::Diagnostics& diagnostics) {
  std::vector<char> massive(model.mesh.nodes.count(), 0);
  for (const auto* groups : {&model.mesh.solids, &model.mesh.shells, &model.mesh.beams})
    for (const Elements& group : *groups)
      for (const Index i : group.node) massive[i] = 1;
  const std::vector<Index> body_at = body_of_nodes(model.rigid_bodies, massive.size());
  std::vector<Id> alone;
  for (std::size_t i = 0; i < massive.size(); ++i)
    if (!massive[i] && body_at[i] < 0) alone.push_back(model.mesh.nodes.id[i]);
  for (const PointMass& m : model.point_masses)
    if (m.mass > 0.0) massive[m.node] = 1;
  for (const RigidBody& body : model.rigid_bodies)
    for (const Index i : body.nodes) massive[i] = 1;

  std::vector<Id> loaded;
  const auto look = [&](Index i) {
    if (!massive[i]) loaded.push_back(model.mesh.nodes.id[i]);
  };
  for (const NodeLoad& load : model.node_loads) std::for_each(load.nodes.begin(), load.nodes.end(), look);
  for (const SegmentLoad& load : model.segment_loads) {
    for (const Segment& s : load.segments) std::for_each(s.node, s.node + 4, look);
    for (const auto& face : load.quadratic) std::for_each(face.begin(), face.end(), look);
  }
  std::sort(loaded.begin(), loaded.end());
  loaded.erase(std::unique(loaded.begin(), loaded.end()), loaded.end());
  const auto place_of = [&](Id id) { return row_places(deck, "NODE", IdKind::node, {id})[id]; };
  if (!loaded.empty())
    diagnostics.error(place_of(loaded[0]), "NODE", "NID", "loaded nodes without mass: " + list(loaded),
                      "connect them to an element, or add an *ELEMENT_MASS");
  if (!alone.empty())
    diagnostics.warning(place_of(alone[0]), "NODE", "NID",
                        std::to_string(alone.size()) + " nodes belong to no element: " + list(alone));
}

void check_body_loads(const Model& model, deck::Diagnostics& diagnostics) {
  if (model.rigid_bodies.empty()) return;
  const auto body = body_of_nodes(model.rigid_bodies, model.mesh.nodes.count());
  for (const BodyLoad& load : model.body_loads) {
    if (!load.rotation || load.angular == BodyLoad::Angular::centrifugal) continue;
    for (std::size_t a = 0; a < load.nodes.size(); ++a) {
      if (!load.nodes[a] || body[a] < 0) continue;
      diagnostics.error(load.place, "LOAD_BODY_GENERALIZED", "ANGTYP",
                        "Coriolis and rotational accelerations are not computed for rigid bodies, and node " +
                            std::to_string(model.mesh.nodes.id[a]) + " belongs to one",
                        "leave their nodes out; CENT, the centrifugal one, is computed");
      break;
    }
  }
}

void check_curves(const Model& model, deck::Diagnostics& diagnostics) {
  std::set<Index> used;
  for (const auto& m : model.motions)
    if (m.death >= model.control.end.time) used.insert(m.curve);
  for (const auto& l : model.node_loads) used.insert(l.curve);
  for (const auto& l : model.segment_loads) used.insert(l.curve);
  for (const auto& l : model.body_loads) used.insert(l.curve);
  for (const auto& w : model.walls)
    if (!w.motion_is_displacement && w.death >= model.control.end.time) used.insert(w.motion);
  for (const Index i : used) {
    if (i < 0) continue;
    const Curve& c = model.curves[i];
    if (c.x.back() < model.control.end.time)
      diagnostics.warning(c.place, "DEFINE_CURVE", "LCID",
                          "curve " + std::to_string(c.id) + " ends at " + number(c.x.back()) +
                              ", before the run does at " + number(model.control.end.time),
                          "loads are zero after the last point of their curve");
  }
}

void check_materials(const Model& model, deck::Diagnostics& diagnostics) {
  std::set<std::string> systems;
  for (const Part& part : model.parts) {
    if (!part.law) continue;
    if (!(part.density > 0.0))
      diagnostics.error(part.place, part.material_keyword, "RO",
                        "the density of part " + std::to_string(part.id) + " must be above 0");
    if (!(part.law->longitudinal_modulus() > 0.0))
      diagnostics.error(part.place, part.material_keyword, "",
                        "the stiffness of part " + std::to_string(part.id) + " must be above 0");
    const double shear = part.law->shear_modulus(), bulk = part.law->bulk_modulus();
    const auto units = guess_units(part.density, 9.0 * bulk * shear / (3.0 * bulk + shear));
    if (!units.empty()) systems.insert(units);
  }
  if (systems.size() > 1) {
    std::string text;
    for (const auto& s : systems) text += (text.empty() ? "" : "; ") + s;
    diagnostics.warning({}, "", "", "by density and stiffness the parts are in different units: " + text,
                        "use one consistent set: force = mass length / time^2");
  }
}

}  // namespace

void check_end_time(const Model& model, const deck::Deck& deck, deck::Diagnostics& diagnostics) {
  if (model.control.end.time > 0.0) return;
  const deck::Place place = deck.blocks().empty() ? deck::Place{} : deck.blocks().front().place;
  diagnostics.error(place, "CONTROL_TERMINATION", "ENDTIM", "the deck gives no end time",
                    "add *CONTROL_TERMINATION");
}

void check(const Model& model, const deck::Deck& deck, deck::Diagnostics& diagnostics) {
  check_elements(model, deck, diagnostics);
  check_thin_elements(model, deck, diagnostics);
  check_nodes(model, deck, diagnostics);
  check_body_loads(model, diagnostics);
  check_curves(model, diagnostics);
  check_materials(model, diagnostics);
}

}  // namespace cleave::model
