#pragma once
/// How the written deck names things the model holds resolved: sets, axes, vectors.

#include "model/keyword/affine.hpp"
#include "model/model.hpp"
#include "model/write/deck_text.hpp"

namespace cleave::model {

/// A set with exactly these members, null when there is none.
const Set<Index>* set_of(const std::vector<Set<Index>>& sets, const std::vector<Index>& members);
const Set<Segment>* set_of(const std::vector<Set<Segment>>& sets, const std::vector<Segment>& members);

/// Positions of the flags that are set.
std::vector<Index> flagged(const std::vector<bool>& flags);

/// Gives a node set of its own to every list of nodes that a deck can name only by a set: nodes of rigid
/// walls (unless all nodes), of generalized body loads, and constraints with a number. Part of building a
/// model, so that writing adds nothing to it.
void name_node_lists(Model& model);

/// 1, 2, 3 for the global axes, 0 for any other direction.
int axis_of(const Vector& direction);

/// Hands out numbers for coordinate systems and vectors and writes their definitions.
class References {
 public:
  /// @param frames  the last number of a coordinate system that is taken
  explicit References(DeckText& out, Id frames = 0) : out_(out), frames_(frames) {}
  Id frame(const Frame& frame);
  /// A frame whose x axis is the direction.
  Id frame_along(const Vector& direction);
  Id vector(const Vector& direction);

 private:
  DeckText& out_;
  Id frames_, vectors_ = 0;
};

inline Id curve_id(const Model& model, Index curve) {
  return curve < 0 ? 0 : model.curves[curve].id;
}

void write_definitions(const Model& model, DeckText& out);
void write_mesh(const Model& model, DeckText& out);
void write_actions(const Model& model, DeckText& out);
void write_requests(const Model& model, DeckText& out);

/// Lines of a stated inertia: centre and mass, tensor, velocities.
void write_inertia(const RigidInertia& stated, const Model& model, DeckText& out);
/// Coordinate systems that materials name by number. @return the largest number, 0 for none
Id write_named_frames(const Model& model, DeckText& out);
void write_rigid(const Model& model, References& references, DeckText& out);

}  // namespace cleave::model
