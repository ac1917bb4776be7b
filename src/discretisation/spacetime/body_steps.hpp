#pragma once
/// The steps of make_body(), one file each. All report what is wrong and go on as far as they can.

#include <cstdio>
#include <string>
#include <vector>

#include "discretisation/spacetime/body.hpp"

namespace cleave::discretisation::spacetime {

/// "12, 15, 19 and 4 more".
template <class Ids>
std::string listed(const Ids& ids) {
  std::string text;
  std::size_t count = 0;
  for (const auto id : ids)
    if (++count <= 5) text += (count > 1 ? ", " : "") + std::to_string(id);
  return count > 5 ? text + " and " + std::to_string(count - 5) + " more" : text;
}

inline std::string shortest(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// Conditions of the model that mean nothing in a body without nodal masses, or are not computed in it.
void refuse_unsupported(const model::Model& model, deck::Diagnostics& diagnostics);

/// Materials and local spaces of the parts, thickness of the body.
template <int D>
void gather_parts(const model::Model& model, Body<D>& body, deck::Diagnostics& diagnostics);

/// The orthotropic material of a part, turned into the axes of the body. Says what is wrong, else empty.
template <int D>
std::string make_orthotropic(const model::Model& model, model::Index part, PlaneKind plane, Elastic<D>& out);

/// Vertices and simplices of the parts' elements. Needs the materials.
/// @param vertex_of_node [nodes of the model], -1 where a node is no vertex; overwritten
template <int D>
void gather_elements(const model::Model& model, SpaceMeshInput<D>& input, Body<D>& body,
                     std::vector<Vertex>& vertex_of_node, deck::Diagnostics& diagnostics);

/// Faces to be opened by the cracks of the model.
template <int D>
void gather_cracks(const model::Model& model, SpaceMeshInput<D>& input, deck::Diagnostics& diagnostics);

/// What the model asks of the faces of the boundary: supports, motions, loads, silent faces.
template <int D>
class BoundaryConditions {
 public:
  /// Reads the conditions and tags the outer faces of the input by them.
  BoundaryConditions(const model::Model& model, SpaceMeshInput<D>& input,
                     const std::vector<Vertex>& vertex_of_node, deck::Diagnostics& diagnostics);
  ~BoundaryConditions();

  /// Targets of all boundary faces of body.mesh.
  void make_targets(Body<D>& body);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Velocity and strain on the initial front, and the body force.
template <int D>
void set_initial_state(const model::Model& model, Body<D>& body, deck::Diagnostics& diagnostics);
template <int D>
void set_body_force(const model::Model& model, Body<D>& body, deck::Diagnostics& diagnostics);

}  // namespace cleave::discretisation::spacetime
