/// Viscous forces on nodes: *DAMPING_GLOBAL, *DAMPING_PART_MASS, *BOUNDARY_NON_REFLECTING.
///
/// Per node m a = f - C v_n with v_n = v_n-1/2 + a dt / 2, solved for a: second order, and no step limit of
/// its own. Damping has C = D m (diagonal, per axis); an absorbing face has C = integral of
/// rho c_d n n + rho c_s (1 - n n). Source: Lysmer & Kuhlemeyer 1969; explicit.md, section 4.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/threads.hpp"
#include "model/material/law.hpp"
#include "solver/constraint/kinds.hpp"
#include "solver/face.hpp"
#include "solver/ordered_sum.hpp"

namespace cleave::solver {
namespace {

using model::Segment;
using model::Vector;

constexpr std::size_t grain = 512;

/// Index of the part whose element carries each face, -1 where none does.
std::vector<Index> parts_under(const model::Mesh& mesh, const std::vector<Segment>& faces) {
  std::vector<std::vector<std::size_t>> faces_of(mesh.nodes.count());
  std::vector<int> corners(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    corners[f] = is_triangle(faces[f]) ? 3 : 4;
    for (int a = 0; a < corners[f]; ++a) faces_of[static_cast<std::size_t>(faces[f].node[a])].push_back(f);
  }
  std::vector<Index> part(faces.size(), -1);
  std::vector<std::size_t> touched;
  std::vector<Index> own;
  for (const model::Elements& solids : mesh.solids) {
    const auto width = static_cast<std::size_t>(model::nodes_of(solids.shape));
    for (std::size_t e = 0; e < solids.count(); ++e) {
      own.assign(&solids.node[width * e], &solids.node[width * e] + width);
      std::sort(own.begin(), own.end());
      own.erase(std::unique(own.begin(), own.end()), own.end());
      touched.clear();
      for (const Index node : own) {
        const auto& some = faces_of[static_cast<std::size_t>(node)];
        touched.insert(touched.end(), some.begin(), some.end());
      }
      std::sort(touched.begin(), touched.end());
      for (std::size_t k = 0; k < touched.size();) {
        const std::size_t f = touched[k];
        int shared = 0;
        for (; k < touched.size() && touched[k] == f; ++k) ++shared;
        if (shared == corners[f] && part[f] < 0) part[f] = solids.part[e];
      }
    }
  }
  return part;
}

/// Part damping of one node.
struct PartShare {
  std::size_t slot;  ///< position in the list of nodes
  Index part;
};

class Dashpots final : public Constraint {
 public:
  Dashpots(const discretisation::World& world, deck::Diagnostics& diagnostics)
      : world_(world), model_(*world.model) {
    collect_nodes();
    absorbing_.resize(nodes_.size(), base::Sym3<double>{0, 0, 0, 0, 0, 0});
    for (const model::AbsorbingFaces& faces : model_.absorbing) add_faces(faces, diagnostics);
    damping_.resize(3 * nodes_.size());
    force_.resize(6 * nodes_.size());
  }

  bool empty() const { return nodes_.empty(); }
  std::string name() const override { return "dashpots"; }

  /// The share of each damped part in the mass of each of its nodes, at the start [-].
  base::Array<double> first_memory(const discretisation::State& state) const override {
    base::Array<double> memory(shares_.size());
    const std::size_t count = world_.node_count();
    std::vector<double> all(count), own(count);
    for (std::size_t b = 0; b < world_.blocks.size(); ++b) world_.blocks[b]->add_mass(state.blocks[b], all);
    Index part = -1;
    for (std::size_t s = 0; s < shares_.size(); ++s) {
      if (shares_[s].part != part) {
        part = shares_[s].part;
        std::fill(own.begin(), own.end(), 0.0);
        for (std::size_t b = 0; b < world_.blocks.size(); ++b)
          if (world_.blocks[b]->part() == part) world_.blocks[b]->add_mass(state.blocks[b], own);
      }
      const auto node = static_cast<std::size_t>(nodes_[shares_[s].slot]);
      memory[s] = all[node] > 0.0 ? own[node] / all[node] : 0.0;
    }
    return memory;
  }

  void correct(const Moment& now, std::span<double> memory, std::span<double> acceleration) override {
    set_damping(now, memory);
    const double back = 0.5 * now.step_before;
    base::for_each_range(nodes_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        const auto node = static_cast<std::size_t>(nodes_[s]);
        const double mass = now.mass[node];
        if (mass <= 0.0) continue;
        double* a = &acceleration[3 * node];
        const double* v = &now.velocity[3 * node];
        const base::Sym3<double>& c = absorbing_[s];
        const double* d = &damping_[3 * s];
        base::Mat3<double> viscous{{{mass * d[0] + c.xx, c.xy, c.zx},
                                    {c.xy, mass * d[1] + c.yy, c.yz},
                                    {c.zx, c.yz, mass * d[2] + c.zz}}};
        base::Mat3<double> system;
        double right[3];
        for (int i = 0; i < 3; ++i) {
          right[i] = mass * a[i];
          for (int j = 0; j < 3; ++j) {
            system.m[i][j] = back * viscous.m[i][j] + (i == j ? mass : 0.0);
            right[i] -= viscous.m[i][j] * v[j];
          }
        }
        const base::Mat3<double> inverse = base::inverse(system, base::determinant(system));
        for (int i = 0; i < 3; ++i)
          a[i] = inverse.m[i][0] * right[0] + inverse.m[i][1] * right[1] + inverse.m[i][2] * right[2];

        // The forces, kept for the energies.
        const double w[3] = {v[0] + back * a[0], v[1] + back * a[1], v[2] + back * a[2]};
        double* f = &force_[6 * s];
        for (int i = 0; i < 3; ++i) f[i] = -mass * d[i] * w[i];
        f[3] = -(c.xx * w[0] + c.xy * w[1] + c.zx * w[2]);
        f[4] = -(c.xy * w[0] + c.yy * w[1] + c.yz * w[2]);
        f[5] = -(c.zx * w[0] + c.yz * w[1] + c.zz * w[2]);
      }
    });
  }

  std::span<const Index> corrected() const override { return nodes_; }

  /// Damping loses energy in the body; what an absorbing face takes has left the model: external work.
  Halves work(const Moment& now, std::span<const double>,
              std::span<const double> acceleration) const override {
    return ordered_sum<Halves>(nodes_.size(), grain, [&](std::size_t begin, std::size_t end) {
      Halves sum;
      for (std::size_t s = begin; s < end; ++s) {
        const ImpulseWork damped = impulse_work(now, nodes_[s], &force_[6 * s], acceleration);
        const ImpulseWork radiated = impulse_work(now, nodes_[s], &force_[6 * s + 3], acceleration);
        sum.before.damping -= damped.before;
        sum.after.damping -= damped.after;
        sum.before.external += radiated.before;
        sum.after.external += radiated.after;
      }
      return sum;
    });
  }

  /// Viscous forces hold nothing: they appear in the energies alone.
  void report(std::span<const double>, Reactions&) const override {}

 private:
  /// Rigid bodies are damped as bodies.
  void drop_rigid(std::vector<Index>& nodes) const {
    if (world_.body_of_node.empty()) return;
    std::erase_if(nodes, [&](Index a) { return world_.body_of_node[static_cast<std::size_t>(a)] >= 0; });
  }

  void collect_nodes() {
    std::vector<std::vector<Index>> of_part(model_.parts.size());
    for (std::size_t p = 0; p < model_.parts.size(); ++p) {
      if (model_.parts[p].mass_damping == 0.0) continue;
      for (const auto& block : world_.blocks)
        if (block->part() == static_cast<Index>(p))
          of_part[p].insert(of_part[p].end(), block->connectivity().begin(), block->connectivity().end());
      std::sort(of_part[p].begin(), of_part[p].end());
      of_part[p].erase(std::unique(of_part[p].begin(), of_part[p].end()), of_part[p].end());
      drop_rigid(of_part[p]);
      nodes_.insert(nodes_.end(), of_part[p].begin(), of_part[p].end());
    }
    for (const model::AbsorbingFaces& faces : model_.absorbing)
      for (const Segment& face : faces.segments) nodes_.insert(nodes_.end(), face.node, face.node + 4);
    if (!model_.global_damping.empty()) {
      nodes_.resize(model_.mesh.nodes.count());
      std::iota(nodes_.begin(), nodes_.end(), 0);
    }
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    drop_rigid(nodes_);
    for (std::size_t p = 0; p < of_part.size(); ++p)
      for (const Index node : of_part[p]) shares_.push_back({slot_of(node), static_cast<Index>(p)});
  }

  std::size_t slot_of(Index node) const {
    return static_cast<std::size_t>(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
  }

  void add_faces(const model::AbsorbingFaces& faces, deck::Diagnostics& diagnostics) {
    const std::vector<Index> parts = parts_under(model_.mesh, faces.segments);
    const auto orphans = std::count(parts.begin(), parts.end(), -1);
    if (orphans > 0)
      diagnostics.error({}, "BOUNDARY_NON_REFLECTING", "",
                        std::to_string(orphans) + " segments are not faces of a solid element",
                        "an absorbing face needs the density and stiffness of the element behind it");
    for (std::size_t f = 0; f < parts.size(); ++f) {
      if (parts[f] < 0) continue;
      const model::Part& part = model_.parts[static_cast<std::size_t>(parts[f])];
      const double normal =
          faces.dilatational ? std::sqrt(part.density * part.law->longitudinal_modulus()) : 0.0;
      const double tangential = faces.shear ? std::sqrt(part.density * part.law->shear_modulus()) : 0.0;
      const auto vectors = face_vectors(faces.segments[f], model_.mesh.nodes.position);
      for (std::size_t a = 0; a < 4; ++a) {
        const double area = std::sqrt(base::dot(vectors[a], vectors[a]));
        if (area == 0.0) continue;
        const Vector n = (1.0 / area) * vectors[a];
        const base::Sym3<double> across{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
        base::Sym3<double>& c = absorbing_[slot_of(faces.segments[f].node[a])];
        c = c + (area * (normal - tangential)) * across + base::spherical(area * tangential);
      }
    }
  }

  double factor_now(Index curve, const Moment& now) const {
    return curve < 0 ? 1.0 : load_value(model_.curves[static_cast<std::size_t>(curve)], now.time, now.step);
  }

  /// D of each node and axis at t_n [1/time].
  void set_damping(const Moment& now, std::span<const double> share) {
    double common[3] = {0, 0, 0};
    for (const model::GlobalDamping& damping : model_.global_damping) {
      const double d = damping.curve < 0 ? damping.value : factor_now(damping.curve, now);
      for (int i = 0; i < 3; ++i) common[i] += d * damping.factor[i];
    }
    for (std::size_t k = 0; k < damping_.size(); ++k) damping_[k] = common[k % 3];
    for (std::size_t s = 0; s < shares_.size(); ++s) {
      const model::Part& part = model_.parts[static_cast<std::size_t>(shares_[s].part)];
      const double d = share[s] * part.mass_damping * factor_now(part.mass_damping_curve, now);
      for (std::size_t i = 0; i < 3; ++i)
        damping_[3 * shares_[s].slot + i] += d * part.mass_damping_factor[i];
    }
  }

  const discretisation::World& world_;
  const model::Model& model_;
  std::vector<Index> nodes_;                   // ascending
  std::vector<PartShare> shares_;              // by part, then node
  std::vector<base::Sym3<double>> absorbing_;  // [slot] integral of the impedance [force time/length]
  std::vector<double> damping_;                // [slot][3] D of the step [1/time]
  std::vector<double> force_;                  // [slot][6] damping, absorbing; of the step [force]
};

}  // namespace

void add_dashpots(const discretisation::World& world, ConstraintList& list, deck::Diagnostics& diagnostics) {
  auto dashpots = std::make_unique<Dashpots>(world, diagnostics);
  if (!dashpots->empty()) list.push_back(std::move(dashpots));
}

}  // namespace cleave::solver
