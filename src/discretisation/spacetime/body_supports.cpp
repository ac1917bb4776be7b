#include "discretisation/spacetime/body_supports.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "discretisation/spacetime/dense.hpp"

namespace cleave::discretisation::spacetime {
namespace {

constexpr double dependent = 1e-9;  ///< sine of the angle below which two directions are one

double component(const model::Vector& v, int k) {
  return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

}  // namespace

template <int D>
bool HeldFace<D>::moves() const {
  return std::any_of(velocity.begin(), velocity.end(), [](const auto& terms) { return !terms.empty(); });
}

template <int D>
bool Supports<D>::Span::add(const Row& row) {
  Vector<D> d = row.direction;
  std::map<int, double> rest;
  if (row.history >= 0) rest[row.history] = 1.0;
  for (int k = 0; k < count; ++k) {
    const double share = dot(row.direction, axis[k]);
    for (int i = 0; i < D; ++i) d[i] -= share * axis[k][i];
    for (const auto& [history, factor] : value[k]) rest[history] -= share * factor;
  }
  const double size = norm(d);
  if (size < dependent)
    return std::all_of(rest.begin(), rest.end(),
                       [](const auto& r) { return std::fabs(r.second) < dependent; });
  for (double& x : d) x /= size;
  for (auto& [history, factor] : rest) factor /= size;
  axis[count] = d;
  value[count] = std::move(rest);
  ++count;
  return true;
}

template <int D>
Matrix<D> Supports<D>::Span::projector() const {
  Matrix<D> p{};
  for (int k = 0; k < count; ++k)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) p[i][j] += axis[k][i] * axis[k][j];
  return p;
}

template <int D>
VelocityTerms<D> Supports<D>::Span::velocity() const {
  VelocityTerms<D> terms;
  for (int k = 0; k < count; ++k)
    for (const auto& [history, factor] : value[k])
      for (int i = 0; i < D; ++i) terms[history][i] += factor * axis[k][i];
  return terms;
}

template <int D>
Supports<D>::Supports(const model::Model& model, const std::vector<Vertex>& vertex_of_node,
                      std::size_t vertex_count, deck::Diagnostics& diagnostics)
    : vertex_of_node_(vertex_of_node),
      end_time_(model.control.end.time),
      diagnostics_(diagnostics),
      rows_of_(vertex_count) {
  // Motions go before fixed directions, later motions before earlier ones, as in explicit dynamics.
  for (auto motion = model.motions.rbegin(); motion != model.motions.rend(); ++motion)
    add_motion(model, *motion);
  for (const model::FixedNodes& fixed : model.fixed) add_fixed(fixed);
  for (const auto& rows : rows_of_) used_.emplace_back(rows.size(), 0);
}

template <int D>
void Supports<D>::add(const std::vector<model::Index>& nodes, const model::Vector& direction, int history,
                      int condition) {
  const Condition& from = conditions_[static_cast<std::size_t>(condition)];
  Row row{.direction = {}, .history = history, .condition = condition};
  double across = 0.0;
  for (int k = 0; k < 3; ++k)
    (k < D ? row.direction[k] : across) =
        k < D ? component(direction, k) : std::hypot(across, component(direction, k));
  const double along = norm(row.direction);
  if (along < dependent) {  // out of the plane nothing moves
    if (history >= 0)
      diagnostics_.error(from.place, from.keyword, "", "this motion leaves the plane or line of the body",
                         "prescribe motion along x or y only");
    return;
  }
  if (across > dependent) {
    diagnostics_.error(from.place, from.keyword, "",
                       "a direction that is neither in the plane or line of the body "
                       "nor across it",
                       "hold or move nodes in the plane");
    return;
  }
  const int number = static_cast<int>(rows_.size());
  rows_.push_back(row);
  for (const model::Index node : nodes)
    if (const Vertex v = vertex_of_node_[static_cast<std::size_t>(node)]; v >= 0) {
      auto& list = rows_of_[static_cast<std::size_t>(v)];
      if (list.empty() || list.back() != number) list.push_back(number);
    }
}

template <int D>
void Supports<D>::add_motion(const model::Model& model, const model::PrescribedMotion& motion) {
  using Kind = model::PrescribedMotion::Kind;
  const std::string keyword = "BOUNDARY_PRESCRIBED_MOTION";
  if (motion.birth > 0.0 || motion.death < end_time_)
    return diagnostics_.error(
        motion.place, keyword, motion.birth > 0.0 ? "BIRTH" : "DEATH",
        "a motion that begins or ends during the run is not computed for spacetime parts",
        "let the curve of a velocity be 0 before it begins; leave BIRTH and DEATH blank");
  if (motion.rotation || motion.kind == Kind::velocity_by_displacement)
    return diagnostics_.error(motion.place, keyword, motion.rotation ? "DOF" : "VAD",
                              motion.rotation
                                  ? "rotation about an axis is not computed for spacetime parts"
                                  : "velocity over displacement is not computed for spacetime parts",
                              "prescribe velocities or displacements over time, along DOF 1, 2 or 3");
  const model::Curve& curve = model.curves[static_cast<std::size_t>(motion.curve)];
  if (motion.kind == Kind::displacement) {
    bool jumps = curve.value(0.0) != 0.0;
    for (std::size_t i = 1; i < curve.x.size(); ++i)
      jumps = jumps || (curve.x[i] == curve.x[i - 1] && curve.y[i] != curve.y[i - 1] && curve.x[i] >= 0.0);
    if (jumps)
      return diagnostics_.error(
          motion.place, keyword, "LCID",
          "the displacement of curve " + std::to_string(curve.id) + " jumps: its velocity would be infinite",
          "let the curve begin at 0 and be continuous");
  }
  if (motion.kind == Kind::acceleration)
    for (const model::Index node : motion.nodes) {
      const auto at = 3 * static_cast<std::size_t>(node);
      if (at + 2 >= model.initial_velocity.size()) break;
      const double* v = &model.initial_velocity[at];
      if (motion.direction.x * v[0] + motion.direction.y * v[1] + motion.direction.z * v[2] == 0.0) continue;
      return diagnostics_.error(
          motion.place, keyword, "VAD",
          "a prescribed acceleration of nodes that have an initial velocity is not computed "
          "for spacetime parts",
          "prescribe the velocity");
    }
  conditions_.push_back({keyword, motion.place});
  const int condition = static_cast<int>(conditions_.size()) - 1;
  histories_.emplace_back(curve, motion.scale, 0.0,
                          motion.kind == Kind::velocity       ? History::Kind::value
                          : motion.kind == Kind::displacement ? History::Kind::rate
                                                              : History::Kind::integral);
  add(motion.nodes, motion.direction, static_cast<int>(histories_.size()) - 1, condition);
  if (motion.only_direction) return;
  // Held across the direction: any axis that is not along it will do, made orthogonal.
  std::vector<model::Vector> axes;
  for (const model::Vector& axis : {model::Vector{1, 0, 0}, model::Vector{0, 1, 0}, model::Vector{0, 0, 1}}) {
    model::Vector across = axis - base::dot(axis, motion.direction) * motion.direction;
    for (const model::Vector& before : axes) across = across - base::dot(across, before) * before;
    const double size = std::sqrt(base::dot(across, across));
    if (size > 1e-6) axes.push_back((1.0 / size) * across);
  }
  for (const model::Vector& axis : axes) add(motion.nodes, axis, -1, condition);
}

template <int D>
void Supports<D>::add_fixed(const model::FixedNodes& fixed) {
  if (fixed.birth > 0.0 || fixed.death < end_time_)
    return diagnostics_.error(
        fixed.place, "BOUNDARY_SPC", fixed.birth > 0.0 ? "BIRTH" : "DEATH",
        "a support that begins or ends during the run is not computed for spacetime parts",
        "leave birth and death blank");
  conditions_.push_back({"BOUNDARY_SPC", fixed.place});
  const model::Vector globals[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int k = 0; k < 3; ++k)
    if (fixed.directions >> k & 1u)
      add(fixed.nodes, fixed.local ? fixed.frame.axis[k] : globals[k], -1,
          static_cast<int>(conditions_.size()) - 1);
}

template <int D>
std::vector<int> Supports<D>::key(const std::array<Vertex, D>& vertex) const {
  std::vector<int> key;
  bool alike = true;
  for (const Vertex v : vertex) alike = alike && rows_at(v) == rows_at(vertex[0]);
  if (alike) return rows_at(vertex[0]);
  for (const Vertex v : vertex) {
    if (rows_at(v).empty()) return {};  // a free vertex: nothing is held
    key.insert(key.end(), rows_at(v).begin(), rows_at(v).end());
    key.push_back(-1 - v);  // may depend on where its vertices are
  }
  return key;
}

template <int D>
HeldFace<D> Supports<D>::of_face(const std::array<Vertex, D>& vertex) {
  HeldFace<D> face;
  for (const Vertex v : vertex)
    if (rows_at(v).empty()) return face;

  // What all vertices share.
  Span shared;
  for (const int r : rows_at(vertex[0])) {
    const bool common = std::all_of(vertex.begin(), vertex.end(), [&](Vertex v) {
      return std::find(rows_at(v).begin(), rows_at(v).end(), r) != rows_at(v).end();
    });
    if (common && !shared.add(row(r))) {
      const Condition& from = conditions_[static_cast<std::size_t>(row(r).condition)];
      diagnostics_.error(from.place, from.keyword, "",
                         "two conditions prescribe different velocities along one direction on the same face",
                         "take its nodes out of one of the two");
    }
  }

  // What each holds by conditions of its own: the directions common to all are those their projectors keep.
  std::array<Span, D> own;
  Matrix<D> mean{};
  for (std::size_t a = 0; a < D; ++a) {
    for (const int r : rows_at(vertex[a])) own[a].add(row(r));
    const Matrix<D> p = own[a].projector();
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) mean[i][j] += p[i][j] / D;
  }
  Matrix<D> work = mean, vectors{};
  std::array<double, D> values{};
  symmetric_eigen(D, work[0].data(), values.data(), vectors[0].data());
  for (int k = 0; k < D; ++k)
    if (values[k] > 1.0 - dependent) {
      ++face.held;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) face.projector[i][j] += vectors[i][k] * vectors[j][k];
    }

  // Shared velocities, and beyond them each vertex's own.
  const Matrix<D> inside = shared.projector();
  for (std::size_t a = 0; a < D; ++a) {
    face.velocity[a] = shared.velocity();
    if (face.held > shared.count)
      for (const auto& [history, v] : own[a].velocity())
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j)
            face.velocity[a][history][i] += (face.projector[i][j] - inside[i][j]) * v[j];
    std::erase_if(face.velocity[a], [](const auto& term) { return norm(term.second) < dependent; });
  }
  if (face.held > shared.count) face.uniform = false;

  for (const Vertex v : vertex) {
    const auto& rows = rows_at(v);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      Vector<D> left = row(rows[r]).direction;
      for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) left[i] -= face.projector[i][j] * row(rows[r]).direction[j];
      if (norm(left) < 1e-6) used_[static_cast<std::size_t>(v)][r] = 1;
    }
  }
  return face;
}

template <int D>
void Supports<D>::report_unused(const std::vector<char>& on_boundary,
                                const std::vector<std::int64_t>& vertex_id) {
  std::map<int, std::set<std::int64_t>> inside, alone;
  for (std::size_t v = 0; v < rows_of_.size(); ++v)
    for (std::size_t r = 0; r < rows_of_[v].size(); ++r)
      if (!used_[v][r]) (on_boundary[v] ? alone : inside)[row(rows_of_[v][r]).condition].insert(vertex_id[v]);
  for (const auto& [condition, nodes] : inside) {
    const Condition& from = conditions_[static_cast<std::size_t>(condition)];
    diagnostics_.error(from.place, from.keyword, "",
                       "nodes inside the body are held or moved: " + listed(nodes),
                       "spacetime parts are held at faces of their boundary; cut the mesh there");
  }
  for (const auto& [condition, nodes] : alone) {
    const Condition& from = conditions_[static_cast<std::size_t>(condition)];
    diagnostics_.error(
        from.place, from.keyword, "",
        "nodes are held or moved along a direction in which no face has all its nodes held: " + listed(nodes),
        "a point support means nothing in spacetime parts; hold all nodes of a face, or none");
  }
}

template struct HeldFace<1>;
template struct HeldFace<2>;
template struct HeldFace<3>;
template class Supports<1>;
template class Supports<2>;
template class Supports<3>;

}  // namespace cleave::discretisation::spacetime
