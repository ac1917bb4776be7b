#include <cstdio>
#include <fstream>

#include "app/commands.hpp"
#include "app/embedded_examples.hpp"

namespace cleave::app {
namespace {

/// The deck's *TITLE line, to say in a list what the example is.
std::string_view title_of(std::string_view deck) {
  const std::size_t keyword = deck.find("*TITLE");
  if (keyword == std::string_view::npos) return {};
  const std::size_t begin = deck.find('\n', keyword) + 1;
  return deck.substr(begin, deck.find('\n', begin) - begin);
}

}  // namespace

int examples(const Options& options) {
  if (options.keyword.empty()) {
    for (const Example& example : embedded_examples()) {
      const std::string_view title = title_of(example.text);
      std::printf("%-16.*s %.*s\n", static_cast<int>(example.name.size()), example.name.data(),
                  static_cast<int>(title.size()), title.data());
    }
    std::printf("\ncleave examples NAME writes NAME/NAME.k here; cleave run NAME/NAME.k runs it.\n");
    return done;
  }
  for (const Example& example : embedded_examples()) {
    if (example.name != options.keyword) continue;
    const std::filesystem::path folder =
        options.output.empty() ? std::filesystem::path(options.keyword) : options.output;
    const std::filesystem::path path = folder / (options.keyword + ".k");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream file(path, std::ios::binary);
    file << example.text;
    file.close();
    if (!file) {
      std::fprintf(stderr, "cleave: cannot write %s\n", path.c_str());
      return files_failed;
    }
    std::printf("%s\n", path.c_str());
    return done;
  }
  std::fprintf(stderr, "cleave: no example %s; cleave examples lists them\n", options.keyword.c_str());
  return bad_usage;
}

}  // namespace cleave::app
