#include "solver/tents_tips.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace cleave::solver {

using namespace discretisation::spacetime;

namespace {

using Axis = std::array<double, 3>;

constexpr int sample_count = 24;
constexpr double elements_far = 6.0;     ///< the stretch, in elements at the tip
constexpr double share_of_crack = 0.25;  ///< it is at most this part of the crack behind the tip
constexpr double farthest_look = 4.0 * elements_far;
constexpr double on_face = 1e-9;  ///< how far beyond its edges a point still lies on a face, barycentric

template <int D>
Axis in_space(const Point<D>& x) {
  Axis out{};
  std::copy(x.begin(), x.end(), out.begin());
  return out;
}

Axis cross(const Axis& a, const Axis& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Axis scaled(const Axis& a, double factor) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

/// The crack faces of a body, one of each pair, and where they end.
template <int D>
class Cracks {
 public:
  using Rim = std::array<Vertex, D - 1>;  ///< a point in the plane, an edge in space

  explicit Cracks(const Body<D>& body) : body_(body) {
    std::map<Rim, int> outside;
    const auto& boundary = body.mesh.boundary();
    for (std::size_t f = 0; f < boundary.size(); ++f) {
      const bool crack = boundary[f].twin >= 0;
      if (crack && static_cast<std::size_t>(boundary[f].twin) < f) continue;
      if (crack) face_.push_back(f);
      for (const Rim& rim : rims(boundary[f])) {
        if (crack)
          ++times_[rim];
        else
          outside[rim] = 1;
      }
    }
    for (auto& [rim, times] : times_)
      if (outside.contains(rim)) times = 0;
  }

  const std::vector<std::size_t>& faces() const { return face_; }
  const BoundaryFace<D>& face(std::size_t f) const { return body_.mesh.boundary()[f]; }
  const BoundaryFace<D>& other(std::size_t f) const { return face(static_cast<std::size_t>(face(f).twin)); }
  Axis place(Vertex v) const { return in_space<D>(body_.mesh.position()[static_cast<std::size_t>(v)]); }

  /// Vertices of the faces of a crack that lie on its rim, ascending: not where it leaves the body.
  std::vector<Vertex> tips() const {
    std::vector<Vertex> found;
    for (const auto& [rim, times] : times_)
      if (times == 1) found.insert(found.end(), rim.begin(), rim.end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Unit vector along the crack, away from the tip and square to the rim; along the outer boundary where the
  /// rim ends there. Zero where the faces at the tip have no common plane.
  Axis behind(Vertex tip) const {
    Axis sum{}, side{}, normal{};
    bool ends_outside = false;
    for (const std::size_t f : face_) {
      if (!has(face(f), tip)) continue;
      const Axis n = in_space<D>(face(f).normal);
      if (dot(normal, normal) > 0.0 && std::abs(dot(normal, n)) < 1.0 - 1e-6) return {};
      normal = n;
      for (const Rim& rim : rims(face(f))) {
        if (std::find(rim.begin(), rim.end(), tip) == rim.end()) continue;
        const int times = times_.at(rim);
        if (times > 1) continue;
        Axis inward = across(face(f), rim, tip);
        inward = scaled(inward, 1.0 / norm(inward));
        if constexpr (D == 3) {
          if (times == 0) {
            ends_outside = true;
            side = difference(place(rim[0] == tip ? rim[1] : rim[0]), place(tip));
          }
        }
        if (times == 1)
          for (std::size_t k = 0; k < 3; ++k) sum[k] += inward[k];
      }
    }
    const Axis& out = ends_outside ? side : sum;
    const double length = norm(out);
    return length > 0.0 ? scaled(out, 1.0 / length) : Axis{};
  }

  /// How far faces reach from the rim at a tip, square to it.
  double size_at(Vertex tip) const {
    double size = 0.0;
    for (const std::size_t f : face_)
      for (const Rim& rim : rims(face(f)))
        if (times_.at(rim) == 1 && std::find(rim.begin(), rim.end(), tip) != rim.end())
          size = std::max(size, norm(across(face(f), rim, tip)));
    return size;
  }

  /// The face that a point of the plane of the crack lies on.
  std::optional<std::size_t> face_at(const Axis& x) const {
    for (const std::size_t f : face_)
      if (contains(face(f), x)) return f;
    return {};
  }

  static bool has(const BoundaryFace<D>& face, Vertex v) {
    return std::find(face.vertex.begin(), face.vertex.end(), v) != face.vertex.end();
  }

 private:
  /// Points that bound a face in the plane, edges in space, vertices before cracks were opened.
  std::vector<Rim> rims(const BoundaryFace<D>& face) const {
    std::vector<Rim> all;
    for (std::size_t left = 0; left < D; ++left) {
      Rim rim;
      for (std::size_t k = 0, to = 0; k < D; ++k)
        if (k != left) rim[to++] = body_.mesh.origin(face.vertex[k]);
      std::sort(rim.begin(), rim.end());
      all.push_back(rim);
    }
    return all;
  }
  /// In the face, square to the rim, from the rim to the corner across.
  Axis across(const BoundaryFace<D>& face, const Rim& rim, Vertex tip) const {
    Axis to{};
    for (const Vertex v : face.vertex)
      if (std::find(rim.begin(), rim.end(), body_.mesh.origin(v)) == rim.end())
        to = difference(place(v), place(tip));
    if constexpr (D == 3) {
      const Axis edge = difference(place(rim[1]), place(rim[0]));
      const double part = dot(to, edge) / dot(edge, edge);
      for (std::size_t k = 0; k < 3; ++k) to[k] -= part * edge[k];
    }
    return to;
  }
  bool contains(const BoundaryFace<D>& face, const Axis& x) const {
    const Axis a = place(face.vertex[0]), e = difference(place(face.vertex[1]), a), to = difference(x, a);
    if constexpr (D == 2) {
      const double s = dot(to, e) / dot(e, e);
      return s > -on_face && s < 1.0 + on_face &&
             std::abs(dot(to, in_space<D>(face.normal))) < on_face * norm(e);
    } else if constexpr (D == 3) {
      const Axis g = difference(place(face.vertex[2]), a), n = cross(e, g);
      const double area = dot(n, n), s = dot(cross(to, g), n) / area, t = dot(cross(e, to), n) / area;
      return s > -on_face && t > -on_face && s + t < 1.0 + on_face &&
             std::abs(dot(to, n)) < 1e-6 * area / norm(e);
    }
  }

  const Body<D>& body_;
  std::vector<std::size_t> face_;
  std::map<Rim, int> times_;  ///< how many faces meet there; 0 where the crack leaves the body
};

/// Weights w of samples at r, so that sum w K(r) is the constant of the least-squares fit of K + B r + C/r.
std::vector<double> weights_of_constant(const std::vector<double>& r) {
  const auto terms = [&](double x) { return std::array<double, 3>{1.0, x / r.back(), r.back() / x}; };
  Matrix<3> normal{};
  for (const double x : r) {
    const auto f = terms(x);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) normal[a][b] += f[a] * f[b];
  }
  const Matrix<3> solved = inverse<3>(normal);
  std::vector<double> weight;
  weight.reserve(r.size());
  for (const double x : r) weight.push_back(dot(solved[0], terms(x)));
  return weight;
}

/// In two dimensions what is above is on the left of the crack seen towards the tip, in three it is where the
/// largest component of the normal is positive.
template <int D>
Axis normal_of(const Axis& ahead, Axis face_normal) {
  if (D == 2) return {0.0 - ahead[1], ahead[0], 0.0};
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b) * (1.0 - 1e-9); };
  const double largest = *std::max_element(face_normal.begin(), face_normal.end(), larger);
  return scaled(face_normal, largest < 0.0 ? -1.0 : 1.0);
}

}  // namespace

template <int D>
CrackTips<D>::CrackTips(const model::Model& model, const Body<D>& body) {
  if constexpr (D > 1) {
    if (model.precracks.empty() || !model.requests.nodout.active()) return;
    const Cracks<D> cracks(body);
    for (const Vertex v : cracks.tips()) {
      // One isotropic part around the tip.
      const std::int32_t part = body.mesh.material(body.mesh.star(v)[0]);
      const Elastic<D>& elastic = body.problem.materials[static_cast<std::size_t>(part)];
      const auto around = body.mesh.star(v);
      if (!elastic.isotropic ||
          std::any_of(around.begin(), around.end(),
                      [&](discretisation::spacetime::Simplex s) { return body.mesh.material(s) != part; }))
        continue;
      const Axis behind = cracks.behind(v), tip = cracks.place(v);
      if (!(dot(behind, behind) > 0.0)) continue;

      // The size of the elements at the tip, and how far the crack goes on behind it.
      const double size = cracks.size_at(v);
      Axis face_normal{};
      for (const std::size_t f : cracks.faces())
        if (Cracks<D>::has(cracks.face(f), v)) face_normal = in_space<D>(cracks.face(f).normal);
      const auto at = [&](double r) {
        Axis x = tip;
        for (std::size_t k = 0; k < 3; ++k) x[k] += r * behind[k];
        return x;
      };
      double length = 0.0;
      while (length < farthest_look * size && cracks.face_at(at(length + 0.5 * size))) length += 0.5 * size;
      const double far = std::min(elements_far * size, share_of_crack * length);
      const double near = std::min(size, 0.25 * far);
      if (!(far > 0.0)) continue;

      CrackTip out{.node = body.node_of_vertex[static_cast<std::size_t>(v)], .near = near, .far = far};
      Axis ahead{};
      for (std::size_t i = 0; i < 3; ++i) ahead[i] = 0.0 - behind[i];  // (no negative zeros)
      const Axis normal = normal_of<D>(ahead, face_normal);
      std::copy(ahead.begin(), ahead.end(), out.ahead);
      std::copy(normal.begin(), normal.end(), out.normal);
      Tip one;
      const double mu = elastic.stiffness[D][D];
      const double plane = 4.0 * mu * (elastic.stiffness[0][0] - mu) / elastic.stiffness[0][0];  // E'
      one.modulus[0] = one.modulus[1] = plane / 8.0;
      one.modulus[2] = mu / 4.0;
      std::vector<double> r;
      r.reserve(sample_count);
      for (int k = 0; k < sample_count; ++k) r.push_back(near + (far - near) * (k + 0.5) / sample_count);
      const std::vector<double> weight = weights_of_constant(r);
      for (std::size_t k = 0; k < r.size(); ++k) {
        const Axis x = at(r[k]);
        const auto f = cracks.face_at(x);
        if (!f) break;
        Point place;
        std::copy_n(x.begin(), D, place.begin());
        const bool above =
            dot(in_space<D>(cracks.face(*f).normal), normal) < 0.0;  // outward of the body there
        const auto first = cracks.face(*f).simplex, second = cracks.other(*f).simplex;
        one.samples.push_back({place, above ? first : second, above ? second : first,
                               weight[k] * std::sqrt(2.0 * std::numbers::pi / r[k])});
      }
      if (one.samples.size() < r.size()) continue;
      tip_.push_back(std::move(one));
      tips_.push_back(out);
    }
  }
}

template <int D>
void CrackTips<D>::fill(const Instant<D>& instant) {
  for (std::size_t k = 0; k < tip_.size(); ++k) {
    CrackTip& tip = tips_[k];
    const Axis ahead{tip.ahead[0], tip.ahead[1], tip.ahead[2]};
    const Axis normal{tip.normal[0], tip.normal[1], tip.normal[2]};
    const Axis axes[] = {normal, ahead, cross(ahead, normal)};
    std::fill_n(tip.intensity, 3, 0.0);
    for (const Sample& sample : tip_[k].samples) {
      const Axis jump = in_space<D>(difference(instant.at(sample.above, sample.place).state.u,
                                               instant.at(sample.below, sample.place).state.u));
      for (std::size_t mode = 0; mode < 3; ++mode)
        tip.intensity[mode] += sample.weight * tip_[k].modulus[mode] * dot(jump, axes[mode]);
    }
  }
}

template class CrackTips<1>;
template class CrackTips<2>;
template class CrackTips<3>;

}  // namespace cleave::solver
