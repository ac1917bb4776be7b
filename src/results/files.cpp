#include "results/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace cleave::results {
namespace {

std::string reason() {
  return std::strerror(errno);
}

/// write(2) until all is written; false with errno set otherwise.
bool write_all(int file, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t done = ::write(file, bytes, count);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes += done;
    count -= static_cast<std::size_t>(done);
  }
  return true;
}

}  // namespace

WholeFile::WholeFile(std::filesystem::path path) : path_(std::move(path)), unfinished_(path_) {
  unfinished_ += unfinished_suffix;
  file_ = ::open(unfinished_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file_ < 0) error_ = reason();
}

WholeFile::~WholeFile() {
  if (file_ < 0) return;
  ::close(file_);
  ::unlink(unfinished_.c_str());
}

void WholeFile::write_through(const char* bytes, std::size_t count) {
  flush();
  if (count >= buffer_size) {
    if (error_.empty() && !write_all(file_, bytes, count)) error_ = reason();
    return;
  }
  std::memcpy(buffer_.get(), bytes, count);
  used_ = count;
}

void WholeFile::flush() {
  if (error_.empty() && !write_all(file_, buffer_.get(), used_)) error_ = reason();
  used_ = 0;
}

std::string WholeFile::commit(bool durable) {
  if (file_ < 0) return error_.empty() ? "the file is closed" : error_;
  flush();
  if (error_.empty() && durable && ::fdatasync(file_) != 0) error_ = reason();
  if (::close(file_) != 0 && error_.empty()) error_ = reason();  // network disks tell here that they are full
  file_ = -1;
  if (error_.empty() && ::rename(unfinished_.c_str(), path_.c_str()) != 0) error_ = reason();
  if (!error_.empty()) ::unlink(unfinished_.c_str());
  return error_;
}

std::string write_whole(const std::filesystem::path& path, std::string_view text) {
  WholeFile file(path);
  file.write(text);
  return file.commit();
}

GrowingFile::~GrowingFile() {
  if (file_ >= 0) ::close(file_);
}

std::string GrowingFile::open(const std::filesystem::path& path, std::uint64_t keep) {
  if (file_ >= 0) ::close(file_);
  file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file_ < 0) return reason();
  struct stat status {};
  if (::fstat(file_, &status) != 0) return reason();
  size_ = static_cast<std::uint64_t>(status.st_size) >= keep ? keep : 0;
  // A device (/dev/full in tests) cannot be cut; it has no content either.
  if (S_ISREG(status.st_mode) && ::ftruncate(file_, static_cast<off_t>(size_)) != 0) return reason();
  return {};
}

std::string GrowingFile::append(std::string_view piece) {
  if (write_all(file_, piece.data(), piece.size())) {
    size_ += piece.size();
    return {};
  }
  std::string why = reason();
  if (::ftruncate(file_, static_cast<off_t>(size_)) != 0) why += " (and a broken last line is left)";
  return why;
}

}  // namespace cleave::results
