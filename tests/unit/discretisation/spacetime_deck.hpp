#pragma once
/// Spacetime bodies from deck text, for the tests of this folder.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/threads.hpp"
#include "deck/deck.hpp"
#include "discretisation/spacetime/body.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "model/keyword/row_place.hpp"

namespace cleave::discretisation::spacetime::test {

template <int D>
struct FromDeck {
  deck::Diagnostics diagnostics;
  model::Model model;
  std::unique_ptr<const Body<D>> body;

  explicit FromDeck(const std::string& text) {
    model::Account account;
    const deck::Deck deck = deck::Deck::read_text(text, "test.k", {}, diagnostics);
    model = model::build(deck, {}, diagnostics, account);
    if (!diagnostics.failed()) body = make_body<D>(model, diagnostics);
    model::find_rows(deck, diagnostics);
  }
  std::string text() const {
    std::string all;
    for (const auto& d : diagnostics.all())
      all += std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + d.keyword + " " +
             d.field + ": " + d.message + " | " + d.hint + "\n";
    return all;
  }
  /// Is there an error at this line whose text holds the phrase?
  bool refuses(int line, std::string_view phrase) const {
    for (const auto& d : diagnostics.all())
      if (d.severity == deck::Severity::error && d.place.line == line &&
          d.message.find(phrase) != std::string::npos)
        return true;
    return false;
  }
  /// The boundary face with these nodes (the `side`th of a crack); -1 if there is none.
  int face(std::vector<model::Id> nodes, int side = 0) const {
    std::sort(nodes.begin(), nodes.end());
    const auto& boundary = body->mesh.boundary();
    for (std::size_t f = 0; f < boundary.size(); ++f) {
      std::vector<model::Id> own;
      for (const Vertex v : boundary[f].vertex) own.push_back(body->mesh.vertex_id(v));
      std::sort(own.begin(), own.end());
      if (own == nodes && side-- == 0) return static_cast<int>(f);
    }
    return -1;
  }
  /// Star values on a boundary face at a time, from given traces of the body.
  Star<D> star(int face, double time, const Vector<D>& v = {}, const Vector<D>& s = {}) const {
    const BoundaryFace<D>& at = body->mesh.boundary()[static_cast<std::size_t>(face)];
    Interface<D> facet;
    facet.n = at.normal;
    facet.minus = &body->problem.materials[static_cast<std::size_t>(body->mesh.material(at.simplex))];
    facet.z_minus = facet.minus->impedance(facet.n);
    Event<D> middle{};
    for (const Vertex w : at.vertex)
      for (int k = 0; k < D; ++k) middle[k] += body->mesh.position()[static_cast<std::size_t>(w)][k] / D;
    middle[D] = time;
    Traces<D> traces;
    traces.v_minus = v;
    traces.s_minus = s;
    StarMap<D> map;
    Star<D> load;
    body->problem.targets[static_cast<std::size_t>(face)]->star(facet, {&middle, 1}, {&traces, 1}, {&map, 1},
                                                                {&load, 1});
    return map.apply(traces, load);
  }
};

/// Marches a body to its end on one thread; the solutions under the last front, by simplex. Any patch that is
/// not solved fails the test.
template <int D>
std::vector<Solution<D>> solve(const Body<D>& body) {
  base::set_thread_count(1);
  const Pitcher<D> pitcher(body.mesh, body.pitch);
  Front<D> front = pitcher.level_front(0.0);
  std::vector<Solution<D>> under(static_cast<std::size_t>(body.mesh.simplex_count()));
  std::vector<char> begun(under.size(), 0);
  PatchSolver<D> solver(body.problem);
  const FrontStatus status =
      Scheduler<D>(pitcher).advance(front, body.end_time, [&](const Patch<D>& patch) -> Verdict {
        std::vector<const Solution<D>*> older(patch.facets.size(), nullptr);
        std::vector<Solution<D>> out(patch.elements.size());
        const auto simplex = [&](std::int32_t element) {
          return static_cast<std::size_t>(patch.elements[static_cast<std::size_t>(element)].simplex);
        };
        for (std::size_t f = 0; f < patch.facets.size(); ++f)
          if (patch.facets[f].kind == FacetKind::inflow && begun[simplex(patch.facets[f].element)])
            older[f] = &under[simplex(patch.facets[f].element)];
        if (solver.solve(patch, older, out) != PatchStatus::solved)
          return {.kind = Verdict::fail, .what = "patch not solved"};
        for (std::size_t e = 0; e < out.size(); ++e) {
          under[simplex(static_cast<std::int32_t>(e))] = std::move(out[e]);
          begun[simplex(static_cast<std::int32_t>(e))] = 1;
        }
        return {};
      });
  EXPECT_TRUE(status.ok) << status.what;
  return under;
}

/// A bar from 0 to 1 in two elements, 1 (nodes 1, 2) and 2 (nodes 2, 3), of the material below.
inline const std::string bar_of_two =
    "*KEYWORD\n"
    "*CONTROL_TERMINATION\n1.0\n"
    "*MAT_ELASTIC\n1,2.0,2.5,0.25\n"
    "*SECTION_BEAM_SDG\n1,1,0,0,0.5\n"
    "*PART\nbar\n1,1,1\n"
    "*NODE\n1,0,0,0\n2,0.5,0,0\n3,1,0,0\n"
    "*ELEMENT_BEAM\n1,1,1,2\n2,1,2,3\n"
    "*DEFINE_CURVE\n9\n0,0\n2,2\n";
inline const int after_bar = 22;
/// One tetrahedron, element 1, with its corners at the origin and the unit points of the axes; same material.
inline const std::string tetrahedron =
    "*KEYWORD\n"
    "*CONTROL_TERMINATION\n1.0\n"
    "*MAT_ELASTIC\n1,2.0,2.5,0.25\n"
    "*SECTION_SOLID_SDG\n1,\n"
    "*PART\ntetrahedron\n1,1,1\n"
    "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n"
    "*ELEMENT_SOLID\n1,1,1,2,3,4,4,4,4,4\n"
    "*DEFINE_CURVE\n9\n0,0\n2,2\n";
inline const int after_tetrahedron = 22;

/// Unit square of density 2, E = 2.5, nu = 0.25 (plane strain: lambda = mu = 1), nodes 1-4 around it and 5 in
/// its middle, triangles 11 (below), 12, 13, 14 counter-clockwise. Ends without *END, so that text can
/// follow.
inline const std::string square =
    "*KEYWORD\n"
    "*CONTROL_TERMINATION\n1.0\n"
    "*MAT_ELASTIC\n1,2.0,2.5,0.25\n"
    "*SECTION_SHELL_SDG\n1\n"
    "*PART\nsquare\n1,1,1\n"
    "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0.5,0.5,0\n"
    "*ELEMENT_SHELL\n11,1,1,2,5,5\n12,1,2,3,5,5\n13,1,3,4,5,5\n14,1,4,1,5,5\n"
    "*DEFINE_CURVE\n9\n0,0\n2,2\n";
inline const int after_square = 26;  ///< line of the first one after `square`
/// As above, with these words exchanged.
inline std::string square_with(const std::string& from, const std::string& to) {
  std::string text = square;
  return text.replace(text.find(from), from.size(), to);
}

/// Unit square of n by n quadrilaterals of the same material; node 1 + i + j (n + 1) at (i, j) / n.
inline std::string plate(int n) {
  std::string text = square.substr(0, square.find("*NODE")) + "*NODE\n";
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      text += std::to_string(1 + i + j * (n + 1)) + "," + std::to_string(double(i) / n) + "," +
              std::to_string(double(j) / n) + ",0\n";
  text += "*ELEMENT_SHELL\n";
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = 1 + i + j * (n + 1);
      text += std::to_string(1 + i + j * n) + ",1," + std::to_string(a) + "," + std::to_string(a + 1) + "," +
              std::to_string(a + n + 2) + "," + std::to_string(a + n + 1) + "\n";
    }
  return text + square.substr(square.find("*DEFINE_CURVE"));
}
/// Line of the first one after plate(n).
inline int after_plate(int n) {
  return 17 + (n + 1) * (n + 1) + n * n;
}

}  // namespace cleave::discretisation::spacetime::test
