/// Diagnostics as text for a person.

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "deck/deck.hpp"
#include "deck/diagnostic.hpp"
#include "deck/lexer.hpp"

namespace cleave::deck {
namespace {

constexpr std::size_t shown_per_kind = 5;
constexpr std::size_t longest_line = 200;

const char* name_of(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

/// Colours of a terminal, or nothing.
struct Paint {
  bool on;
  std::string bold(const std::string& s) const { return on ? "\033[1m" + s + "\033[0m" : s; }
  std::string severity(Severity v) const {
    const std::string name = name_of(v);
    if (!on) return name;
    return std::string(v == Severity::error     ? "\033[1;31m"
                       : v == Severity::warning ? "\033[1;35m"
                                                : "\033[1;36m") +
           name + "\033[0m";
  }
  std::string mark(const std::string& s) const { return on ? "\033[1;32m" + s + "\033[0m" : s; }
};

/// Position of a place in the order in which the deck was read: the lines of the including files, outermost
/// first, then its own.
std::vector<int> reading_order(const Place& place, const Sources& sources) {
  std::vector<int> order;
  for (Place p = place; p.file >= 0 && p.file < sources.count(); p = sources.file(p.file).included_from) {
    order.push_back(p.column);
    order.push_back(p.line);
    order.push_back(p.file);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

/// Columns are bytes; a terminal shows one sign for a sequence of UTF-8. Bytes that are none become '?'.
struct Shown {
  std::string text;
  std::vector<std::size_t> width_before;  ///< signs in front of each byte
};

Shown printable(std::string_view line) {
  Shown shown;
  std::size_t signs = 0;
  for (std::size_t i = 0; i < line.size();) {
    const auto c = static_cast<unsigned char>(line[i]);
    std::size_t length = c < 0x80                ? 1
                         : c >= 0xC2 && c < 0xE0 ? 2
                         : c >= 0xE0 && c < 0xF0 ? 3
                         : c >= 0xF0 && c < 0xF5 ? 4
                                                 : 0;
    for (std::size_t k = 1; k < length; ++k) {
      if (i + k >= line.size() || (static_cast<unsigned char>(line[i + k]) & 0xC0) != 0x80) length = 0;
    }
    if (length == 0 || (length == 1 && (c < 0x20 || c == 0x7F))) {
      shown.text += '?';
      length = 1;
    } else {
      shown.text += line.substr(i, length);
    }
    for (std::size_t k = 0; k < length; ++k) shown.width_before.push_back(signs);
    ++signs;
    i += length;
  }
  shown.width_before.push_back(signs);
  return shown;
}

std::string ruler(std::size_t width) {
  std::string text = "$";
  while (text.size() < width) text += text.size() % 10 == 9 ? '+' : '-';
  return text;
}

/// The line under its ruler, the place underlined.
std::string excerpt(const Place& place, const Sources& sources, const Paint& paint) {
  std::string line = expand_tabs(sources.line(place.file, place.line).substr(0, 20 * longest_line));
  std::size_t column = place.column > 0 ? static_cast<std::size_t>(place.column) - 1 : 0;
  const std::size_t cut =
      column > longest_line / 2 && line.size() > longest_line ? (column - longest_line / 2) / 10 * 10 : 0;
  if (cut >= line.size() && cut > 0) return {};
  const bool shortened = line.size() > cut + longest_line;
  line = line.substr(cut, longest_line);
  column -= cut;

  const Shown shown = printable(line);
  const std::string number = std::to_string(place.line), margin(std::max<std::size_t>(5, number.size()), ' ');
  const std::string gutter = margin + " | ";
  const bool keyword = !line.empty() && line[0] == '*';
  std::string text;
  if (!keyword)
    text += gutter +
            ruler(std::min<std::size_t>(
                longest_line,
                std::max<std::size_t>(
                    {40, line.size(), column + static_cast<std::size_t>(std::max(0, place.width))}))) +
            "\n";
  text += std::string(margin.size() - number.size(), ' ') + number + " | " + shown.text +
          (shortened ? " ..." : "") + "\n";
  if (place.column > 0) {
    const auto sign = [&](std::size_t byte) {
      const std::size_t last = shown.width_before.size() - 1;
      return byte <= last ? shown.width_before[byte] : shown.width_before[last] + byte - last;
    };
    const std::size_t from = sign(column);
    const std::size_t to =
        std::min(sign(column + static_cast<std::size_t>(std::max(1, place.width))), longest_line + 1);
    if (to > from)
      text += gutter + std::string(from, ' ') + paint.mark("^" + std::string(to - from - 1, '~')) + "\n";
  }
  return text;
}

std::string position(const Place& place, const Sources& sources) {
  std::string text = sources.file(place.file).path.string();
  if (place.line > 0) text += ":" + std::to_string(place.line);
  if (place.column > 0) text += ":" + std::to_string(place.column);
  return text;
}

}  // namespace

std::string Diagnostics::render(const Sources& sources, bool colour) const {
  const Paint paint{colour};
  const auto known = [&](const Place& p) { return p.file >= 0 && p.file < sources.count(); };

  std::vector<std::size_t> order(all_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::vector<int>> keys;
  for (const Diagnostic& d : all_) keys.push_back(reading_order(d.place, sources));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });

  // Of one kind only the first few are shown; the last of these says how many there are.
  using Kind = std::tuple<Severity, std::string, std::string>;
  const auto kind_of = [](const Diagnostic& d) {
    return Kind(d.severity, d.keyword, d.field.empty() ? d.message : d.field);
  };
  std::map<Kind, std::size_t> total, shown;
  for (const Diagnostic& d : all_) ++total[kind_of(d)];

  std::string text;
  int last_file = -1;
  for (const std::size_t index : order) {
    const Diagnostic& d = all_[index];
    const Kind kind = kind_of(d);
    const std::size_t before = shown[kind]++;
    if (before >= shown_per_kind) continue;

    // Who included the file: said again only when the file changes.
    if (known(d.place) && d.place.file != last_file) {
      const char* lead = "in file included from ";
      for (Place p = sources.file(d.place.file).included_from; known(p);
           p = sources.file(p.file).included_from) {
        text += lead + position({p.file, p.line, 0, 0}, sources) + "\n";
        lead = "                 from ";
      }
      last_file = d.place.file;
    }

    if (known(d.place)) text += paint.bold(position(d.place, sources)) + ": ";
    text += paint.severity(d.severity) + ": ";
    if (!d.keyword.empty()) text += "*" + d.keyword + (d.field.empty() ? ": " : " ");
    if (!d.field.empty()) text += d.field + ": ";
    text += printable(d.message).text + "\n";
    if (known(d.place) && d.place.line > 0) text += excerpt(d.place, sources, paint);
    if (!d.hint.empty()) text += "        hint: " + printable(d.hint).text + "\n";
    if (before + 1 == shown_per_kind && total[kind] > shown_per_kind) {
      text += "        ... and " + std::to_string(total[kind] - shown_per_kind) + " more of this kind\n";
    }
  }

  const auto sum = [&](Severity s) {
    const std::size_t n = count(s);
    return std::to_string(n) + " " + name_of(s) + (n == 1 ? "" : "s");
  };
  if (!all_.empty()) {
    text += sum(Severity::error) + ", " + sum(Severity::warning) + ", " + sum(Severity::note);
    if (dropped_ > 0) text += " (" + std::to_string(dropped_) + " not shown)";
    text += "\n";
  }
  return text;
}

}  // namespace cleave::deck
