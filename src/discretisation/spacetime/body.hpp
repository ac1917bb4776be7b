#pragma once
/// A spacetime model made computable: from the model's parts, supports and loads to a space mesh, the targets
/// of its boundary faces, and the options of the front. The one door between the model and the spacetime
/// wing.

#include <memory>
#include <vector>

#include "deck/diagnostic.hpp"
#include "discretisation/spacetime/patch_solver.hpp"
#include "discretisation/spacetime/pitcher.hpp"
#include "model/model.hpp"

namespace cleave::discretisation::spacetime {

/// Space dimensions of the spacetime parts of a model (sections *_SDG): 1, 2 or 3; 0 when it has none. Parts
/// of different dimensions, or spacetime parts beside others, are errors of make_body().
int dimension_of(const model::Model& model);

/// Constant while the front advances; not movable, since problem.targets and problem.initial refer into it.
template <int D>
struct Body {
  SpaceMesh<D> mesh;                 ///< cracks opened; material number = index of the part in the model
  Problem<D> problem;                ///< one entry per part; targets by boundary face
  std::vector<TargetPtr<D>> target;  ///< owns what problem.targets points to
  PitchOptions pitch;
  double end_time = 0.0;  ///< [time]
  bool verify = false;    ///< hold every patch to its identities while it runs
  /// Out of the plane or cross section: thickness in 2D, area in 1D, 1 in 3D. Densities of energy, momentum
  /// and force per unit of it times this are those of the deck's units. [length^(3-D)]
  double thickness = 1.0;

  /// Node of the model at each vertex; the vertices doubled by a crack share theirs.
  std::vector<model::Index> node_of_vertex;
  /// User's element number of each simplex; the simplices of a split quadrilateral share theirs.
  std::vector<model::Id> element_of_simplex;

  Body() = default;
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
};

/// Null when the model was refused; `diagnostics` then says what is wrong, by element, node and place.
template <int D>
std::unique_ptr<const Body<D>> make_body(const model::Model& model, deck::Diagnostics& diagnostics);

}  // namespace cleave::discretisation::spacetime
