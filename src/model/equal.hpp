#pragma once
/// Comparing models member by member.

#include <string>

#include "model/model.hpp"

namespace cleave::model {

/// The name of the first member in which the models differ, e.g. "walls[2].normal"; empty when they are
/// equal.
///
/// Numbers are compared bit for bit, but for the directions of rigid walls: the format gives those as
/// differences of two points, so they may differ by roundoff (1e-12). Laws are compared by the cards they
/// were made from, sections by their numbers; places in the deck are not compared.
std::string first_difference(const Model& a, const Model& b);

}  // namespace cleave::model
