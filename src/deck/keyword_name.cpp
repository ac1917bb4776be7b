#include "deck/keyword_name.hpp"

#include <algorithm>
#include <cctype>

#include "deck/edit_distance.hpp"
#include "deck/layout.hpp"

namespace cleave::deck {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t longest_name = 200;

Words split(std::string_view name) {
  Words words;
  for (std::size_t at = 0; at <= name.size();) {
    const std::size_t stop = std::min(name.find('_', at), name.size());
    words.push_back(name.substr(at, stop - at));
    at = stop + 1;
  }
  return words;
}

struct Candidate {
  std::string_view name;
  Words words;
  const table::Keyword* keyword;
};

/// Every name of the table, most words first, so that the first match is the longest.
const std::vector<Candidate>& candidates() {
  static const std::vector<Candidate> all = [] {
    std::vector<Candidate> list;
    for (const table::Keyword& k : table::keywords()) list.push_back({k.name, split(k.name), &k});
    for (const table::Alias& a : table::aliases())
      list.push_back({a.name, split(a.name), &table::keywords()[a.keyword]});
    std::stable_sort(list.begin(), list.end(),
                     [](const Candidate& a, const Candidate& b) { return a.words.size() > b.words.size(); });
    return list;
  }();
  return all;
}

std::vector<std::string_view> suffixes(const table::Keyword& keyword) {
  std::vector<std::string_view> all;
  for (std::size_t i = 0; i < keyword.option_count; ++i) {
    std::string_view list = table::option(static_cast<std::uint16_t>(keyword.first_option + i))->suffix;
    while (!list.empty()) {
      const std::size_t stop = std::min(list.find('|'), list.size());
      all.push_back(list.substr(0, stop));
      list.remove_prefix(std::min(stop + 1, list.size()));
    }
  }
  return all;
}

/// Lays the words of a name on the words of a candidate and its options, each option once at most.
bool lay(const Words& name, std::size_t at, const Candidate& candidate, std::size_t used,
         const std::vector<std::string_view>& options, std::vector<std::string>& found) {
  if (at == name.size()) return used == candidate.words.size();
  if (used < candidate.words.size() && name[at] == candidate.words[used] &&
      lay(name, at + 1, candidate, used + 1, options, found)) {
    return true;
  }
  if (at == 0) return false;  // the family comes first
  for (const std::string_view option : options) {
    const Words words = split(option);
    if (name.size() - at < words.size() ||
        !std::equal(words.begin(), words.end(), name.begin() + static_cast<std::ptrdiff_t>(at)))
      continue;
    if (std::find(found.begin(), found.end(), option) != found.end()) continue;
    found.emplace_back(option);
    if (lay(name, at + words.size(), candidate, used, options, found)) return true;
    found.pop_back();
  }
  return false;
}

/// `MAT_24_TITLE` to `MAT_024_TITLE`.
std::string padded_number(std::string_view name) {
  std::string result(name);
  if (!name.starts_with("MAT_") && !name.starts_with("EOS_")) return result;
  std::size_t stop = 4;
  while (stop < name.size() && std::isdigit(static_cast<unsigned char>(name[stop])) != 0) ++stop;
  if (stop == 4 || stop >= 7 || (stop < name.size() && name[stop] == '-'))
    return result;  // MAT_3-PARAMETER_... is a name
  return result.insert(4, 7 - stop, '0');
}

}  // namespace

std::string normal_name(std::string_view written) {
  if (!written.empty() && written[0] == '*') written.remove_prefix(1);
  std::string name(written);
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

KeywordMatch match_keyword(std::string_view written) {
  KeywordMatch match;
  if (written.empty() || written.size() > longest_name) return match;
  if ((match.keyword = table::find(written)) != nullptr) return match;
  const std::string name = padded_number(written);
  const Words words = split(name);
  for (const Candidate& candidate : candidates()) {
    if (candidate.words.size() > words.size() || candidate.words[0] != words[0]) continue;
    if (!lay(words, 0, candidate, 0, suffixes(*candidate.keyword), match.options)) continue;
    match.keyword = candidate.keyword;
    return match;
  }
  return match;
}

std::string_view canonical_keyword(std::string_view written) {
  const KeywordMatch match = match_keyword(normal_name(written));
  return match.keyword == nullptr ? std::string_view() : match.keyword->name;
}

std::string_view nearest_keyword(std::string_view written) {
  const std::string name = normal_name(written);
  std::size_t distance = std::max<std::size_t>(2, name.size() / 4) + 1;
  std::string_view best;
  const auto look_at = [&](std::string_view known) {
    const std::size_t d = edit_distance(name, known, distance);
    if (d < distance) distance = d, best = known;
  };
  // A known family narrows the search; a name whose first word is unknown is compared with all.
  const std::string_view family = std::string_view(name).substr(0, name.find('_'));
  const auto in_family = [&](const Candidate& c) { return c.words[0] == family; };
  const bool known_family = std::any_of(candidates().begin(), candidates().end(), in_family);
  for (const Candidate& c : candidates()) {
    if (!known_family || in_family(c)) look_at(c.name);
  }
  if (!best.empty()) return best;
  // Nothing looks alike: the longest known beginning says at least the family.
  for (const table::Keyword& k : table::keywords()) {
    const std::string_view known = k.name;
    if (known.find('_') != std::string_view::npos && name.starts_with(known) && known.size() > best.size())
      best = known;
  }
  return best;
}

std::span<const std::string_view> known_keywords() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const table::Keyword& k : table::keywords()) list.emplace_back(k.name);
    return list;
  }();
  return names;
}

}  // namespace cleave::deck
