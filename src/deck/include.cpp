#include "deck/include.hpp"

#include <algorithm>
#include <cctype>

namespace cleave::deck {
namespace {

namespace fs = std::filesystem;

fs::path find_as(const fs::path& name, const std::vector<fs::path>& folders) {
  std::error_code error;
  if (name.is_absolute()) return fs::is_regular_file(name, error) ? name : fs::path();
  for (const fs::path& folder : folders) {
    const fs::path candidate = folder / name;
    if (fs::is_regular_file(candidate, error)) return candidate.lexically_normal();
  }
  return {};
}

/// FCTTEM: from which scale to which, as factor and shift of `new = factor * (old + shift)`.
struct TemperatureRule {
  const char* name;
  double factor, shift;
};
constexpr TemperatureRule temperature_rules[] = {{"FTOC", 5.0 / 9.0, -32.0},  {"CTOF", 1.8, 160.0 / 9.0},
                                                 {"FTOK", 5.0 / 9.0, 459.67}, {"KTOF", 1.8, -2298.35 / 9.0},
                                                 {"KTOC", 1.0, -273.15},      {"CTOK", 1.0, 273.15}};

}  // namespace

fs::path find_include(std::string_view name, const SearchPath& search, const fs::path& including_folder,
                      std::vector<std::string>& tried) {
  std::vector<fs::path> folders{search.main_folder};
  folders.insert(folders.end(), search.paths.begin(), search.paths.end());
  folders.push_back(including_folder);
  std::vector<fs::path> once;
  for (fs::path& folder : folders) {
    folder = folder.lexically_normal();
    if (folder.empty()) folder = ".";
    if (std::find(once.begin(), once.end(), folder) == once.end()) once.push_back(folder);
  }
  if (const fs::path found = find_as(fs::path(name), once); !found.empty()) return found;
  std::string turned(name);
  std::replace(turned.begin(), turned.end(), '\\', '/');
  if (turned != name) {
    if (const fs::path found = find_as(turned, once); !found.empty()) return found;
  }
  for (const fs::path& folder : once) tried.push_back(folder.string());
  return {};
}

IncludeTransform read_transform(const Card& card, const IncludeTransform& outer, int outer_index,
                                Diagnostics& diagnostics) {
  IncludeTransform t = outer;
  t.parent = outer_index;
  t.place = card.place();
  const auto add = [&](std::int64_t& offset, const char* field) {
    if (__builtin_add_overflow(offset, card.integer(field), &offset)) {
      diagnostics.error(card.place(field), card.keyword(), field,
                        "the offsets of nested files add up beyond 64 bits");
    }
  };
  add(t.node_offset, "IDNOFF");
  add(t.element_offset, "IDEOFF");
  add(t.part_offset, "IDPOFF");
  add(t.material_offset, "IDMOFF");
  add(t.set_offset, "IDSOFF");
  add(t.function_offset, "IDFOFF");
  add(t.definition_offset, "IDDOFF");
  add(t.other_offset, "IDROFF");
  t.transformation = card.integer("TRANID");

  const auto factor = [&](std::string_view field) {
    const double value = card.real(field);
    if (value < 0.0)
      diagnostics.error(card.place(field), card.keyword(), std::string(field),
                        "a unit factor must be positive");
    return value > 0.0 ? value : 1.0;  // blank and 0 mean 1
  };
  t.mass *= factor("FCTMAS");
  t.time *= factor("FCTTIM");
  t.length *= factor("FCTLEN");
  if (card.given("FCTTEM")) {
    std::string name(card.text("FCTTEM"));
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const auto* rule = std::find_if(std::begin(temperature_rules), std::end(temperature_rules),
                                    [&](const auto& r) { return name == r.name; });
    if (rule != std::end(temperature_rules)) {
      // new = f2 (f1 (x + s1) + s2) = f1 f2 (x + s1 + s2 / f1), outer rule last
      t.temperature_shift = rule->shift + outer.temperature_shift / rule->factor;
      t.temperature_factor = rule->factor * outer.temperature_factor;
    } else if (name != "1" && name != "1." && name != "1.0" && name != "0" && name != "0.0") {
      diagnostics.error(card.place("FCTTEM"), card.keyword(), "FCTTEM",
                        "found '" + std::string(card.text("FCTTEM")) + "', expected a change of scale",
                        "FtoC, CtoF, FtoK, KtoF, KtoC or CtoK");
    }
  }
  for (const char* field : {"PREFIX", "SUFFIX", "FCTCHG"}) {
    if (card.given(field) && card.text(field) != "1.0" &&
        (std::string_view(field) != "FCTCHG" || (card.real(field) != 0.0 && card.real(field) != 1.0))) {
      diagnostics.warning(card.place(field), card.keyword(), field, "the field is not honoured");
    }
  }
  return t;
}

}  // namespace cleave::deck
