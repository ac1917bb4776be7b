#include "deck/deck.hpp"

#include "base/assert.hpp"
#include "deck/deck_data.hpp"
#include "deck/reader.hpp"

namespace cleave::deck {
namespace {

Deck start(const std::filesystem::path& path, std::shared_ptr<const Text> text,
           std::shared_ptr<Sources::Storage> storage, const ReadOptions& options, Diagnostics& diagnostics) {
  auto data = std::make_shared<Deck::Data>();
  data->sources.storage = std::move(storage);
  data->sources.storage->add(path, std::move(text), Place{});
  read_blocks(data, options, diagnostics);
  return Deck(std::move(data));
}

}  // namespace

Deck Deck::read(const std::filesystem::path& main_file, const ReadOptions& options,
                Diagnostics& diagnostics) {
  auto storage = std::make_shared<Sources::Storage>();
  std::string why;
  std::shared_ptr<const Text> text = storage->load(main_file, why);
  if (text == nullptr) {
    diagnostics.error({}, {}, {}, "the deck '" + main_file.string() + "' cannot be read: " + why);
    text = Text::from_memory({});
  }
  return start(main_file, std::move(text), std::move(storage), options, diagnostics);
}

Deck Deck::read_text(std::string_view text, const std::string& name, const ReadOptions& options,
                     Diagnostics& diagnostics) {
  return start(name, Text::from_memory(text), std::make_shared<Sources::Storage>(), options, diagnostics);
}

bool may_read(const Deck::Data& deck, std::size_t block, Diagnostics& diagnostics) {
  const int file = deck.bodies[block].file;
  if (file < 0 || deck.sources.storage->texts[static_cast<std::size_t>(file)]->readable()) return true;
  diagnostics.error(deck.blocks[block].place, deck.blocks[block].keyword, {},
                    "the file was changed while it was being read");
  return false;
}

const Sources& Deck::sources() const {
  return data_->sources;
}
const std::vector<Block>& Deck::blocks() const {
  return data_->blocks;
}
const std::vector<IncludeTransform>& Deck::transforms() const {
  return data_->transforms;
}
std::string_view Deck::title() const {
  return data_->title;
}

std::vector<Card> Deck::cards(const Block& block, Diagnostics& diagnostics) const {
  CLEAVE_ASSERT(block.index < data_->blocks.size(), "the block is of another deck");
  return block.known ? read_cards(data_, block.index, diagnostics) : std::vector<Card>();
}

std::size_t Deck::line_count(const Block& block) const {
  CLEAVE_ASSERT(block.index < data_->blocks.size(), "the block is of another deck");
  return static_cast<std::size_t>(data_->bodies[block.index].line_count);
}

}  // namespace cleave::deck
