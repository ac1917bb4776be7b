#pragma once
/// The text of every file of a deck, kept for as long as cards refer to it.

#include <atomic>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "deck/deck.hpp"

namespace cleave::deck {

/// The bytes of one file, read once however often it is included.
struct Text {
  std::unique_ptr<char[]> bytes;
  std::size_t size = 0;
  bool has_return = false;  ///< some line ends in CR
  std::string_view view() const { return {bytes.get(), size}; }
};

struct Sources::Storage {
  std::deque<File> files;
  std::vector<std::shared_ptr<const Text>> texts;  ///< one per file
  std::unordered_map<std::string, std::shared_ptr<const Text>> by_path;

  /// Adds a file and gives its index.
  int add(std::filesystem::path path, std::shared_ptr<const Text> text, Place included_from);
  /// Reads a regular file, or takes it from those read before. nullptr: cannot be read; `why` says it.
  std::shared_ptr<const Text> load(const std::filesystem::path& path, std::string& why);
  static std::shared_ptr<const Text> from_memory(std::string_view text);

  /// Where every 4096th line of a file begins; built when a line is first asked for.
  const std::vector<std::size_t>& line_starts(int file) const;

 private:
  mutable std::mutex mutex_;
  mutable std::unordered_map<int, std::vector<std::size_t>> line_starts_;
};

/// End of the line that begins at `at`: its CR, LF or the end of the text.
const char* line_end(const char* at, const char* end, bool has_return);
/// Begin of the line behind a line that ends at `at`.
inline const char* after_line(const char* at, const char* end) {
  if (at == end) return end;
  if (*at == '\r' && at + 1 != end && at[1] == '\n') return at + 2;
  return at + 1;
}

}  // namespace cleave::deck
