#include "deck/diagnostic.hpp"

namespace cleave::deck {
namespace {

constexpr std::size_t most_kept = 20000;  ///< bounds the memory a hopeless file can take

std::size_t mix(std::size_t seed, std::size_t value) {
  return seed ^ (value + 0x9e3779b97f4a7c15 + (seed << 6) + (seed >> 2));
}

}  // namespace

void Diagnostics::add(Diagnostic d) {
  // Cards may be read more than once: the same thing is said once.
  std::size_t hash = std::hash<std::string>()(d.message);
  hash = mix(hash, std::hash<std::string>()(d.field));
  hash = mix(hash, static_cast<std::size_t>(d.place.file) * 31 + static_cast<std::size_t>(d.place.line));
  hash = mix(hash, static_cast<std::size_t>(d.place.column) * 31 + static_cast<std::size_t>(d.severity));
  if (all_.size() >= most_kept) {
    ++counts_[static_cast<std::size_t>(d.severity)];
    ++dropped_;
    return;
  }
  if (!seen_.insert(hash).second) return;
  ++counts_[static_cast<std::size_t>(d.severity)];
  all_.push_back(std::move(d));
}

void Diagnostics::error(Place place, std::string keyword, std::string field, std::string message,
                        std::string hint) {
  add({Severity::error,
       place,
       std::move(keyword),
       std::move(field),
       std::move(message),
       std::move(hint),
       {}});
}

void Diagnostics::warning(Place place, std::string keyword, std::string field, std::string message,
                          std::string hint) {
  add({Severity::warning,
       place,
       std::move(keyword),
       std::move(field),
       std::move(message),
       std::move(hint),
       {}});
}

void Diagnostics::note(Place place, std::string keyword, std::string field, std::string message,
                       std::string hint) {
  add({Severity::note, place, std::move(keyword), std::move(field), std::move(message), std::move(hint), {}});
}

void Diagnostics::find_rows(const std::function<Place(const Diagnostic&)>& find) {
  for (Diagnostic& d : all_) {
    if (d.row.kind == NumberedRow::Kind::none) continue;
    const Place place = find(d);
    if (place.line == 0) continue;
    d.place = place;
    d.row = {};
  }
}

std::size_t Diagnostics::count(Severity severity) const {
  return counts_[static_cast<std::size_t>(severity)];
}

}  // namespace cleave::deck
