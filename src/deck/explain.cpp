/// The card table in words.

#include <cmath>
#include <cstdio>

#include "deck/layout.hpp"
#include "deck/layout_table.hpp"

namespace cleave::deck {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// Postfix code back to what a person reads.
std::string words(const table::Keyword& keyword, std::uint16_t first, std::uint16_t count) {
  using table::Code;
  std::vector<std::string> stack;
  const auto pop = [&] {
    std::string top = stack.empty() ? std::string() : std::move(stack.back());
    if (!stack.empty()) stack.pop_back();
    return top;
  };
  const auto binary = [&](const char* sign) {
    const std::string right = pop(), left = pop();
    stack.push_back(left + sign + right);
  };
  for (const table::Op* op = table::code(first); op != table::code(first) + count; ++op) {
    const auto field = [&] {
      return std::string(table::first_name(table::field(keyword, op->argument).name));
    };
    switch (op->code) {
      case Code::number:
        stack.push_back(number(op->number));
        break;
      case Code::field:
        stack.push_back(field());
        break;
      case Code::same_text:
        stack.push_back(field() + " is " + op->word);
        break;
      case Code::line_fields:
        stack.emplace_back("number of values on the line");
        break;
      case Code::line_starts:
        stack.push_back(std::string("the line begins with ") + op->word);
        break;
      case Code::rows:
        stack.push_back("times " + field() + " was read");
        break;
      case Code::negate:
        stack.push_back("-" + pop());
        break;
      case Code::absolute:
        stack.push_back("|" + pop() + "|");
        break;
      case Code::invert:
        stack.push_back("not " + pop());
        break;
      case Code::add:
        binary(" + ");
        break;
      case Code::subtract:
        binary(" - ");
        break;
      case Code::multiply:
        binary(" * ");
        break;
      case Code::divide:
        binary(" / ");
        break;
      case Code::equal:
        binary(" = ");
        break;
      case Code::differ:
        binary(" is not ");
        break;
      case Code::less:
        binary(" < ");
        break;
      case Code::less_equal:
        binary(" <= ");
        break;
      case Code::greater:
        binary(" > ");
        break;
      case Code::greater_equal:
        binary(" >= ");
        break;
      case Code::both:
        binary(" and ");
        break;
      case Code::either:
        binary(" or ");
        break;
      case Code::choose: {
        const std::string otherwise = pop(), then = pop(), condition = pop();
        stack.push_back(then + " if " + condition + ", else " + otherwise);
        break;
      }
    }
  }
  return pop();
}

std::string columns(std::size_t first, std::size_t width) {
  char text[32];
  std::snprintf(text, sizeof text, "%3zu-%-3zu", first + 1, first + width);
  return text;
}

std::string pad(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

/// Entries of the table, one paragraph each.
void add_items(const table::Keyword& keyword, std::uint16_t first, std::uint16_t count,
               const std::string& indent, int& line, std::string& out) {
  for (std::uint16_t i = first; i < first + count; ++i) {
    const table::Item& item = *table::item(i);
    std::string remarks;
    if (item.when_count > 0) remarks += ", if " + words(keyword, item.when_first, item.when_count);
    if (item.to_end)
      remarks += ", repeats up to the next keyword";
    else if (item.repeat_count > 0)
      remarks += std::string(item.kind == table::Kind::series ? ", number of values: " : ", times: ") +
                 words(keyword, item.repeat_first, item.repeat_count);
    if (item.optional && !item.to_end) remarks += ", may be left out";
    if (item.kind == table::Kind::group) {
      out += indent + "lines that repeat together" + remarks + ":\n";
      add_items(keyword, static_cast<std::uint16_t>(i + 1), item.children, indent + "  ", line, out);
      i = static_cast<std::uint16_t>(i + item.children);
      continue;
    }
    out += indent + "line " + std::to_string(++line) + remarks + "\n";
    if (item.kind == table::Kind::series) {
      const table::Field& f = table::field(keyword, item.first_field);
      out += indent + "  " + pad(f.name, 10) + " " + f.type + "  " + std::to_string(item.per_line) +
             " a line, " + std::to_string(item.width) + " columns each  " + f.meaning + "\n";
      continue;
    }
    for (std::size_t k = 0; k < item.field_count; ++k) {
      const table::Field& f = table::field(keyword, item.first_field + k);
      std::string row =
          indent + "  " + columns(f.offset, f.width) + " " + pad(f.name, 10) + " " + f.type + "  ";
      const std::string value = !f.has_default ? "" : f.type == 'A' ? f.text : number(f.number);
      row += pad(value.empty() ? "" : "[" + value + "]", 10) + " " + f.meaning;
      while (!row.empty() && row.back() == ' ') row.pop_back();
      out += row + "\n";
    }
  }
}

}  // namespace

std::string describe(std::string_view canonical) {
  const table::Keyword* keyword = table::find(canonical);
  if (keyword == nullptr) return {};
  std::string out = "*" + std::string(keyword->name) + "\n";
  std::string also;
  for (const table::Alias& alias : table::aliases()) {
    if (table::keywords()[alias.keyword].name == keyword->name)
      also += (also.empty() ? "*" : ", *") + std::string(alias.name);
  }
  if (!also.empty()) out += "also written " + also + "\n";
  if (keyword->note[0] != '\0') out += std::string(keyword->note) + "\n";
  if (keyword->slides[0] != '\0') out += "in class slides: " + std::string(keyword->slides) + "\n";
  out += keyword->repeat_set ? "The lines may repeat: each set is one entry.\n"
                             : "One data set under each keyword.\n";
  out += "Columns of the standard format, name, type, [default], meaning:\n";

  int line = 0;
  const auto add_options = [&](bool before) {
    for (std::uint16_t i = 0; i < keyword->option_count; ++i) {
      const table::Option& option = *table::option(static_cast<std::uint16_t>(keyword->first_option + i));
      if (option.before != before) continue;
      if (option.suffix[0] == '\0')
        out += "optional card " + std::string(option.letter) + "\n";
      else
        out += "with _" + std::string(option.suffix) + (option.item_count == 0 ? ": no further line" : "") +
               "\n";
      add_items(*keyword, option.first_item, option.item_count, "  ", line, out);
    }
  };
  add_options(true);
  add_items(*keyword, keyword->first_item, keyword->item_count, "", line, out);
  add_options(false);
  return out;
}

}  // namespace cleave::deck
