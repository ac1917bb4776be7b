#pragma once
/// The loads there are; each in the file of its name.

#include <memory>
#include <vector>

#include "solver/action.hpp"

namespace cleave::solver {

using LoadList = std::vector<std::unique_ptr<Load>>;

void add_node_loads(const model::Model& model, LoadList& list);
void add_segment_loads(const model::Model& model, LoadList& list);
void add_body_loads(const model::Model& model, LoadList& list);

}  // namespace cleave::solver
