#include "deck/source.hpp"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "base/assert.hpp"

namespace cleave::deck {
namespace {

constexpr std::size_t stride = 4096;
constexpr std::size_t large = 2 * Text::stretch;

}  // namespace

Text::Text(std::size_t room) : room_(room + 1), mapped_(room >= large), file_(nullptr, std::fclose) {
  if (!mapped_) {
    bytes_ = new char[room_];  // not zeroed: it is written at once
    return;
  }
  void* const memory = mmap(nullptr, room_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  bytes_ = static_cast<char*>(memory);
}

Text::~Text() {
  if (mapped_)
    munmap(bytes_, room_);
  else
    delete[] bytes_;
}

void Text::finish() {
  // A byte order mark is no part of the first line. It puts the text out of step with the file.
  if (view().starts_with("\xEF\xBB\xBF")) {
    size_ -= 3;
    std::memmove(bytes_, bytes_ + 3, size_);
    file_.reset();
  }
  has_return_ = size_ > 0 && std::memchr(bytes_, '\r', size_) != nullptr;
}

std::shared_ptr<const Text> Text::from_memory(std::string_view bytes) {
  const std::shared_ptr<Text> text(new Text(bytes.size()));
  text->size_ = bytes.size();
  if (!bytes.empty()) std::memcpy(text->bytes_, bytes.data(), bytes.size());
  text->finish();
  return text;
}

std::shared_ptr<const Text> Text::from_file(const std::filesystem::path& path, std::string& why) {
  std::error_code error;
  // Devices and pipes may never end.
  if (!std::filesystem::is_regular_file(path, error)) {
    why = std::filesystem::exists(path, error) ? "it is not a regular file" : "there is no such file";
    return nullptr;
  }
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  struct stat status;
  if (!file || fstat(fileno(file.get()), &status) != 0) {
    why = "it cannot be opened";
    return nullptr;
  }
  const std::shared_ptr<Text> text(new Text(static_cast<std::size_t>(status.st_size)));
  text->size_ = std::fread(text->bytes_, 1, text->room_ - 1, file.get());
  if (std::ferror(file.get()) != 0) {
    why = "it cannot be read";
    return nullptr;
  }
  text->changed_ = status.st_mtim;
  if (text->mapped_) text->file_ = std::move(file);
  text->finish();
  return text;
}

bool Text::file_unchanged() const {
  struct stat status;
  return fstat(fileno(file_.get()), &status) == 0 && static_cast<std::size_t>(status.st_size) == size_ &&
         status.st_mtim.tv_sec == changed_.tv_sec && status.st_mtim.tv_nsec == changed_.tv_nsec;
}

bool Text::readable() const {
  return !given_back_ || file_unchanged();
}

void Text::give_back(const char* from, const char* to) const {
  if (!file_ || !file_unchanged()) return;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t first = (static_cast<std::size_t>(from - bytes_) + page - 1) / page * page;
  const std::size_t last = static_cast<std::size_t>(to - bytes_) / page * page;
  if (first >= last) return;
  given_back_ = true;
  if (mmap(bytes_ + first, last - first, PROT_READ, MAP_PRIVATE | MAP_FIXED, fileno(file_.get()),
           static_cast<off_t>(first)) == MAP_FAILED)
    throw std::bad_alloc();
}

const char* line_end(const char* at, const char* end, bool has_return) {
  const auto find = [](const char* from, char c, std::size_t size) {
    return static_cast<const char*>(std::memchr(from, c, size));
  };
  if (!has_return) {
    const char* const feed = find(at, '\n', static_cast<std::size_t>(end - at));
    return feed != nullptr ? feed : end;
  }
  // In short steps: a file with CR alone would otherwise be searched to its end for every line.
  constexpr std::ptrdiff_t step = 256;
  for (; at != end; at += std::min(step, end - at)) {
    const auto size = static_cast<std::size_t>(std::min(step, end - at));
    const char* const feed = find(at, '\n', size);
    const char* const back = find(at, '\r', feed != nullptr ? static_cast<std::size_t>(feed - at) : size);
    if (back != nullptr) return back;
    if (feed != nullptr) return feed;
  }
  return end;
}

int Sources::Storage::add(std::filesystem::path path, std::shared_ptr<const Text> text, Place included_from) {
  files.push_back({std::move(path), text->view(), included_from});
  texts.push_back(std::move(text));
  return static_cast<int>(files.size()) - 1;
}

std::shared_ptr<const Text> Sources::Storage::load(const std::filesystem::path& path, std::string& why) {
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, error);
  const std::string key = error ? path.string() : canonical.string();
  if (const auto found = by_path.find(key); found != by_path.end()) return found->second;

  auto text = Text::from_file(path, why);
  if (text == nullptr) return nullptr;
  return by_path[key] = std::move(text);
}

const std::vector<std::size_t>& Sources::Storage::line_starts(int file) const {
  const std::lock_guard lock(mutex_);
  const auto [found, fresh] = line_starts_.try_emplace(file);
  if (fresh) {
    const Text& text = *texts[static_cast<std::size_t>(file)];
    const char *const begin = text.begin(), *const end = text.end(), *seen = begin;
    std::size_t number = 0;
    for (const char* at = begin; at != end; ++number) {
      if (number % stride == 0) found->second.push_back(static_cast<std::size_t>(at - begin));
      at = after_line(line_end(at, end, text.has_return()), end);
      if (static_cast<std::size_t>(at - seen) >= Text::stretch) text.give_back(std::exchange(seen, at), at);
    }
  }
  return found->second;
}

const Sources::File& Sources::file(int index) const {
  CLEAVE_ASSERT(storage != nullptr && index >= 0 && index < count(), "no such file of the deck");
  return storage->files[static_cast<std::size_t>(index)];
}

int Sources::count() const {
  return storage == nullptr ? 0 : static_cast<int>(storage->files.size());
}

std::string_view Sources::line(int file, int line) const {
  if (file < 0 || file >= count() || line < 1) return {};
  const Text& text = *storage->texts[static_cast<std::size_t>(file)];
  if (!text.readable()) return {};
  const auto& starts = storage->line_starts(file);
  const auto number = static_cast<std::size_t>(line) - 1;
  if (number / stride >= starts.size()) return {};
  const char *at = text.begin() + starts[number / stride], *const end = text.end();
  for (std::size_t skip = number % stride; skip > 0 && at != end; --skip) {
    at = after_line(line_end(at, end, text.has_return()), end);
  }
  return {at, static_cast<std::size_t>(line_end(at, end, text.has_return()) - at)};
}

}  // namespace cleave::deck
