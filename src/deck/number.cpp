#include "deck/number.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace cleave::deck {
namespace {

constexpr double powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}

/// The rare numbers: more digits than 64 bits hold, or large exponents. Correct rounding by the library.
NumberState parse_long(std::string_view mantissa, std::int64_t exponent, bool negative, double& value) {
  std::string plain(mantissa);
  plain += 'e';
  plain += std::to_string(exponent);
  double result = 0.0;
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), result);
  if (error == std::errc::result_out_of_range) {
    // Too small counts as zero, too large is an error: the decimal magnitude tells which.
    std::int64_t magnitude = exponent, leading = 0;
    bool significant = false, fraction = false;
    for (const char c : mantissa) {
      if (c == '.')
        fraction = true;
      else if (significant || c != '0')
        significant = true, magnitude += fraction ? 0 : 1;
      else if (fraction)
        ++leading;
    }
    if (magnitude - leading > 0) return NumberState::out_of_range;
    result = 0.0;
  } else if (error != std::errc() || end != plain.data() + plain.size()) {
    return NumberState::malformed;
  }
  value = negative ? -result : result;
  return NumberState::good;
}

}  // namespace

NumberState parse_real(std::string_view text, double& value) {
  const char *at = text.data(), *const end = at + text.size();
  bool negative = false;
  if (at != end && (*at == '-' || *at == '+')) negative = *at++ == '-';

  // Mantissa: 19 digits always fit 64 bits; the scale counts digits behind the point.
  const char* const mantissa = at;
  std::uint64_t digits = 0;
  int digit_count = 0, significant = 0, scale = 0;
  bool point = false;
  for (; at != end; ++at) {
    if (is_digit(*at)) {
      ++digit_count;
      if (significant > 0 || *at != '0') ++significant;
      if (significant <= 19) digits = digits * 10 + static_cast<std::uint64_t>(*at - '0');
      if (point) ++scale;
    } else if (*at == '.' && !point) {
      point = true;
    } else {
      break;
    }
  }
  if (digit_count == 0) return NumberState::malformed;
  const std::string_view mantissa_text(mantissa, static_cast<std::size_t>(at - mantissa));

  // Exponent: E or D, or only a sign.
  std::int64_t exponent = 0;
  if (at != end) {
    const char c = *at;
    bool sign_needed = true;
    if (c == 'e' || c == 'E' || c == 'd' || c == 'D') ++at, sign_needed = false;
    bool minus = false;
    if (at != end && (*at == '-' || *at == '+'))
      minus = *at++ == '-';
    else if (sign_needed)
      return NumberState::malformed;
    if (at == end) return NumberState::malformed;
    for (; at != end && is_digit(*at); ++at) {
      if (exponent < 1000000) exponent = exponent * 10 + (*at - '0');
    }
    if (at != end) return NumberState::malformed;
    if (minus) exponent = -exponent;
  }

  // Both factors exact: one rounding, so the result is the nearest double.
  const std::int64_t power = exponent - scale;
  if (significant <= 19 && digits <= (std::uint64_t{1} << 53) && power >= -22 && power <= 22) {
    const double m = static_cast<double>(digits);
    const double result = power < 0 ? m / powers_of_ten[-power] : m * powers_of_ten[power];
    value = negative ? -result : result;
    return NumberState::good;
  }
  if (digits == 0 && significant == 0) {
    value = negative ? -0.0 : 0.0;
    return NumberState::good;
  }
  return parse_long(mantissa_text, exponent, negative, value);
}

NumberState parse_integer(std::string_view text, std::int64_t& value) {
  const char *at = text.data(), *const end = at + text.size();
  bool negative = false;
  if (at != end && (*at == '-' || *at == '+')) negative = *at++ == '-';
  if (end - at >= 1 && end - at <= 18) {  // the common case: plain digits that fit
    std::int64_t result = 0;
    const char* p = at;
    for (; p != end && is_digit(*p); ++p) result = result * 10 + (*p - '0');
    if (p == end) {
      value = negative ? -result : result;
      return NumberState::good;
    }
  }
  const std::string_view unsigned_text(at, static_cast<std::size_t>(end - at));
  if (unsigned_text.find_first_not_of("0123456789") == std::string_view::npos && !unsigned_text.empty()) {
    std::int64_t result = 0;
    const char* const begin = negative ? text.data() : at;
    const auto [stop, error] = std::from_chars(begin, end, result);
    if (error != std::errc() || stop != end) return NumberState::out_of_range;
    value = result;
    return NumberState::good;
  }
  double real = 0.0;
  const NumberState state = parse_real(text, real);
  if (state != NumberState::good) return state;
  if (real != std::floor(real)) return NumberState::not_whole;
  if (std::fabs(real) >= 9.2e18) return NumberState::out_of_range;
  value = static_cast<std::int64_t>(real);
  return NumberState::good;
}

}  // namespace cleave::deck
