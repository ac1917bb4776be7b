#include "deck/parameter.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "deck/edit_distance.hpp"
#include "deck/number.hpp"

namespace cleave::deck {
namespace {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string result = "'";
  result += text.substr(0, longest);
  if (text.size() > longest) result += "...";
  return result + "'";
}

std::string unknown_name(std::string_view name) {
  return "no parameter " + in_quotes(name) + " is defined here";
}

const Parameter* find(std::string_view name, const ValueContext& c) {
  return c.parameters->find(name, c.file, c.epoch, *c.sources);
}

std::string hint_for(std::string_view name, const ValueContext& c) {
  constexpr std::size_t enough = 200;  // nobody reads the hints of so many mistakes, and each is a search
  if (c.diagnostics->count(Severity::error) > enough) return {};
  const Parameter* near = c.parameters->nearest(name);
  if (near == nullptr) return "define it with *PARAMETER before this line";
  if (edit_distance(name, near->name, 1) > 0) return "did you mean &" + near->name + "?";
  return "it is defined in " + c.sources->file(near->place.file).path.string() + ":" +
         std::to_string(near->place.line) + ", but behind this line or only for another file";
}

/// The number behind &name, -&name or <expression>; nothing if a mistake was reported.
std::optional<Number> resolve(std::string_view text, const ValueContext& c, std::string_view field,
                              Place place) {
  const auto error = [&](std::string message, std::string hint) {
    c.diagnostics->error(place, std::string(c.keyword), std::string(field), std::move(message),
                         std::move(hint));
    return std::nullopt;
  };
  if (text[0] == '<') {
    if (text.back() != '>' || text.size() < 2) {
      return error("found " + in_quotes(text) + ", an expression without its closing '>'",
                   "a long expression fits in the comma format");
    }
    std::string_view unknown;
    const auto result = evaluate(text.substr(1, text.size() - 2),
                                 [&](std::string_view name, Number& value, std::string& why) {
                                   const Parameter* p = find(name, c);
                                   if (p == nullptr)
                                     why = unknown_name(name), unknown = name;
                                   else if (p->type == 'C')
                                     why = in_quotes(name) + " is text, a number was expected";
                                   else
                                     value = p->number;
                                   return why.empty();
                                 });
    if (!result.error.empty()) {
      return error("in the expression " + in_quotes(text) + ": " + result.error,
                   unknown.empty() ? std::string() : hint_for(unknown, c));
    }
    if (result.truncated_division) {
      c.diagnostics->warning(
          place, std::string(c.keyword), std::string(field),
          "in " + in_quotes(text) + " two integers are divided and the remainder is dropped",
          "write one of them with a decimal point");
    }
    return result.value;
  }
  const bool negative = text[0] == '-';
  const std::string_view name = trim(text.substr(text[0] == '&' ? 1 : 2));
  const Parameter* p = find(name, c);
  if (p == nullptr) return error(unknown_name(name), hint_for(name, c));
  if (p->type == 'C') return error("parameter " + in_quotes(name) + " is text, a number was expected", {});
  Number value = p->number;
  if (negative) {
    const bool smallest = value.integer == std::numeric_limits<std::int64_t>::min();
    value = value.is_integer && !smallest ? Number::of(-value.integer) : Number::of(-value.real);
  }
  return value;
}

void report(NumberState state, std::string_view text, const char* expected, const ValueContext& c,
            std::string_view field, Place place) {
  std::string message = "found " + in_quotes(text) + ", expected " + expected, hint;
  if (state == NumberState::out_of_range) message += " that fits 64 bits";
  if (state == NumberState::not_whole) hint = "the value has a fraction";
  if (state == NumberState::malformed && text.find(' ') != std::string_view::npos) {
    hint = "a number has no blanks inside: are the columns shifted?";
  }
  c.diagnostics->error(place, std::string(c.keyword), std::string(field), std::move(message),
                       std::move(hint));
}

}  // namespace

std::string Parameters::key(std::string_view name, int file) {
  std::string result(name);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (file >= 0) result += '\n' + std::to_string(file);
  return result;
}

void Parameters::define(Parameter parameter, int local_file, Diagnostics& diagnostics) {
  auto& same = by_name_[key(parameter.name, local_file)];
  if (!same.empty()) {
    const Parameter& before = *same.back();
    const bool keep_first = duplicate == Duplicate::first || duplicate == Duplicate::first_with_warning ||
                            duplicate == Duplicate::error;
    const std::string message =
        "parameter " + in_quotes(parameter.name) + " is defined again" +
        (before.name != parameter.name ? " (as " + in_quotes(before.name) + ", case does not matter)" : "") +
        (keep_first ? "; the first definition stays" : "; from here on the new value holds");
    const std::string hint =
        "*PARAMETER_LOCAL keeps a name to its file, *PARAMETER_DUPLICATION chooses the rule";
    if (duplicate == Duplicate::error)
      diagnostics.error(parameter.place, "PARAMETER", parameter.name, message, hint);
    else if (duplicate == Duplicate::later_with_warning || duplicate == Duplicate::first_with_warning)
      diagnostics.warning(parameter.place, "PARAMETER", parameter.name, message, hint);
    if (keep_first) return;
  }
  parameter.epoch = epoch();
  all_.push_back(std::move(parameter));
  same.push_back(&all_.back());
}

const Parameter* Parameters::find(std::string_view name, int file, std::uint32_t epoch,
                                  const Sources& sources) const {
  constexpr std::size_t longest_name = 256;  // no real name comes near; bounds the work on any bytes
  if (name.size() > longest_name) return nullptr;
  const auto in_scope = [&](int scope) -> const Parameter* {
    const auto found = by_name_.find(key(name, scope));
    if (found == by_name_.end()) return nullptr;
    const auto& list = found->second;
    const auto after =
        std::partition_point(list.begin(), list.end(), [&](const Parameter* p) { return p->epoch < epoch; });
    return after == list.begin() ? nullptr : *(after - 1);
  };
  for (int scope = file; scope >= 0; scope = sources.file(scope).included_from.file) {
    if (const Parameter* p = in_scope(scope)) return p;
  }
  return in_scope(-1);
}

const Parameter* Parameters::nearest(std::string_view name) const {
  constexpr std::size_t most = 10000;  // a hint is not worth more
  const Parameter* best = nullptr;
  std::size_t distance = std::max<std::size_t>(1, name.size() / 3) + 1;
  if (name.size() > 80) return best;
  const std::string wanted = key(name, -1);
  for (std::size_t i = 0; i < std::min(all_.size(), most); ++i) {
    const std::size_t d = edit_distance(wanted, key(all_[i].name, -1), distance);
    if (d < distance) distance = d, best = &all_[i];
  }
  return best;
}

bool read_value(std::string_view text, const ValueContext& c, std::string_view field, Place place,
                double& value) {
  if (is_reference(text)) {
    const auto number = resolve(text, c, field, place);
    if (number) value = number->real;
    return number.has_value();
  }
  const NumberState state = parse_real(text, value);
  if (state != NumberState::good) report(state, text, "a real number", c, field, place);
  return state == NumberState::good;
}

bool read_value(std::string_view text, const ValueContext& c, std::string_view field, Place place,
                std::int64_t& value) {
  if (is_reference(text)) {
    const auto number = resolve(text, c, field, place);
    if (!number) return false;
    if (!number->is_integer &&
        (number->real != std::floor(number->real) || std::fabs(number->real) >= 9.2e18)) {
      report(NumberState::not_whole, text, "a parameter with a whole value", c, field, place);
      return false;
    }
    value = number->is_integer ? number->integer : static_cast<std::int64_t>(number->real);
    return true;
  }
  const NumberState state = parse_integer(text, value);
  if (state != NumberState::good) report(state, text, "an integer", c, field, place);
  return state == NumberState::good;
}

bool read_expression(std::string_view text, const ValueContext& c, std::string_view field, Place place,
                     Number& value) {
  const auto number = resolve(text, c, field, place);
  if (number) value = *number;
  return number.has_value();
}

const std::string* read_text_reference(std::string_view text, const ValueContext& c, std::string_view field,
                                       Place place) {
  const std::string_view name = trim(text.substr(1));
  if (const Parameter* p = find(name, c)) return &p->text;
  c.diagnostics->error(place, std::string(c.keyword), std::string(field), unknown_name(name),
                       hint_for(name, c));
  return nullptr;
}

}  // namespace cleave::deck
