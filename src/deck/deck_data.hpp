#pragma once
/// What a deck holds: texts, blocks with the lines they own, parameters and transforms.

#include <string>
#include <vector>

#include "deck/lexer.hpp"
#include "deck/parameter.hpp"
#include "deck/source.hpp"

namespace cleave::deck {

struct Deck::Data {
  Sources sources;
  std::vector<Block> blocks;
  std::vector<Body> bodies;                                              ///< one per block
  std::vector<std::shared_ptr<const std::vector<std::string>>> options;  ///< one per block
  std::vector<IncludeTransform> transforms;
  Parameters parameters;
  std::string title;
};

/// Is the text of a block still that of its file? If not, an error says so.
bool may_read(const Deck::Data& deck, std::size_t block, Diagnostics& diagnostics);

/// The data sets of one block by its layout.
std::vector<Card> read_cards(const std::shared_ptr<const Deck::Data>& deck, std::size_t block,
                             Diagnostics& diagnostics);

}  // namespace cleave::deck
