#pragma once
/// Faces of solids that no second element shares.

#include <span>

#include "model/mesh.hpp"

namespace cleave::model {

/// Outer faces of the given parts taken together (empty: all parts), in order of element group, element and
/// face; counter-clockwise seen from outside, triangles repeat the third node. A triangle on a quadrilateral
/// is outer.
std::vector<Segment> outer_faces(const Mesh& mesh, std::span<const Index> parts);

/// What bounds the bodies of a mesh, whatever their dimension: outer faces of solids; where there are none,
/// outer edges of shells, which lie in a plane (the body on the left from the first node to the second, which
/// is repeated), or ends of bars (one node four times).
std::vector<Segment> boundary_segments(const Mesh& mesh, std::span<const Index> parts);

}  // namespace cleave::model
