#include "deck/parameter_lines.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace cleave::deck {
namespace {

class ParameterReader {
 public:
  ParameterReader(const Body& body, bool local, const ValueContext& context, Parameters& parameters)
      : body_(body),
        local_(local ? body.file : -1),
        width_(body.format == Format::wide ? 20 : 10),
        context_(context),
        parameters_(parameters) {}

  void read_pairs() {
    Line line;
    for (LineCursor lines(body_); lines.next(line);) {
      expand(line);
      if (is_blank(line.text)) continue;
      // Free format if a comma stands in the columns of the pairs.
      if (find_comma(line.text.substr(0, 8 * width_)) != std::string_view::npos)
        read_comma_pairs(line);
      else
        read_fixed_pairs(line);
    }
  }

  void read_expressions() {
    Line line;
    std::string_view head;
    std::string expression;
    int head_line = 0;
    const auto flush = [&] {
      if (!head.empty()) define_expression(head, expression, head_line);
      head = {};
      expression.clear();
    };
    for (LineCursor lines(body_); lines.next(line);) {
      expand(line);
      if (is_blank(line.text)) continue;
      if (is_blank(line.text.substr(0, width_))) {  // goes on with the expression above
        expression += line.text.substr(std::min(width_, line.text.size()));
        continue;
      }
      flush();
      const std::size_t comma = line.text.substr(0, width_ + 1).find(',');
      const std::size_t cut = comma == std::string_view::npos ? std::min(width_, line.text.size()) : comma;
      head = trim(line.text.substr(0, cut));
      head_line = line.number;
      expression =
          line.text.substr(std::min(line.text.size(), comma == std::string_view::npos ? cut : cut + 1));
    }
    flush();
  }

 private:
  /// Replaces the tabs of a line by blanks.
  void expand(Line& line) {
    const std::size_t tab = line.text.find('\t');
    if (tab == std::string_view::npos) return;
    context_.diagnostics->warning(
        place(line.number, static_cast<int>(tab) + 1, 1), keyword(), {},
        "the line has tabs; each was taken as blanks up to the next multiple of 8 columns");
    line.text = owned_.emplace_back(expand_tabs(line.text));
  }

  Place place(int line, int column, std::size_t width) const {
    return {body_.file, line, column, static_cast<int>(std::min<std::size_t>(width, 1000))};
  }
  std::string keyword() const { return std::string(context_.keyword); }

  void read_fixed_pairs(const Line& line) {
    for (std::size_t pair = 0; pair < 4 && 2 * pair * width_ < line.text.size(); ++pair) {
      const std::size_t at = 2 * pair * width_;
      const std::string_view name = trim(line.text.substr(at, width_));
      const std::string_view value =
          at + width_ < line.text.size() ? trim(line.text.substr(at + width_, width_)) : std::string_view();
      if (name.empty() && value.empty()) continue;
      define(name, place(line.number, static_cast<int>(at) + 1, width_), value,
             place(line.number, static_cast<int>(at + width_) + 1, width_));
    }
  }

  void read_comma_pairs(const Line& line) {
    std::string_view rest = line.text;
    const auto take = [&](Place& where) {
      const std::size_t comma = find_comma(rest);
      const std::string_view raw = rest.substr(0, comma), value = trim(raw);
      const char* at = value.empty() ? raw.data() : value.data();
      where = place(line.number, static_cast<int>(at - line.text.data()) + 1,
                    std::max<std::size_t>(1, value.size()));
      rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
      return value;
    };
    while (!is_blank(rest)) {
      Place name_place, value_place;
      const std::string_view name = take(name_place);
      const std::string_view value = take(value_place);
      if (!name.empty() || !value.empty()) define(name, name_place, value, value_place);
    }
  }

  /// Splits `R tend` or `Rtend`; false: reported.
  bool split_head(std::string_view head, Place where, char& type, std::string_view& name) {
    type = head.empty() ? ' ' : static_cast<char>(std::toupper(static_cast<unsigned char>(head[0])));
    name = head.empty() ? head : trim(head.substr(1));
    const bool good_name = !name.empty() && name.size() <= 80 &&
                           (std::isalpha(static_cast<unsigned char>(name[0])) != 0 || name[0] == '_') &&
                           std::all_of(name.begin(), name.end(),
                                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
    if ((type == 'R' || type == 'I' || type == 'C') && good_name) return true;
    context_.diagnostics->error(
        where, keyword(), {},
        "found '" + std::string(head.substr(0, 60)) + "', expected R, I or C and the name of a parameter",
        "a name has letters, digits and _; fixed columns are 10 wide");
    return false;
  }

  void define(std::string_view head, Place head_place, std::string_view value, Place value_place) {
    Parameter p;
    std::string_view name;
    if (!split_head(head, head_place, p.type, name)) return;
    p.name = name;
    p.text = value;
    p.place = head_place;
    context_.epoch = parameters_.epoch();
    if (p.type == 'R') {
      double number = 0.0;
      if (!given(value, name, value_place) || !read_value(value, context_, name, value_place, number)) return;
      p.number = Number::of(number);
    } else if (p.type == 'I') {
      std::int64_t number = 0;
      if (!given(value, name, value_place) || !read_value(value, context_, name, value_place, number)) return;
      p.number = Number::of(number);
    }
    parameters_.define(std::move(p), local_, *context_.diagnostics);
  }

  bool given(std::string_view value, std::string_view name, Place where) {
    if (value.empty())
      context_.diagnostics->error(where, keyword(), std::string(name), "the parameter has no value");
    return !value.empty();
  }

  void define_expression(std::string_view head, std::string_view expression, int line) {
    Parameter p;
    std::string_view name;
    const Place where = place(line, 1, width_);
    if (!split_head(head, where, p.type, name)) return;
    p.name = name;
    p.text = trim(expression);
    p.place = where;
    context_.epoch = parameters_.epoch();
    if (p.type != 'C') {
      if (!given(p.text, name, where)) return;
      const std::string bracketed = "<" + p.text + ">";
      double number = 0.0;
      Number value;
      if (!read_expression(bracketed, context_, name, where, value)) return;
      number = value.real;
      if (p.type == 'R')
        p.number = Number::of(number);
      else if (std::fabs(number) < 9.2e18)
        p.number = value.is_integer ? value : Number::of(static_cast<std::int64_t>(number));
      else
        return context_.diagnostics->error(where, keyword(), std::string(name),
                                           "the value does not fit an integer");
    }
    parameters_.define(std::move(p), local_, *context_.diagnostics);
  }

  const Body& body_;
  int local_;
  std::size_t width_;
  ValueContext context_;
  Parameters& parameters_;
  std::deque<std::string> owned_;  ///< texts that outlive their lines
};

}  // namespace

void read_parameters(const Body& body, bool expressions, bool local, const ValueContext& context,
                     Parameters& parameters) {
  ParameterReader reader(body, local, context, parameters);
  if (expressions)
    reader.read_expressions();
  else
    reader.read_pairs();
}

}  // namespace cleave::deck
