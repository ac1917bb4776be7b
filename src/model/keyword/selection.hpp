#pragma once
/// Members of *SET_..._GENERAL and of segment sets.

#include "model/keyword/draft.hpp"

namespace cleave::model {

/// ALL, NODE, PART, PART_SET?, BOX, SET_...; a leading D takes away again. Rows act in reading order.
std::vector<Index> select_nodes(Draft& draft, const Entry& entry);
std::vector<Id> select_elements(Draft& draft, const Entry& entry, ElementKind kind);
/// ALL, BOX, PART (outer faces; in the plane outer edges, of bars ends), SEG; with D to take away.
std::vector<Segment> select_segments(Draft& draft, const Entry& entry);

/// Rows of *SET_SEGMENT: triangles have N4 = N3 or blank.
std::vector<Segment> list_segments(Draft& draft, const Entry& entry);
std::vector<Segment> add_segments(Draft& draft, const Entry& entry);

/// Four node fields to a segment, blank ones as the format repeats them; false with an error if a node is
/// missing.
bool read_segment(Draft& draft, const Entry& entry, std::size_t row, Segment& out);

}  // namespace cleave::model
