#pragma once
/// The catalogue of formulations: what turns a part into blocks.

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "deck/diagnostic.hpp"
#include "discretisation/block.hpp"

namespace cleave::discretisation {

/// The elements of one part and one shape, in deck order.
struct PartElements {
  const model::Model& model;
  Index part = -1;
  model::Shape shape = model::Shape::hex8;
  std::vector<Id> id;
  std::vector<Index> node;  ///< [element][nodes_of(shape)]
};

/// One file, one line in catalogue.inc.
struct FormulationEntry {
  std::string_view name;                 ///< for --formulation and messages, e.g. "hex8-one-point"
  std::string_view family;               ///< of the section: "SOLID"
  std::span<const int> forms;            ///< ELFORM values it honours
  std::span<const model::Shape> shapes;  ///< element shapes it takes
  std::unique_ptr<Block> (*build)(const PartElements& elements, deck::Diagnostics& diagnostics);
  std::string_view source;  ///< paper and equations
};

std::span<const FormulationEntry* const> formulation_catalogue();
/// The entry for a section family, ELFORM and shape; null when there is none.
const FormulationEntry* find_formulation(std::string_view family, int form, model::Shape shape);

}  // namespace cleave::discretisation
