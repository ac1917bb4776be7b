/// From supports, motions, loads and silent faces of the model to the targets of boundary faces.

#include <algorithm>
#include <map>

#include "discretisation/spacetime/body_supports.hpp"
#include "discretisation/spacetime/body_wave.hpp"
#include "discretisation/spacetime/mesh_faces.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// A load or silent condition on one side of a face.
template <int D>
struct OnFace {
  int condition = 0;  ///< index into the loads or the silent faces of the model
  Point<D> normal{};  ///< of the segment as it is numbered: the side it means
};

/// Pressure on one face: a history times a vector. [stress]
template <int D>
struct Pressure {
  History history;
  Vector<D> direction;
};

}  // namespace

template <int D>
struct BoundaryConditions<D>::Implementation {
  using Face = std::array<Vertex, D>;

  const model::Model& model;
  const SpaceMeshInput<D>& input;
  const std::vector<Vertex>& vertex_of_node;
  deck::Diagnostics& diagnostics;
  Supports<D> supports;
  std::map<Face, std::vector<OnFace<D>>> loads, silent, waves;
  std::map<int, std::int32_t> part_of_wave;  ///< whose faces the wave comes through
  std::vector<History> load_histories, wave_histories;

  Implementation(const model::Model& m, SpaceMeshInput<D>& in, const std::vector<Vertex>& vertices,
                 deck::Diagnostics& say)
      : model(m),
        input(in),
        vertex_of_node(vertices),
        diagnostics(say),
        supports(m, vertices, in.vertex.size(), say) {
    const std::vector<Face> outer = outer_faces();
    std::vector<Face> boundary = outer;
    for (const Face& face : in.crack) boundary.push_back(sorted(face));
    std::sort(boundary.begin(), boundary.end());
    for (std::size_t l = 0; l < model.segment_loads.size(); ++l) {
      const auto& load = model.segment_loads[l];
      load_histories.emplace_back(model.curves[static_cast<std::size_t>(load.curve)], load.scale,
                                  load.arrival, History::Kind::value);
      find_faces(load.segments, boundary, static_cast<int>(l), "LOAD_SEGMENT", load.place, loads);
    }
    for (std::size_t a = 0; a < model.absorbing.size(); ++a) {
      const auto& faces = model.absorbing[a];
      if (!faces.dilatational || !faces.shear)
        diagnostics.error(faces.place, "BOUNDARY_NON_REFLECTING", faces.shear ? "AD" : "AS",
                          "a boundary that absorbs one kind of wave only is not computed for spacetime parts",
                          "leave AD and AS blank");
      find_faces(faces.segments, boundary, static_cast<int>(a), "BOUNDARY_NON_REFLECTING", faces.place,
                 silent);
    }
    for (std::size_t w = 0; w < model.incident_waves.size(); ++w) {
      const auto& wave = model.incident_waves[w];
      wave_histories.emplace_back(model.curves[static_cast<std::size_t>(wave.curve)], wave.scale,
                                  wave.arrival, History::Kind::value);
      find_faces(wave.segments, boundary, static_cast<int>(w), "LOAD_INCIDENT_WAVE", wave.place, waves);
    }
    tag_faces(in, outer);

    std::vector<char> on_boundary(in.vertex.size(), 0);
    for (const Face& face : boundary) {
      supports.of_face(face);
      for (const Vertex v : face) on_boundary[static_cast<std::size_t>(v)] = 1;
    }
    supports.report_unused(on_boundary, in.vertex_id);
  }

  /// Faces of one simplex only, vertices ascending, sorted.
  std::vector<Face> outer_faces() const {
    std::vector<Face> all, outer;
    for (const auto& simplex : input.simplex)
      for (int i = 0; i <= D; ++i) all.push_back(sorted(face_of<D>(simplex, i)));
    std::sort(all.begin(), all.end());
    for (std::size_t a = 0, b; a < all.size(); a = b) {
      for (b = a + 1; b < all.size() && all[b] == all[a]; ++b) {
      }
      if (b == a + 1) outer.push_back(all[a]);
    }
    return outer;
  }

  void find_faces(const std::vector<model::Segment>& segments, const std::vector<Face>& boundary,
                  int condition, const char* keyword, const deck::Place& place,
                  std::map<Face, std::vector<OnFace<D>>>& into) {
    std::vector<std::string> lost;
    for (const model::Segment& segment : segments) {
      Face face{}, ordered{};
      bool found = corner_count(segment) == D;
      for (std::size_t k = 0; k < D && found; ++k) {
        ordered[k] = vertex_of_node[static_cast<std::size_t>(segment.node[k])];
        found = ordered[k] >= 0;
      }
      face = sorted(ordered);
      if (!found || !std::binary_search(boundary.begin(), boundary.end(), face)) {
        std::string nodes;
        for (int k = 0; k < corner_count(segment); ++k) {
          if (k > 0) nodes += '-';
          nodes += std::to_string(model.mesh.nodes.id[static_cast<std::size_t>(segment.node[k])]);
        }
        lost.push_back(nodes);
        continue;
      }
      into[face].push_back({condition, normal_of(ordered)});
    }
    if (lost.empty()) return;
    std::string text = lost[0];
    for (std::size_t k = 1; k < std::min<std::size_t>(lost.size(), 5); ++k) text += ", " + lost[k];
    if (lost.size() > 5) text += " and " + std::to_string(lost.size() - 5) + " more";
    diagnostics.error(place, keyword, "", "segments that are no face on the boundary of the body: " + text,
                      D == 2   ? "name the two nodes of an edge of the outline, or of a crack"
                      : D == 3 ? "name the three nodes of a face of a tetrahedron on the surface"
                               : "name the end of the bar");
  }

  /// Normal of a segment by the order of its nodes: in the plane to the right of N1-N2; zero on a line.
  Point<D> normal_of(const Face& ordered) const {
    const auto x = [&](std::size_t i) { return input.vertex[static_cast<std::size_t>(ordered[i])]; };
    Point<D> n{};
    if constexpr (D == 2) {
      const auto along = difference(x(1), x(0));
      n = {along[1], -along[0]};
    }
    if constexpr (D == 3) {
      const auto a = difference(x(1), x(0)), b = difference(x(2), x(0));
      n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
    return n;
  }

  /// Faces with the same conditions get the same tag, free ones 0.
  void tag_faces(SpaceMeshInput<D>& in, const std::vector<Face>& outer) const {
    std::map<std::vector<int>, std::int32_t> tags;
    tags.emplace(std::vector<int>{-1, -1}, 0);
    for (const Face& face : outer) {
      std::vector<int> key = supports.key(face);
      for (const auto* conditions : {&loads, &silent, &waves}) {
        key.push_back(-1);
        if (const auto at = conditions->find(face); at != conditions->end())
          for (const auto& one : at->second) key.push_back(one.condition);
      }
      const auto tag = tags.emplace(key, static_cast<std::int32_t>(tags.size())).first->second;
      if (tag != 0) in.tag.push_back({face, tag});
    }
  }

  std::string name(const Face& face) const {
    std::string text;
    for (const Vertex v : face) {
      if (!text.empty()) text += '-';
      text += std::to_string(input.vertex_id[static_cast<std::size_t>(v)]);
    }
    return text;
  }

  /// Pressures that act on this side of a face. Both faces of a crack have the same vertices: the order of
  /// the segment's nodes says which is meant.
  std::vector<Pressure<D>> pressures(const BoundaryFace<D>& face, const Face& key) {
    std::vector<Pressure<D>> list;
    const auto at = loads.find(key);
    if (at == loads.end()) return list;
    for (const OnFace<D>& load : at->second) {
      const double side = dot(load.normal, face.normal);
      if (side < 0.0 && face.crack >= 0) continue;
      const auto& asked = model.segment_loads[static_cast<std::size_t>(load.condition)];
      if (side < 0.0)
        diagnostics.warning(
            asked.place, "LOAD_SEGMENT", "N1",
            "segment " + name(key) + " is numbered with the body on the wrong side: its pressure pulls",
            D == 2 ? "have the body on the left when going from N1 to N2"
                   : "number its nodes counter-clockwise seen from outside");
      Vector<D> direction;
      for (int k = 0; k < D; ++k) direction[k] = side < 0.0 ? face.normal[k] : -face.normal[k];
      list.push_back({load_histories[static_cast<std::size_t>(load.condition)], direction});
    }
    return list;
  }

  /// The sum of what the incident waves bring to a silent face; empty where there are none.
  VectorField<D> incident(const Body<D>& body, const BoundaryFace<D>& face, const Face& key) {
    const auto at = waves.find(key);
    if (at == waves.end()) return {};
    const std::int32_t part = body.mesh.material(face.simplex);
    const Elastic<D>& material = body.problem.materials[static_cast<std::size_t>(part)];
    const auto refuse = [&](const OnFace<D>& wave, const std::string& what, std::string instead) {
      diagnostics.error(model.incident_waves[static_cast<std::size_t>(wave.condition)].place,
                        "LOAD_INCIDENT_WAVE", "SSID", "face " + name(key) + " " + what, std::move(instead));
    };
    std::vector<VectorField<D>> sum;
    Vector<D> normal;
    for (std::size_t k = 0; k < D; ++k) normal[k] = face.normal[k];
    for (const OnFace<D>& wave : at->second) {
      if (!silent.contains(key)) {
        refuse(wave, "is not silent: a wave cannot come in there",
               "name it in *BOUNDARY_NON_REFLECTING as well");
        return {};
      }
      if (!material.isotropic) {
        refuse(wave, "is of an anisotropic part", "incident waves are computed for isotropic materials");
        return {};
      }
      const auto [first, fresh] = part_of_wave.try_emplace(wave.condition, part);
      if (!fresh && first->second != part) {
        refuse(wave, "is of part " + id_of(part) + ", others of the wave are of part " + id_of(first->second),
               "a plane wave comes through one material: let all its faces be of one part");
        return {};
      }
      const auto w = static_cast<std::size_t>(wave.condition);
      sum.push_back(incident_characteristic<D>(model.incident_waves[w], wave_histories[w], material, normal));
    }
    if (sum.size() == 1) return sum[0];
    return [sum = std::move(sum)](const Event<D>& y) {
      Vector<D> total{};
      for (const auto& one : sum) {
        const Vector<D> w = one(y);
        for (std::size_t k = 0; k < D; ++k) total[k] += w[k];
      }
      return total;
    };
  }
  std::string id_of(std::int32_t part) const {
    return std::to_string(model.parts[static_cast<std::size_t>(part)].id);
  }

  TargetPtr<D> make(const Body<D>& body, const BoundaryFace<D>& face, const Face& key,
                    const HeldFace<D>& held, std::vector<Pressure<D>> pressure) {
    VectorField<D> incoming = incident(body, face, key);
    if (const auto at = silent.find(key); at != silent.end()) {
      const auto& asked = model.absorbing[static_cast<std::size_t>(at->second.front().condition)];
      if (held.held > 0 || !pressure.empty())
        diagnostics.error(asked.place, "BOUNDARY_NON_REFLECTING", "SSID",
                          "face " + name(key) + " is to be silent and is held or loaded as well",
                          "take its nodes out of one of the two");
      return make_silent<D>(std::move(incoming));
    }
    if (!pressure.empty() && held.held > 0) {
      Vector<D> into{};
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) into[i] += held.projector[i][j] * face.normal[j];
      if (norm(into) > 1e-6) {
        const auto& asked = model.segment_loads[static_cast<std::size_t>(loads.at(key).front().condition)];
        diagnostics.error(
            asked.place, "LOAD_SEGMENT", "",
            "the pressure on segment " + name(key) + " acts along a direction in which it is held",
            "take its nodes out of the support, or the load away");
      }
    }
    VectorField<D> traction;
    if (!pressure.empty())
      traction = [pressure = std::move(pressure)](const Event<D>& y) {
        Vector<D> s{};
        for (const Pressure<D>& p : pressure) {
          const double size = p.history(y[D]);
          for (int i = 0; i < D; ++i) s[i] += size * p.direction[i];
        }
        return s;
      };
    if (held.held == 0) return make_traction<D>(std::move(traction));
    return make_projected<D>(held.projector, velocity(key, held), std::move(traction));
  }

  /// Velocity on a face; linear between its vertices unless they move alike.
  VectorField<D> velocity(const Face& key, const HeldFace<D>& held) const {
    if (!held.moves()) return {};
    const auto sum = [histories = supports.histories()](const VelocityTerms<D>& terms, double time,
                                                        double factor, Vector<D>& v) {
      for (const auto& [history, direction] : terms) {
        const double size = factor * histories[static_cast<std::size_t>(history)](time);
        for (int i = 0; i < D; ++i) v[i] += size * direction[i];
      }
    };
    if (held.uniform)
      return [sum, terms = held.velocity[0]](const Event<D>& y) {
        Vector<D> v{};
        sum(terms, y[D], 1.0, v);
        return v;
      };
    std::array<Point<D>, D> corner;
    for (std::size_t a = 0; a < D; ++a) corner[a] = input.vertex[static_cast<std::size_t>(key[a])];
    return [sum, corner, terms = held.velocity](const Event<D>& y) {
      Point<D> x;
      for (std::size_t k = 0; k < D; ++k) x[k] = y[k];
      const auto weight = barycentric(corner, x);
      Vector<D> v{};
      for (std::size_t a = 0; a < D; ++a) sum(terms[a], y[D], weight[a], v);
      return v;
    };
  }

  /// Weights of the corners of a segment or triangle at a point in it.
  static std::array<double, D> barycentric(const std::array<Point<D>, D>& corner, const Point<D>& x) {
    std::array<double, D> weight{};
    weight[0] = 1.0;
    if constexpr (D == 2) {
      const auto e = difference(corner[1], corner[0]);
      weight[1] = dot(e, difference(x, corner[0])) / dot(e, e);
    }
    if constexpr (D == 3) {
      const auto e = difference(corner[1], corner[0]), f = difference(corner[2], corner[0]),
                 r = difference(x, corner[0]);
      const double ee = dot(e, e), ff = dot(f, f), ef = dot(e, f), det = ee * ff - ef * ef;
      weight[1] = (ff * dot(e, r) - ef * dot(f, r)) / det;
      weight[2] = (ee * dot(f, r) - ef * dot(e, r)) / det;
    }
    for (std::size_t a = 1; a < D; ++a) weight[0] -= weight[a];
    return weight;
  }
};

template <int D>
BoundaryConditions<D>::BoundaryConditions(const model::Model& model, SpaceMeshInput<D>& input,
                                          const std::vector<Vertex>& vertex_of_node,
                                          deck::Diagnostics& diagnostics)
    : implementation_(std::make_unique<Implementation>(model, input, vertex_of_node, diagnostics)) {}

template <int D>
BoundaryConditions<D>::~BoundaryConditions() = default;

template <int D>
void BoundaryConditions<D>::make_targets(Body<D>& body) {
  Implementation& conditions = *implementation_;
  // Faces with the same conditions and, where it matters, the same normal share a target.
  std::map<std::pair<std::vector<int>, std::vector<double>>, const Target<D>*> made;
  for (const BoundaryFace<D>& face : body.mesh.boundary()) {
    std::array<Vertex, D> key;
    for (std::size_t k = 0; k < D; ++k) key[k] = body.mesh.origin(face.vertex[k]);
    key = sorted(key);
    std::vector<int> condition = conditions.supports.key(key);
    std::vector<double> normal;
    for (const auto* list : {&conditions.loads, &conditions.silent, &conditions.waves}) {
      condition.push_back(-1);
      if (const auto at = list->find(key); at != list->end())
        for (const auto& one : at->second) {
          condition.push_back(one.condition);
          normal.assign(face.normal.begin(), face.normal.end());
          normal.insert(normal.end(), one.normal.begin(), one.normal.end());
        }
    }
    if (conditions.waves.contains(key)) condition.push_back(body.mesh.material(face.simplex));
    auto& target = made[{condition, normal}];
    if (!target) {
      body.target.push_back(conditions.make(body, face, key, conditions.supports.of_face(key),
                                            conditions.pressures(face, key)));
      target = body.target.back().get();
    }
    body.problem.targets.push_back(target);
  }
}

template class BoundaryConditions<1>;
template class BoundaryConditions<2>;
template class BoundaryConditions<3>;

}  // namespace cleave::discretisation::spacetime
