#include "results/text.hpp"

#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <ctime>

namespace cleave::results {

void append_shortest(std::string& out, double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  out.append(digits, end);
}

void append_format(std::string& out, const char* format, ...) {
  char line[512];
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int size = std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  if (size >= static_cast<int>(sizeof line)) {
    std::string whole(static_cast<std::size_t>(size) + 1, '\0');
    std::vsnprintf(whole.data(), whole.size(), format, again);
    out.append(whole, 0, static_cast<std::size_t>(size));
  } else if (size > 0) {
    out.append(line, static_cast<std::size_t>(size));
  }
  va_end(again);
}

double column(double value) {
  return std::fabs(value) < 1.0e-99 ? 0.0 : value;
}

std::string duration(double seconds) {
  std::string out;
  if (!std::isfinite(seconds) || seconds < 0.0) return "?";
  const long whole = std::lround(seconds);
  if (seconds < 60.0)
    append_format(out, "%.1f s", seconds);
  else if (whole < 3600)
    append_format(out, "%ldm %02lds", whole / 60, whole % 60);
  else
    append_format(out, "%ldh %02ldm", whole / 3600, whole % 3600 / 60);
  return out;
}

std::string count_text(double value) {
  std::string out;
  if (value >= 1.0e9)
    append_format(out, "%.2f billion", value * 1.0e-9);
  else if (value >= 1.0e6)
    append_format(out, "%.2f million", value * 1.0e-6);
  else
    append_format(out, "%.0f", value);
  return out;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[16];
  std::strftime(text, sizeof text, "%m/%d/%Y", &local);
  return text;
}

}  // namespace cleave::results
