#include "deck/source.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "base/assert.hpp"

namespace cleave::deck {
namespace {

constexpr std::size_t stride = 4096;

std::shared_ptr<Text> with_room_for(std::size_t size) {
  auto text = std::make_shared<Text>();
  text->bytes.reset(new char[size + 1]);  // not zeroed: it is written at once
  text->size = size;
  return text;
}

void finish(Text& text) {
  // A byte order mark is no part of the first line.
  if (text.size >= 3 && std::memcmp(text.bytes.get(), "\xEF\xBB\xBF", 3) == 0) {
    text.size -= 3;
    std::memmove(text.bytes.get(), text.bytes.get() + 3, text.size);
  }
  text.has_return = text.size > 0 && std::memchr(text.bytes.get(), '\r', text.size) != nullptr;
}

}  // namespace

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

std::shared_ptr<const Text> Sources::Storage::from_memory(std::string_view bytes) {
  auto text = with_room_for(bytes.size());
  if (!bytes.empty()) std::memcpy(text->bytes.get(), bytes.data(), bytes.size());
  finish(*text);
  return text;
}

std::shared_ptr<const Text> Sources::Storage::load(const std::filesystem::path& path, std::string& why) {
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, error);
  const std::string key = error ? path.string() : canonical.string();
  if (const auto found = by_path.find(key); found != by_path.end()) return found->second;

  // Devices and pipes may never end.
  if (!std::filesystem::is_regular_file(path, error)) {
    why = std::filesystem::exists(path, error) ? "it is not a regular file" : "there is no such file";
    return nullptr;
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  const auto size = std::filesystem::file_size(path, error);
  if (!file || error) {
    why = "it cannot be opened";
    return nullptr;
  }
  auto text = with_room_for(static_cast<std::size_t>(size));
  text->size = std::fread(text->bytes.get(), 1, text->size, file.get());
  if (std::ferror(file.get()) != 0) {
    why = "it cannot be read";
    return nullptr;
  }
  finish(*text);
  return by_path[key] = std::move(text);
}

const std::vector<std::size_t>& Sources::Storage::line_starts(int file) const {
  const std::lock_guard lock(mutex_);
  const auto [found, fresh] = line_starts_.try_emplace(file);
  if (fresh) {
    const Text& text = *texts[static_cast<std::size_t>(file)];
    const char *const begin = text.bytes.get(), *const end = begin + text.size;
    std::size_t number = 0;
    for (const char* at = begin; at != end; ++number) {
      if (number % stride == 0) found->second.push_back(static_cast<std::size_t>(at - begin));
      at = after_line(line_end(at, end, text.has_return), end);
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
  const auto& starts = storage->line_starts(file);
  const auto number = static_cast<std::size_t>(line) - 1;
  if (number / stride >= starts.size()) return {};
  const Text& text = *storage->texts[static_cast<std::size_t>(file)];
  const char *at = text.bytes.get() + starts[number / stride], *const end = text.bytes.get() + text.size;
  for (std::size_t skip = number % stride; skip > 0 && at != end; --skip) {
    at = after_line(line_end(at, end, text.has_return), end);
  }
  return {at, static_cast<std::size_t>(line_end(at, end, text.has_return) - at)};
}

}  // namespace cleave::deck
