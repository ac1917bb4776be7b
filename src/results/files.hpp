#pragma once
/// Files that stay whole: those replaced in one go by a rename, and those that only grow by whole lines.
/// A kill or a full disk leaves the last whole content of each.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace cleave::results {

/// Suffix of files being written; one left behind by a kill is never read and is removed by the next run.
inline constexpr std::string_view unfinished_suffix = ".part";

/// Written as NAME.part, then renamed over NAME. Errors are kept and answered by commit().
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path path);
  ~WholeFile();  ///< removes the unfinished file unless committed
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(const void* bytes, std::size_t count) {
    if (count > buffer_size - used_) return write_through(static_cast<const char*>(bytes), count);
    std::memcpy(buffer_.get() + used_, bytes, count);  // the usual case: one number of a long array
    used_ += count;
  }
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Flushes and renames. `durable` also waits until the bytes are on the disk (survives a power cut).
  /// @return the reason for failure, empty on success
  [[nodiscard]] std::string commit(bool durable = false);

 private:
  static constexpr std::size_t buffer_size = std::size_t{1} << 20;
  void write_through(const char* bytes, std::size_t count);
  void flush();

  std::filesystem::path path_, unfinished_;
  int file_ = -1;
  std::string error_;
  std::unique_ptr<char[]> buffer_ = std::make_unique<char[]>(buffer_size);
  std::size_t used_ = 0;
};

/// Writes a whole small file. @return the reason for failure, empty on success
[[nodiscard]] std::string write_whole(const std::filesystem::path& path, std::string_view text);

/// A file that grows by whole pieces: a piece that does not fit on the disk is taken back.
class GrowingFile {
 public:
  GrowingFile() = default;
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// Opens for appending after the first `keep` bytes; the rest is cut off. A file shorter than `keep` (it
  /// belongs to another run directory) is started anew, size() is then 0.
  [[nodiscard]] std::string open(const std::filesystem::path& path, std::uint64_t keep);
  /// Appends all of `piece` in one system call, or none of it.
  [[nodiscard]] std::string append(std::string_view piece);
  std::uint64_t size() const { return size_; }
  bool is_open() const { return file_ >= 0; }

 private:
  int file_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace cleave::results
