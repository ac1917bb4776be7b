#include "deck/reader.hpp"

#include <algorithm>
#include <cctype>
#include <new>

#include "deck/include.hpp"
#include "deck/keyword_name.hpp"
#include "deck/layout.hpp"
#include "deck/parameter_lines.hpp"

namespace cleave::deck {
namespace {

namespace fs = std::filesystem;

constexpr int deepest_include = 64;
constexpr int most_files = 10000;
constexpr std::size_t most_blocks = 2000000;
constexpr int most_guesses = 50;  ///< unknown names that get a suggestion; looking for one takes time

constexpr std::string_view encrypted_begin = "-----BEGIN PGP", encrypted_end = "-----END PGP";

/// Keywords that cannot change the motion, known or not: results, layout on ranks, analyses after the run.
bool is_aside(std::string_view keyword) {
  for (const std::string_view family : {"DATABASE_", "CONTROL_MPP_", "FREQUENCY_DOMAIN_"})
    if (keyword.starts_with(family)) return true;
  return false;
}

/// What one file hands down to the files it includes.
struct FileState {
  int file = 0;
  int depth = 0;
  int transform = 0;
  Format format = Format::standard;
  SearchPath search;
};

class Reader {
 public:
  Reader(std::shared_ptr<Deck::Data> data, const ReadOptions& options, Diagnostics& diagnostics)
      : data_(std::move(data)), options_(options), diagnostics_(diagnostics) {}

  void read_main() {
    FileState state;
    state.search.main_folder = folder_of(0);
    state.search.paths = options_.include_paths;
    read_file(std::move(state));
  }

 private:
  fs::path folder_of(int file) const { return data_->sources.file(file).path.parent_path(); }
  const Text& text_of(int file) const {
    return *data_->sources.storage->texts[static_cast<std::size_t>(file)];
  }

  void read_file(FileState state) {
    const Text& text = text_of(state.file);
    const char *at = text.begin(), *const end = text.end();
    bool open = false, ended = false;
    int number = 1, stray = 0, first_stray = 0;
    while (at != end && !ended) {
      const char* const stop = line_end(at, end, text.has_return());
      const char* const next = after_line(stop, end);
      const std::string_view line(at, static_cast<std::size_t>(stop - at));
      if (*at == '*' || (*at == '-' && line.starts_with(encrypted_begin))) {
        if (open) close_block(state, at, number);
        open = false;
        if (*at == '-') {
          at = skip_encrypted(state.file, at, end, text.has_return(), number);
          first_stray = -1;  // what follows belonged to no keyword we can see
          continue;
        }
        open = open_block(state, line, next, number);
        ended = open && data_->blocks.back().keyword == "END";
        if (data_->blocks.size() >= most_blocks) {
          diagnostics_.error({state.file, number, 1, 1}, {}, {},
                             "the deck has more than 2000000 keywords; reading stops here");
          stopped_ = true;
        }
        if (stopped_) return;
      } else if (!open && first_stray != -1 && *at != '$' && !is_blank(line)) {
        if (stray++ == 0) first_stray = number;
      }
      at = next;
      ++number;
    }
    if (open) close_block(state, at, number);
    if (stray > 0 && first_stray > 0) {
      diagnostics_.warning({state.file, first_stray, 1, 1}, {}, {},
                           std::to_string(stray) + (stray == 1 ? " line stands" : " lines stand") +
                               " in front of the first keyword and " + (stray == 1 ? "is" : "are") +
                               " not read",
                           "a keyword begins with * in column 1, a remark with $");
    }
  }

  /// Steps over an encrypted block, whatever bytes it holds; gives where reading goes on.
  const char* skip_encrypted(int file, const char* at, const char* end, bool has_return, int& number) {
    diagnostics_.error({file, number, 1, static_cast<int>(encrypted_begin.size())}, {}, {},
                       "this part of the deck is encrypted and cannot be read",
                       "ask its supplier for a readable file; the encryption is made for one program only");
    while (at != end) {
      const char* const stop = line_end(at, end, has_return);
      const bool last = std::string_view(at, static_cast<std::size_t>(stop - at)).starts_with(encrypted_end);
      at = after_line(stop, end);
      ++number;
      if (last) break;
    }
    return at;
  }

  /// Starts a block from its keyword line.
  bool open_block(FileState& state, std::string_view line, const char* body, int number) {
    const std::size_t blank = std::min(line.find_first_of(" \t"), line.size());
    std::string_view written = line.substr(0, blank), remark = trim(line.substr(blank));
    Format format = state.format;
    const auto format_of = [&](char c) {
      return c == '+' ? Format::wide : c == '%' ? Format::ten : Format::standard;
    };
    const auto is_suffix = [](char c) { return c == '+' || c == '-' || c == '%'; };
    if (written.size() > 1 && is_suffix(written.back())) {
      format = format_of(written.back());
      written.remove_suffix(1);
    } else if (!remark.empty() && is_suffix(remark[0]) && (remark.size() == 1 || remark[1] == ' ')) {
      format = format_of(remark[0]);
    }

    const Name& name = resolve(written);
    Block block;
    block.keyword = name.keyword;
    block.options = *name.options;
    block.written = std::string(written.substr(0, 200));
    block.place = {state.file, number, 1, static_cast<int>(std::min<std::size_t>(written.size(), 1000))};
    block.transform = state.transform;
    block.known = name.known;
    block.index = data_->blocks.size();
    if (!name.known) {
      const std::string hint = name.nearest.empty() ? std::string() : "did you mean *" + name.nearest + "?";
      if (options_.refuse_unknown && !is_aside(block.keyword))
        diagnostics_.error(block.place, {}, {}, "unknown keyword '" + block.written + "'",
                           hint.empty() ? "correct or remove it, or run without what is unsupported" : hint);
      else
        diagnostics_.warning(block.place, {}, {},
                             "unknown keyword '" + block.written + "': it is skipped with all its lines",
                             hint);
    }
    if (block.keyword == "KEYWORD") {
      state.format = format_of_keyword_line(remark);
      format = state.format;
    }
    Body lines;
    lines.begin = lines.end = body;
    lines.file = state.file;
    lines.first_line = number + 1;
    lines.format = format;
    lines.has_return = text_of(state.file).has_return();
    lines.epoch = data_->parameters.epoch();
    data_->blocks.push_back(std::move(block));
    data_->bodies.push_back(lines);
    data_->options.push_back(name.options);
    return true;
  }

  static Format format_of_keyword_line(std::string_view remark) {
    std::string upper = normal_name(remark.substr(0, 1000));
    upper.erase(std::remove(upper.begin(), upper.end(), ' '), upper.end());
    const auto value = [&](std::string_view key) {
      const std::size_t at = upper.find(key);
      return at == std::string::npos || at + key.size() >= upper.size() ? ' ' : upper[at + key.size()];
    };
    if (value("LONG=") == 'Y' || value("LONG=") == 'K') return Format::wide;
    return value("I10=") == 'Y' ? Format::ten : Format::standard;
  }

  /// Ends a block; keywords that steer the reading act here.
  void close_block(FileState& state, const char* end, int line) {
    const std::size_t index = data_->blocks.size() - 1;
    Body& body = data_->bodies[index];
    body.end = end;
    body.line_count = line - body.first_line;
    Block& block = data_->blocks[index];
    const std::string& keyword = block.keyword;
    if (!block.known) return;
    block.consumed = steers_reading(keyword);
    if (keyword == "TITLE")
      take_title(index);
    else if (keyword == "INCLUDE")
      include_each(state, index);
    else if (keyword == "INCLUDE_TRANSFORM")
      include_transformed(state, index);
    else if (keyword == "INCLUDE_PATH")
      add_paths(state, index, fs::path());
    else if (keyword == "INCLUDE_PATH_RELATIVE")
      add_paths(state, index, state.search.main_folder);
    else if (keyword.starts_with("INCLUDE_"))
      refuse(index);
    else if (keyword.starts_with("PARAMETER"))
      define_parameters(index);
  }

  void take_title(std::size_t index) {
    Line line;
    LineCursor lines(data_->bodies[index]);
    if (data_->title.empty() && lines.next(line)) data_->title = std::string(trim(line.text.substr(0, 1000)));
    read_cards(data_, index, diagnostics_);  // reports surplus lines
  }

  void define_parameters(std::size_t index) {
    const Block& block = data_->blocks[index];
    const Body& body = data_->bodies[index];
    if (block.keyword == "PARAMETER_DUPLICATION") {
      using Rule = Parameters::Duplicate;
      constexpr Rule rules[] = {Rule::first_with_warning, Rule::later_with_warning, Rule::error, Rule::later,
                                Rule::first};
      const Card card = read_cards(data_, index, diagnostics_).front();
      const std::int64_t flag = card.integer("DFLAG");
      if (flag >= 1 && flag <= 5)
        data_->parameters.duplicate = rules[flag - 1];
      else
        diagnostics_.error(card.place("DFLAG"), block.keyword, "DFLAG",
                           "found " + std::to_string(flag) + ", expected 1 to 5");
      return;
    }
    const ValueContext context{&data_->parameters, &data_->sources, &diagnostics_,
                               block.keyword,      body.file,       0};
    read_parameters(body, block.keyword.find("EXPRESSION") != std::string::npos,
                    block.keyword.ends_with("_LOCAL"), context, data_->parameters);
  }

  struct IncludeName {
    std::string name;
    Place place;
  };

  /// One name a line; a line that ends in " +" goes on in the next one.
  std::vector<IncludeName> names_of(std::size_t index) const {
    constexpr std::size_t longest = 4096;
    std::vector<IncludeName> names;
    std::string joined;
    Place place;
    Line line;
    const Body& body = data_->bodies[index];
    for (LineCursor lines(body); lines.next(line);) {
      std::string_view part = trim(line.text.substr(0, longest));
      if (part.empty() && joined.empty()) continue;
      if (joined.empty())
        place = {body.file, line.number, static_cast<int>(part.data() - line.text.data()) + 1,
                 static_cast<int>(part.size())};
      const bool more = part.size() >= 2 && part.ends_with(" +") && joined.size() < longest;
      joined += more ? trim(part.substr(0, part.size() - 2)) : part;
      if (more) continue;
      if (!joined.empty()) names.push_back({joined, place});
      joined.clear();
      if (names.size() >= most_files) break;
    }
    if (!joined.empty()) names.push_back({joined, place});
    return names;
  }

  void add_paths(FileState& state, std::size_t index, const fs::path& base) {
    for (const IncludeName& name : names_of(index)) {
      std::string folder = name.name;
      std::replace(folder.begin(), folder.end(), '\\', '/');
      state.search.paths.push_back(base.empty() ? fs::path(folder) : base / folder);
    }
  }

  void include_each(FileState& state, std::size_t index) {
    const std::vector<IncludeName> names = names_of(index);
    if (names.empty()) {
      diagnostics_.warning(data_->blocks[index].place, "INCLUDE", "FILENAME", "no file is named");
    }
    for (const IncludeName& name : names) {
      include(state, name, state.transform, "INCLUDE");
      if (stopped_) return;
    }
  }

  void include_transformed(FileState& state, std::size_t index) {
    const std::vector<Card> cards = read_cards(data_, index, diagnostics_);
    const Card& card = cards.front();
    if (!card.given("FILENAME")) {
      diagnostics_.error(card.place(), card.keyword(), "FILENAME", "no file is named");
      return;
    }
    data_->transforms.push_back(read_transform(
        card, data_->transforms[static_cast<std::size_t>(state.transform)], state.transform, diagnostics_));
    include(state, {std::string(card.text("FILENAME")), card.place("FILENAME")},
            static_cast<int>(data_->transforms.size()) - 1, card.keyword());
  }

  void include(const FileState& state, const IncludeName& name, int transform, const std::string& keyword) {
    if (!options_.follow_includes) return;
    const auto error = [&](std::string message, std::string hint) {
      diagnostics_.error(name.place, keyword, "FILENAME", std::move(message), std::move(hint));
    };
    std::vector<std::string> tried;
    const fs::path path = find_include(name.name, state.search, folder_of(state.file), tried);
    if (path.empty()) {
      std::string folders;
      for (const std::string& folder : tried) folders += (folders.empty() ? "'" : ", '") + folder + "'";
      return error("the file '" + name.name + "' is not found",
                   tried.empty() ? std::string() : "looked in " + folders + "; *INCLUDE_PATH adds a folder");
    }
    std::string why;
    const std::shared_ptr<const Text> text = data_->sources.storage->load(path, why);
    if (text == nullptr) return error("the file '" + name.name + "' cannot be included: " + why, {});
    for (int file = state.file; file >= 0; file = data_->sources.file(file).included_from.file) {
      if (&text_of(file) == text.get())
        return error("the file '" + name.name + "' includes itself", "the inner *INCLUDE is not followed");
    }
    if (state.depth >= deepest_include) return error("files include each other more than 64 deep", {});
    if (data_->sources.count() >= most_files) {
      stopped_ = true;
      return error("more than 10000 files are included; reading stops here", {});
    }
    FileState inner = state;
    inner.file = data_->sources.storage->add(path, text, name.place);
    inner.transform = transform;
    ++inner.depth;
    read_file(std::move(inner));
  }

  void refuse(std::size_t index) {
    const Block& block = data_->blocks[index];
    const char* what = block.keyword == "INCLUDE_BINARY"    ? "binary files"
                       : block.keyword == "INCLUDE_NASTRAN" ? "NASTRAN bulk data"
                                                            : "results of a forming analysis";
    diagnostics_.error(block.place, block.keyword, {}, std::string(what) + " cannot be included",
                       "translate the file to a keyword deck and use *INCLUDE");
  }

  struct Name {
    std::string keyword, nearest;
    bool known;
    std::shared_ptr<const std::vector<std::string>> options;
  };

  /// The keyword a written name stands for; each spelling is looked up once.
  const Name& resolve(std::string_view written) {
    std::string upper = normal_name(written.substr(0, 200));
    const auto [at, fresh] = names_.try_emplace(std::move(upper));
    Name& name = at->second;
    if (!fresh) return name;
    KeywordMatch match = match_keyword(at->first);
    name.known = match.keyword != nullptr;
    name.keyword = name.known ? match.keyword->name : at->first;
    name.options = std::make_shared<std::vector<std::string>>(std::move(match.options));
    if (!name.known && guesses_++ < most_guesses) name.nearest = nearest_keyword(at->first);
    return name;
  }

  std::shared_ptr<Deck::Data> data_;
  const ReadOptions& options_;
  Diagnostics& diagnostics_;
  std::unordered_map<std::string, Name> names_;
  int guesses_ = 0;
  bool stopped_ = false;
};

}  // namespace

void read_blocks(const std::shared_ptr<Deck::Data>& data, const ReadOptions& options,
                 Diagnostics& diagnostics) {
  data->transforms.emplace_back();  // number 0 changes nothing
  Reader(data, options, diagnostics).read_main();
}

}  // namespace cleave::deck
