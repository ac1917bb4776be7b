#include "app/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <string_view>

#include "app/version.hpp"

namespace cleave::app {
namespace {

/// The options users of other codes type as name=value, in our spelling. An empty replacement drops the word:
/// memory is taken as needed here.
struct OldHabit {
  std::string_view name, replacement;
};
constexpr OldHabit habits[] = {
    {"i", ""}, {"ncpu", "--threads"}, {"o", "--output"}, {"endtime", "--end-time"}};
constexpr std::string_view dropped[] = {"memory", "memory2"};

std::string lower(std::string_view text) {
  std::string r(text);
  std::transform(r.begin(), r.end(), r.begin(), [](unsigned char c) { return std::tolower(c); });
  return r;
}

/// Turns `i=a.k ncpu=2` into `run a.k --threads 2`; leaves every other word as it is.
std::vector<std::string> modern(int argc, const char* const* argv) {
  std::vector<std::string> words, positional;
  bool old_style = false;
  for (int n = 1; n < argc; ++n) {
    const std::string_view word = argv[n];
    const std::size_t equals = word.find('=');
    const std::string name = lower(word.substr(0, equals));
    const auto habit =
        std::find_if(std::begin(habits), std::end(habits), [&](auto& h) { return h.name == name; });
    if (equals == std::string_view::npos || word.starts_with('-')) {
      words.emplace_back(word);
    } else if (habit != std::end(habits)) {
      old_style = true;
      if (!habit->replacement.empty()) words.emplace_back(habit->replacement);
      words.emplace_back(word.substr(equals + 1));
    } else if (std::find(std::begin(dropped), std::end(dropped), name) != std::end(dropped)) {
      old_style = true;
    } else {
      words.emplace_back(word);
    }
  }
  constexpr std::string_view commands[] = {"run",     "restart", "check",   "view",
                                           "explain", "convert", "examples"};
  const bool named =
      !words.empty() && std::find(std::begin(commands), std::end(commands), words[0]) != std::end(commands);
  if (old_style && !named) words.insert(words.begin(), "run");
  std::reverse(words.begin(), words.end());  // the order CLI11 wants a vector in
  return words;
}

}  // namespace

int parse(int argc, const char* const* argv, Options& options) {
  CLI::App app{"Cleave: how solids deform, break and touch"};
  app.set_version_flag("--version", std::string("cleave ") + version);
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 done, 2 usage, 3 deck refused, 4 physics failed, 5 files failed, 128+n signal n.");

  const auto deck_options = [&](CLI::App* sub) {
    sub->add_option("-I,--include", options.include_paths, "folders to search for include files");
    sub->add_flag("--allow-unsupported", options.allow_unsupported,
                  "go on without the physics that is refused; it is listed again at the end");
  };
  const auto run_options = [&](CLI::App* sub) {
    sub->add_option("-j,--threads", options.threads,
                    "threads; results do not depend on it (default: one per core)")
        ->check(CLI::Range(1, 4096));
    sub->add_option("--end-time", options.end_time, "replaces ENDTIM of the deck")
        ->check(CLI::PositiveNumber);
    sub->add_option("--stop-at-cycle", options.stop_at_cycle, "write a restart after this cycle and stop")
        ->check(CLI::PositiveNumber);
    sub->add_option("--tents", options.tents, "spacetime parts: draw so many of the first tents")
        ->check(CLI::PositiveNumber);
    sub->add_flag("--verify", options.verify, "spacetime parts: hold every patch to its balances");
    sub->add_flag("-q,--quiet", options.quiet, "no progress and no summary on the terminal");
  };

  auto* run = app.add_subcommand("run", "run a deck");
  run->add_option("deck", options.input, "keyword deck")->required();
  run->add_option("-o,--output", options.output, "run directory (default: the deck's name with .run)");
  deck_options(run);
  run_options(run);
  run->callback([&] { options.command = Command::run; });

  auto* restart = app.add_subcommand("restart", "go on with a run from its restart file");
  restart->add_option("run", options.input, "run directory, or a restart file in it")->required();
  run_options(restart);
  restart->callback([&] { options.command = Command::restart; });

  auto* check = app.add_subcommand("check", "read a deck and say what it asks for; writes nothing");
  check->add_option("deck", options.input, "keyword deck")->required();
  deck_options(check);
  check->callback([&] { options.command = Command::check; });

  auto* view = app.add_subcommand("view", "write one HTML page with plots and pictures of a run");
  view->add_option("run", options.input, "run directory")->required();
  view->callback([&] { options.command = Command::view; });

  auto* explain = app.add_subcommand("explain", "show a keyword: columns, defaults, what is honoured");
  explain->add_option("keyword", options.keyword, "e.g. MAT_JOHNSON_COOK")->required();
  explain->callback([&] { options.command = Command::explain; });

  auto* convert = app.add_subcommand("convert", "read a deck and write the model as one plain deck");
  convert->add_option("deck", options.input, "keyword deck")->required();
  convert->add_option("-o,--output", options.output, "file to write (default: standard output)");
  deck_options(convert);
  convert->callback([&] { options.command = Command::convert; });

  auto* examples = app.add_subcommand("examples", "list the examples, or write one into this folder");
  examples->add_option("name", options.keyword, "example to write");
  examples->add_option("-o,--output", options.output, "folder to write to (default: a folder of that name)");
  examples->callback([&] { options.command = Command::examples; });

  try {
    app.parse(modern(argc, argv));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : bad_usage;
  }
  return -1;
}

}  // namespace cleave::app
