#pragma once
/// The decks of examples/, carried inside the program so that it can hand them out anywhere.

#include <span>
#include <string_view>

namespace cleave::app {

struct Example {
  std::string_view name;  ///< folder below examples/
  std::string_view text;  ///< of NAME.k
};

std::span<const Example> embedded_examples();

}  // namespace cleave::app
