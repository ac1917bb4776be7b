/// Elements of the model as simplices of a space mesh: shells turned and split, tetrahedra, bars.

#include <algorithm>
#include <map>

#include "discretisation/spacetime/body_steps.hpp"

namespace cleave::discretisation::spacetime {
namespace {

template <int D>
class Gatherer {
 public:
  Gatherer(const model::Model& model, SpaceMeshInput<D>& input, Body<D>& body,
           std::vector<Vertex>& vertex_of_node, deck::Diagnostics& diagnostics)
      : model_(model),
        input_(input),
        body_(body),
        vertex_of_node_(vertex_of_node),
        diagnostics_(diagnostics) {}

  void run() {
    vertex_of_node_.assign(model_.mesh.nodes.count(), -1);
    const auto& groups = D == 1 ? model_.mesh.beams : D == 2 ? model_.mesh.shells : model_.mesh.solids;
    for (const model::Elements& group : groups) check_shape(group);
    if (said_) return;
    number_nodes(groups);
    if constexpr (D == 2) find_clockwise(groups);
    if (said_) return;
    for (const model::Elements& group : groups) {
      const auto n = static_cast<std::size_t>(model::nodes_of(group.shape));
      for (std::size_t e = 0; e < group.count(); ++e) add(group, e, &group.node[e * n]);
    }
    report_faults();
    if (input_.simplex.empty() && !said_)
      error(model_.parts.front().place, "the model has no elements", "add *ELEMENT_SHELL, _SOLID or _BEAM");
    for (const Elastic<D>& material : body_.problem.materials)
      input_.speed.push_back({material.fastest, slowest(material)});
  }

 private:
  /// @param row the better place, where the deck has it
  void error(const deck::Place& place, std::string what, std::string instead, deck::NumberedRow row = {}) {
    const bool node = row.kind == deck::NumberedRow::Kind::node;
    diagnostics_.add({.severity = deck::Severity::error,
                      .place = place,
                      .keyword = node     ? "NODE"
                                 : D == 1 ? "ELEMENT_BEAM"
                                 : D == 2 ? "ELEMENT_SHELL"
                                          : "ELEMENT_SOLID",
                      .field = node     ? "NID"
                               : row.id ? "EID"
                                        : "",
                      .message = std::move(what),
                      .hint = std::move(instead),
                      .row = row});
    said_ = true;
  }
  static deck::NumberedRow element_row(model::Id id) { return {deck::NumberedRow::Kind::element, id}; }
  const model::Part& part_of(const model::Elements& group, std::size_t e) const {
    return model_.parts[static_cast<std::size_t>(group.part[e])];
  }
  const double* place_of(model::Index node) const {
    return &model_.mesh.nodes.position[3 * static_cast<std::size_t>(node)];
  }

  void check_shape(const model::Elements& group) {
    if (D < 3 || group.shape == model::Shape::tet4 || group.count() == 0) return;
    error(part_of(group, 0).place,
          "part " + std::to_string(part_of(group, 0).id) + " has " + std::string(name_of(group.shape)) +
              " elements, e.g. " + std::to_string(group.id[0]),
          "spacetime parts are made of 4-node tetrahedra", element_row(group.id[0]));
  }

  /// Vertices are the nodes of the elements, in the order of the nodes. All must lie in the plane, or on the
  /// line, of the first.
  void number_nodes(const std::vector<model::Elements>& groups) {
    std::vector<char> used(model_.mesh.nodes.count(), 0);
    for (const model::Elements& group : groups)
      for (const model::Index node : group.node) used[static_cast<std::size_t>(node)] = 1;
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    std::vector<model::Id> outside;
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      const double* x = place_of(static_cast<model::Index>(i));
      const bool first = input_.vertex.empty();
      for (int k = 0; k < 3; ++k) {
        low[k] = first ? x[k] : std::min(low[k], x[k]);
        high[k] = first ? x[k] : std::max(high[k], x[k]);
      }
      vertex_of_node_[i] = static_cast<Vertex>(input_.vertex.size());
      Point<D> point;
      for (std::size_t k = 0; k < D; ++k) point[k] = x[k];
      input_.vertex.push_back(point);
      input_.vertex_id.push_back(model_.mesh.nodes.id[i]);
      body_.node_of_vertex.push_back(static_cast<model::Index>(i));
    }
    const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    for (const model::Index i : body_.node_of_vertex)
      for (int k = D; k < 3; ++k)
        if (place_of(i)[k] - place_of(body_.node_of_vertex.front())[k] > 1e-9 * size ||
            place_of(i)[k] - place_of(body_.node_of_vertex.front())[k] < -1e-9 * size) {
          outside.push_back(model_.mesh.nodes.id[static_cast<std::size_t>(i)]);
          break;
        }
    if (!outside.empty())
      error(model_.parts.front().place,
            (D == 2 ? std::string("nodes outside the plane z = ")
                    : std::string("nodes off the line of node ")) +
                (D == 2 ? shortest(place_of(body_.node_of_vertex.front())[2])
                        : std::to_string(
                              model_.mesh.nodes.id[static_cast<std::size_t>(body_.node_of_vertex[0])])) +
                ": " + listed(outside),
            D == 2 ? "parts with *SECTION_SHELL_SDG lie in a plane parallel to xy"
                   : "parts with *SECTION_BEAM_SDG lie along x",
            {deck::NumberedRow::Kind::node, outside.front()});
  }

  // --- shells ------------------------------------------------------------------------------------------

  double area(model::Index a, model::Index b, model::Index c) const {
    const double *x = place_of(a), *y = place_of(b), *z = place_of(c);
    return 0.5 * ((y[0] - x[0]) * (z[1] - x[1]) - (y[1] - x[1]) * (z[0] - x[0]));
  }
  double signed_area(const model::Elements& group, std::size_t e) const {
    if (group.shape == model::Shape::tri3)
      return area(group.node[3 * e], group.node[3 * e + 1], group.node[3 * e + 2]);
    const model::Index* n = &group.node[4 * e];
    return area(n[0], n[1], n[2]) + area(n[0], n[2], n[3]);
  }

  /// A part seen from behind, all its shells clockwise, is turned around; a clockwise shell among others is
  /// a mistake.
  void find_clockwise(const std::vector<model::Elements>& groups) {
    std::vector<std::size_t> total(model_.parts.size(), 0);
    std::vector<std::vector<model::Id>> clockwise(model_.parts.size());
    for (const model::Elements& group : groups)
      for (std::size_t e = 0; e < group.count(); ++e) {
        const auto part = static_cast<std::size_t>(group.part[e]);
        ++total[part];
        if (signed_area(group, e) < 0.0) clockwise[part].push_back(group.id[e]);
      }
    turned_.assign(model_.parts.size(), 0);
    for (std::size_t p = 0; p < turned_.size(); ++p) {
      const model::Part& part = model_.parts[p];
      if (clockwise[p].empty()) continue;
      if (clockwise[p].size() < total[p]) {
        error(part.place,
              "part " + std::to_string(part.id) +
                  " has inverted elements among others: " + listed(clockwise[p]),
              "number all shells of a part counter-clockwise seen from above, or all clockwise",
              element_row(clockwise[p].front()));
      } else {
        turned_[p] = 1;
        diagnostics_.warning(part.place, "PART", "PID",
                             "all shells of part " + std::to_string(part.id) +
                                 " are numbered clockwise seen from above; they are turned around",
                             "z points at you when x points right and y up");
      }
    }
  }

  /// 1 for an equilateral triangle, 0 or less for a degenerate one.
  double quality(model::Index a, model::Index b, model::Index c) const {
    double edges = 0.0;
    for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
      for (int k = 0; k < 2; ++k)
        edges += (place_of(p)[k] - place_of(q)[k]) * (place_of(p)[k] - place_of(q)[k]);
    return edges > 0.0 ? 4.0 * std::sqrt(3.0) * area(a, b, c) / edges : 0.0;
  }

  void simplex(const std::array<model::Index, D + 1>& node, const model::Elements& group, std::size_t e) {
    std::array<Vertex, D + 1> corner;
    std::array<Point<D>, D + 1> place;
    double longest = 0.0;
    for (std::size_t i = 0; i <= D; ++i) {
      corner[i] = vertex_of_node_[static_cast<std::size_t>(node[i])];
      place[i] = input_.vertex[static_cast<std::size_t>(corner[i])];
      for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, distance(place[i], place[j]));
    }
    const double volume = signed_volume<static_cast<std::size_t>(D)>(place);
    if (!(std::abs(volume) > 1e-12 * std::pow(longest, D))) {
      degenerate_[group.part[e]].push_back(group.id[e]);
      return;
    }
    if (D > 1 && volume < 0.0) {
      folded_[group.part[e]].push_back(group.id[e]);
      return;
    }
    input_.simplex.push_back(corner);
    input_.material.push_back(group.part[e]);
    input_.simplex_id.push_back(group.id[e]);
    body_.element_of_simplex.push_back(group.id[e]);
  }

  void add(const model::Elements& group, std::size_t e, const model::Index* node) {
    if constexpr (D == 1) simplex({node[0], node[1]}, group, e);
    if constexpr (D == 3) simplex({node[0], node[1], node[2], node[3]}, group, e);
    if constexpr (D == 2) {
      const bool turned = turned_[static_cast<std::size_t>(group.part[e])];
      if (group.shape == model::Shape::tri3) {
        simplex({node[0], node[turned ? 2 : 1], node[turned ? 1 : 2]}, group, e);
        return;
      }
      // The diagonal whose worse triangle is the better one; N1-N3 where they are as good as each other.
      const model::Index a = node[0], b = node[turned ? 3 : 1], c = node[2], d = node[turned ? 1 : 3];
      const double first = std::min(quality(a, b, c), quality(a, c, d)),
                   second = std::min(quality(b, c, d), quality(b, d, a));
      if (first >= second * (1.0 - 1e-9)) {
        simplex({a, b, c}, group, e);
        simplex({a, c, d}, group, e);
      } else {
        simplex({b, c, d}, group, e);
        simplex({b, d, a}, group, e);
      }
    }
  }

  void report_faults() {
    for (const auto& [part, ids] : degenerate_)
      error(model_.parts[static_cast<std::size_t>(part)].place,
            "part " + std::to_string(model_.parts[static_cast<std::size_t>(part)].id) +
                " has degenerate elements, whose corners lie in one " +
                (D == 3   ? "plane"
                 : D == 2 ? "line"
                          : "point") +
                ": " + listed(ids),
            "repeated or misplaced nodes", element_row(ids.front()));
    for (const auto& [part, ids] : folded_)
      error(model_.parts[static_cast<std::size_t>(part)].place,
            "part " + std::to_string(model_.parts[static_cast<std::size_t>(part)].id) +
                " has inverted elements: " + listed(ids),
            D == 2 ? "the corners of a quadrilateral must go around it" : "exchange two of their nodes",
            element_row(ids.front()));
  }

  /// Smallest phase speed over directions, sampled. [length/time]
  static double slowest(const Elastic<D>& material) {
    if (!(material.density > 0.0)) return 0.0;
    double least = 1e300;
    const int count = D == 1 ? 1 : 36;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < (D == 3 ? 18 : 1); ++j) {
        const double a = i * 3.14159265358979 / count, b = j * 3.14159265358979 / 18;
        Vector<D> n{};
        if constexpr (D == 1) n = {1.0};
        if constexpr (D == 2) n = {std::cos(a), std::sin(a)};
        if constexpr (D == 3) n = {std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b)};
        least = std::min(least, material.speeds(n)[0]);
      }
    return least;
  }

  const model::Model& model_;
  SpaceMeshInput<D>& input_;
  Body<D>& body_;
  std::vector<Vertex>& vertex_of_node_;
  deck::Diagnostics& diagnostics_;
  bool said_ = false;
  std::vector<char> turned_;  ///< [part]
  std::map<model::Index, std::vector<model::Id>> degenerate_, folded_;
};

}  // namespace

template <int D>
void gather_elements(const model::Model& model, SpaceMeshInput<D>& input, Body<D>& body,
                     std::vector<Vertex>& vertex_of_node, deck::Diagnostics& diagnostics) {
  Gatherer<D>(model, input, body, vertex_of_node, diagnostics).run();
}

#define CLEAVE_INSTANTIATE(D)                                                                               \
  template void gather_elements<D>(const model::Model&, SpaceMeshInput<D>&, Body<D>&, std::vector<Vertex>&, \
                                   deck::Diagnostics&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
