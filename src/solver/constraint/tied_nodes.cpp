/// *CONTACT_TIED_...: nodes that follow a point of a face. Forces and masses of the nodes are given to the
/// corners of the faces, by the weights of the point, so momentum is kept. Theory: docs/solver/contact.md.

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "solver/constraint/kinds.hpp"
#include "solver/contact/ties.hpp"

namespace cleave::solver {
namespace {

constexpr std::size_t grain = 512;

class TiedNodes final : public Constraint {
 public:
  TiedNodes(const model::Contact& contact, std::size_t number, std::vector<Tie> ties, std::size_t node_count)
      : contact_(contact), number_(number), ties_(std::move(ties)) {
    // For each corner the ties that load it, in the order of the ties.
    std::vector<std::int32_t> count(node_count, 0);
    for (const Tie& tie : ties_)
      for (int k = 0; k < 4; ++k)
        if (tie.weight[k] != 0.0) ++count[static_cast<std::size_t>(tie.corner[k])];
    std::vector<std::int32_t> place(node_count, -1);
    first_.push_back(0);
    for (std::size_t a = 0; a < node_count; ++a) {
      if (count[a] == 0) continue;
      place[a] = static_cast<std::int32_t>(corners_.size());
      corners_.push_back(static_cast<Index>(a));
      first_.push_back(first_.back() + count[a]);
    }
    list_.resize(static_cast<std::size_t>(first_.back()));
    std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t t = 0; t < ties_.size(); ++t)
      for (int k = 0; k < 4; ++k)
        if (ties_[t].weight[k] != 0.0) {
          const auto at = static_cast<std::size_t>(place[static_cast<std::size_t>(ties_[t].corner[k])]);
          list_[static_cast<std::size_t>(next[at]++)] = {static_cast<std::int32_t>(t), ties_[t].weight[k]};
        }
    for (const Tie& tie : ties_) nodes_.push_back(tie.node);
    nodes_.insert(nodes_.end(), corners_.begin(), corners_.end());
    given_.resize(3 * ties_.size());
    own_.resize(3 * ties_.size());
  }

  std::string name() const override { return "tied " + std::to_string(number_); }
  base::Array<double> first_memory(const discretisation::State&) const override { return {}; }

  void correct(const Moment& now, std::span<double>, std::span<double> acceleration) override {
    active_ = now.time >= contact_.birth && now.time < contact_.death;
    if (!active_) return;
    // Each node gives its force, less what its own motion relative to the face needs.
    base::for_each_range(ties_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const Tie& tie = ties_[t];
        const double mass = now.mass[static_cast<std::size_t>(tie.node)];
        for (int i = 0; i < 3; ++i) {
          own_[slot(t, i)] = catch_up(now, tie, i);
          given_[slot(t, i)] = mass * (acceleration[at(tie.node, i)] - own_[slot(t, i)]);
        }
      }
    });
    // Corners take it by their weights, with the mass that goes with it.
    base::for_each_range(corners_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c) {
        double mass = now.mass[static_cast<std::size_t>(corners_[c])], force[3];
        for (int i = 0; i < 3; ++i) force[i] = mass * acceleration[at(corners_[c], i)];
        for (std::int32_t k = first_[c]; k < first_[c + 1]; ++k) {
          const Share& share = list_[static_cast<std::size_t>(k)];
          const auto t = static_cast<std::size_t>(share.tie);
          mass += share.weight * now.mass[static_cast<std::size_t>(ties_[t].node)];
          for (int i = 0; i < 3; ++i) force[i] += share.weight * given_[slot(t, i)];
        }
        if (!(mass > 0.0)) continue;
        for (int i = 0; i < 3; ++i) acceleration[at(corners_[c], i)] = force[i] / mass;
      }
    });
    base::for_each_range(ties_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        const Tie& tie = ties_[t];
        for (int i = 0; i < 3; ++i) {
          double a = own_[slot(t, i)];
          for (int k = 0; k < 4; ++k)
            if (tie.weight[k] != 0.0) a += tie.weight[k] * acceleration[at(tie.corner[k], i)];
          acceleration[at(tie.node, i)] = a;
        }
      }
    });
  }

  std::span<const Index> corrected() const override {
    return active_ ? std::span<const Index>(nodes_) : std::span<const Index>();
  }
  /// Forces within the body: none comes from outside.
  Halves work(const Moment&, std::span<const double>, std::span<const double>) const override { return {}; }
  void report(std::span<const double>, Reactions&) const override {}

 private:
  struct Share {
    std::int32_t tie;
    double weight;
  };
  static std::size_t at(Index node, int i) {
    return 3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(i);
  }
  static std::size_t slot(std::size_t tie, int i) { return 3 * tie + static_cast<std::size_t>(i); }
  /// Acceleration beyond that of its point that takes a node to its place within the step.
  static double catch_up(const Moment& now, const Tie& tie, int i) {
    double place = tie.offset[i], velocity = 0.0;
    for (int k = 0; k < 4; ++k)
      if (tie.weight[k] != 0.0) {
        place += tie.weight[k] * now.position[at(tie.corner[k], i)];
        velocity += tie.weight[k] * now.velocity[at(tie.corner[k], i)];
      }
    return ((place - now.position[at(tie.node, i)]) / now.step + velocity - now.velocity[at(tie.node, i)]) /
           now.interval();
  }

  const model::Contact& contact_;
  std::size_t number_;
  std::vector<Tie> ties_;
  std::vector<Index> corners_, nodes_;
  std::vector<std::int32_t> first_;
  std::vector<Share> list_;
  std::vector<double> given_, own_;  // [tie][3] force, acceleration
  bool active_ = false;
};

/// A node of these ties that belongs to a rigid body; -1 for none.
Index rigid_node(const discretisation::World& world, const std::vector<Tie>& ties) {
  const auto rigid = [&](Index a) {
    return !world.body_of_node.empty() && world.body_of_node[static_cast<std::size_t>(a)] >= 0;
  };
  for (const Tie& tie : ties) {
    if (rigid(tie.node)) return tie.node;
    for (int k = 0; k < 4; ++k)
      if (tie.weight[k] != 0.0 && rigid(tie.corner[k])) return tie.corner[k];
  }
  return -1;
}

}  // namespace

void add_tied_nodes(const discretisation::World& world, ConstraintList& list,
                    deck::Diagnostics& diagnostics) {
  for (std::size_t c = 0; c < world.model->contacts.size(); ++c) {
    const model::Contact& contact = world.model->contacts[c];
    if (!contact.tied || contact.offset) continue;
    std::vector<Tie> ties = find_ties(world, contact, diagnostics);
    std::erase_if(ties, [&](const Tie& tie) { return joined(world, tie); });
    if (const Index node = rigid_node(world, ties); node >= 0) {
      diagnostics.error(contact.place, contact.keyword, "",
                        "node " + std::to_string(world.model->mesh.nodes.id[static_cast<std::size_t>(node)]) +
                            " (and perhaps more) of contact " + std::to_string(contact.id) +
                            " belongs to a rigid body, which is its only master",
                        "name the body's faces as side B, or tie by springs: _TIED_NODES_TO_SURFACE_OFFSET, "
                        "_TIED_SURFACE_TO_SURFACE_OFFSET");
      continue;
    }
    if (!ties.empty())
      list.push_back(std::make_unique<TiedNodes>(contact, c, std::move(ties), world.node_count()));
  }
}

}  // namespace cleave::solver
