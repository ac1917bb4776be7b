#include "deck/lexer.hpp"

#include <algorithm>

namespace cleave::deck {
namespace {

constexpr std::uint16_t long_text = 40;  ///< wider text columns are titles and file names

bool is_long_text(const table::Field& f) {
  return f.type == 'A' && f.width >= long_text;
}

}  // namespace

std::string expand_tabs(std::string_view text) {
  constexpr std::size_t longest = 1000000;  // no line of columns comes near; bounds what a line of tabs takes
  std::string result;
  for (const char c : text) {
    if (c != '\t' || result.size() > longest)
      result += c;
    else
      result.append(8 - result.size() % 8, ' ');
  }
  return result;
}

std::size_t find_comma(std::string_view text) {
  // Most lines have none: one quick search settles it. All searches are short, so that cutting a line of any
  // length into its values takes linear time.
  constexpr std::size_t longest_expression = 1000;
  std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return comma;
  for (std::size_t open = text.substr(0, comma).find('<'); open != std::string_view::npos;) {
    const std::size_t length = text.substr(open, longest_expression).find('>');
    if (length == std::string_view::npos) return comma;
    const std::size_t close = open + length;
    if (close > comma) comma = text.find(',', close);
    open = text.substr(0, comma).find('<', close);
  }
  return comma;
}

std::size_t find_format_comma(std::string_view text, std::size_t reach) {
  const std::size_t near = find_comma(text.substr(0, reach));
  if (near != std::string_view::npos || text.size() <= reach) return near;
  constexpr std::size_t longest_number = 64;
  const std::size_t far = text.substr(0, reach + longest_number).find(',');
  double real = 0.0;
  if (far == std::string_view::npos || parse_real(trim(text.substr(0, far)), real) != NumberState::good)
    return std::string_view::npos;
  return far;
}

void FieldCutter::cut(std::string_view line, const table::Field* fields, std::size_t count, Format format) {
  line_ = line;
  fields_ = fields;
  count_ = count;
  format_ = format;
  comma_ = false;
  pieces_.clear();
  rest_ = {};
  if (count == 0 || is_long_text(fields[0])) return;
  const table::Field& last = fields[count - 1];
  const Columns end = columns_of(last, format);
  // A comma behind the columns is a remark; one inside a heading belongs to it.
  const std::size_t reach = is_long_text(last) ? end.offset : end.offset + end.width;
  const std::size_t comma =
      is_long_text(last) ? find_comma(line.substr(0, reach)) : find_format_comma(line, reach);
  if (comma == std::string_view::npos) return;
  comma_ = true;

  // No more pieces than fields, however long the line is; a text at the end takes all that is left.
  const std::size_t most = std::size_t{last.comma} + 1;
  rest_ = line;
  while (pieces_.size() < most) {
    const std::size_t stop =
        pieces_.size() + 1 == most && is_long_text(last) ? std::string_view::npos : find_comma(rest_);
    pieces_.push_back(rest_.substr(0, stop));
    if (stop == std::string_view::npos) {
      rest_ = {};
      break;
    }
    rest_.remove_prefix(stop + 1);
  }
}

bool FieldCutter::cuts_a_number() const {
  for (std::size_t k = 0; !comma_ && k + 1 < count_; ++k) {
    const Columns left = columns_of(fields_[k], format_), right = columns_of(fields_[k + 1], format_);
    const std::size_t border = left.offset + left.width;
    if (border >= line_.size()) break;
    if (right.offset != border || fields_[k].type == 'A' || fields_[k + 1].type == 'A') continue;
    if (line_[border - 1] == ' ' || line_[border] == ' ') continue;
    const std::string_view next = line_.substr(border, right.width);
    if (next.size() == right.width && next.back() != ' ') continue;
    const std::size_t first = line_.find_last_of(' ', border - 1) + 1;  // npos + 1 is the begin of the line
    const std::string_view whole =
        line_.substr(first, std::min(line_.find(' ', border), line_.size()) - first);
    double real = 0.0;
    if (parse_real(whole, real) == NumberState::good) return true;
  }
  return false;
}

bool FieldCutter::cut_at_blanks() {
  if (comma_ || count_ == 0 || is_long_text(fields_[count_ - 1])) return false;
  std::vector<std::string_view> values;
  bool own_columns = true;
  for (std::size_t at = line_.find_first_not_of(' '); at != std::string_view::npos;
       at = line_.find_first_not_of(' ', at)) {
    const std::size_t k = values.size(), stop = std::min(line_.find(' ', at), line_.size());
    if (k == count_ || fields_[k].comma != k) return false;
    const std::string_view value = line_.substr(at, stop - at);
    double real = 0.0;
    std::int64_t integer = 0;
    if (fields_[k].type == 'F' && parse_real(value, real) != NumberState::good) return false;
    if (fields_[k].type == 'I' && parse_integer(value, integer) != NumberState::good) return false;
    const Columns columns = columns_of(fields_[k], format_);
    own_columns = own_columns && at < columns.offset + columns.width && stop > columns.offset;
    values.push_back(value);
    at = stop;
  }
  if (values.empty() || (!own_columns && values.size() != count_)) return false;
  comma_ = true;
  pieces_ = std::move(values);
  rest_ = {};
  return true;
}

Slice FieldCutter::slice(std::size_t n) const {
  const table::Field& f = fields_[n];
  if (comma_) {
    if (f.comma >= pieces_.size()) return {{}, static_cast<int>(line_.size()) + 1, 1};
    const std::string_view raw = pieces_[f.comma], value = trim(raw);
    const char* const at = value.empty() ? raw.data() : value.data();
    return {value, static_cast<int>(at - line_.data()) + 1, std::max(1, static_cast<int>(value.size()))};
  }
  const Columns columns = columns_of(f, format_);
  const std::string_view value =
      columns.offset < line_.size() ? trim(line_.substr(columns.offset, columns.width)) : std::string_view();
  return {value, static_cast<int>(columns.offset) + 1, static_cast<int>(columns.width)};
}

void cut_series(std::string_view line, const table::Item& item, Format format, std::size_t wanted,
                const std::function<void(std::size_t position, const Slice& slice)>& take) {
  const std::size_t width = format == Format::wide  ? 20
                            : format == Format::ten ? std::max<std::size_t>(10, item.width)
                                                    : item.width;
  const auto hand_on = [&](std::size_t position, std::string_view raw) {
    const std::string_view value = trim(raw);
    if (value.empty()) return;
    take(position, {value, static_cast<int>(value.data() - line.data()) + 1, static_cast<int>(value.size())});
  };
  if (find_format_comma(line, width * item.per_line) != std::string_view::npos) {
    std::string_view rest = line;
    for (std::size_t position = 0; position < wanted; ++position) {
      const std::size_t comma = find_comma(rest);
      hand_on(position, rest.substr(0, comma));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
  } else {
    const std::size_t most = std::min<std::size_t>(item.per_line, wanted);
    for (std::size_t k = 0; k < most && k * width < line.size(); ++k)
      hand_on(k, line.substr(k * width, width));
  }
}

std::size_t count_values(std::string_view line, const table::Field* fields, std::size_t count,
                         Format format) {
  FieldCutter cutter;
  cutter.cut(line, fields, count, format);
  std::size_t given = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view value = cutter.slice(i).text;
    const bool number = begins_value(value);  // a remark behind the values is none
    if (fields[i].type != 'A' ? number : !value.empty()) given = i + 1;
  }
  return given;
}

}  // namespace cleave::deck
