#pragma once
/// The text of every file of a deck, kept for as long as cards refer to it.

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <ctime>
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
///
/// The text of a large model is larger than the model made of it. Memory of rows that have been taken is
/// given back to the system: the file is mapped in its place, so that the text can still be read, for
/// diagnostics, as long as nobody changes the file.
class Text {
 public:
  Text(const Text&) = delete;
  Text& operator=(const Text&) = delete;
  ~Text();

  static std::shared_ptr<const Text> from_memory(std::string_view bytes);
  /// Reads a regular file. nullptr: it cannot be read; `why` says it.
  static std::shared_ptr<const Text> from_file(const std::filesystem::path& path, std::string& why);

  const char* begin() const { return bytes_; }
  const char* end() const { return bytes_ + size_; }
  std::string_view view() const { return {bytes_, size_}; }
  bool has_return() const { return has_return_; }  ///< some line ends in CR

  /// Stretches of this size are worth giving back.
  static constexpr std::size_t stretch = std::size_t{4} << 20;
  /// Gives back the memory of the whole pages in [from, to), if the text came from a large file that is as it
  /// was when it was read. Throws std::bad_alloc if the system cannot map the file.
  void give_back(const char* from, const char* to) const;
  /// May the text be read? Not if parts were given back and the file has changed since.
  bool readable() const;

 private:
  explicit Text(std::size_t room);
  void finish();
  bool file_unchanged() const;

  char* bytes_ = nullptr;
  std::size_t size_ = 0, room_ = 0;
  bool has_return_ = false, mapped_ = false;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;  ///< kept open if memory may be given back
  struct timespec changed_ = {};                          ///< of the file, before it was read
  mutable bool given_back_ = false;
};

struct Sources::Storage {
  std::deque<File> files;
  std::vector<std::shared_ptr<const Text>> texts;  ///< one per file
  std::unordered_map<std::string, std::shared_ptr<const Text>> by_path;

  /// Adds a file and gives its index.
  int add(std::filesystem::path path, std::shared_ptr<const Text> text, Place included_from);
  /// Reads a regular file, or takes it from those read before. nullptr: cannot be read; `why` says it.
  std::shared_ptr<const Text> load(const std::filesystem::path& path, std::string& why);
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
