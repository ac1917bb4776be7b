#include "deck/number.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "reading.hpp"

namespace cleave::deck {
namespace {

double real(const std::string& text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  return parse_real(text, value) == NumberState::good ? value : std::numeric_limits<double>::quiet_NaN();
}

TEST(Number, FortranReals) {
  EXPECT_EQ(real("1."), 1.0);
  EXPECT_EQ(real(".52E-02"), 0.52e-2);
  EXPECT_EQ(real("70.e+09"), 70e9);
  EXPECT_EQ(real("7.85000-6"), 7.85e-6);
  EXPECT_EQ(real("2.10000+5"), 2.1e5);
  EXPECT_EQ(real("1.0D-3"), 1e-3);
  EXPECT_EQ(real("-1.5d+2"), -150.0);
  EXPECT_EQ(real("+4"), 4.0);
  EXPECT_EQ(real("1e5"), 1e5);
  EXPECT_TRUE(std::signbit(real("-0.0")));
}

TEST(Number, RejectsWhatIsNone) {
  for (const char* text : {"", "-", ".", "1. E5", "1.0E", "1.0E+", "1.2.3", "abc", "1x", "nan", "inf", "0x10",
                           "1,5", "--1", "1e5.0", "E5", "1-"}) {
    EXPECT_TRUE(std::isnan(real(text))) << text;
  }
}

TEST(Number, RangeOfReals) {
  double value = 7.0;
  EXPECT_EQ(parse_real("1e309", value), NumberState::out_of_range);
  EXPECT_EQ(parse_real("123456789012345678901234567890e300", value), NumberState::out_of_range);
  EXPECT_EQ(value, 7.0);
  EXPECT_EQ(real("1e-400"), 0.0);
  EXPECT_EQ(real("0.0000000000000000000000000000001e-320"), 0.0);
  EXPECT_EQ(real("5e-324"), 5e-324);
  EXPECT_TRUE(std::isnan(real("1e99999999999999999")));
  EXPECT_EQ(real("0e99999999999999999"), 0.0);
}

/// Compares with the C library on many spellings: both must be the nearest double.
TEST(Number, RoundsCorrectly) {
  std::uint64_t seed = 7;
  for (int i = 0; i < 20000; ++i) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    const int digits = 1 + static_cast<int>(seed >> 60);
    const int exponent = static_cast<int>((seed >> 20) % 640) - 320;
    char text[64];
    std::snprintf(text, sizeof text, "%.*s%s%de%d", 0, "", (seed & 1) != 0 ? "-" : "",
                  static_cast<int>(seed >> 33) % 1000, exponent);
    std::string number(text);
    number.insert(number.find('e'), "." + std::to_string(seed).substr(0, static_cast<std::size_t>(digits)));
    const double expected = std::strtod(number.c_str(), nullptr);
    if (std::isinf(expected))
      EXPECT_TRUE(std::isnan(real(number))) << number;
    else
      EXPECT_EQ(real(number), expected) << number;
  }
}

TEST(Number, Integers) {
  std::int64_t value = 0;
  const auto integer = [&](const char* text) { return parse_integer(text, value); };
  EXPECT_EQ(integer("9223372036854775807"), NumberState::good);
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(integer("-9223372036854775808"), NumberState::good);
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(integer("9223372036854775808"), NumberState::out_of_range);
  EXPECT_EQ(integer("0.0"), NumberState::good);
  EXPECT_EQ(value, 0);
  EXPECT_EQ(integer("2.0E3"), NumberState::good);
  EXPECT_EQ(value, 2000);
  EXPECT_EQ(integer("+12"), NumberState::good);
  EXPECT_EQ(value, 12);
  EXPECT_EQ(integer("1.5"), NumberState::not_whole);
  EXPECT_EQ(integer("1e300"), NumberState::out_of_range);
  EXPECT_EQ(integer("12a"), NumberState::malformed);
  EXPECT_EQ(integer("1 2"), NumberState::malformed);
  EXPECT_EQ(integer(""), NumberState::malformed);
}

TEST(Number, MessagesNameWhatWasFound) {
  Reading r("*MAT_ELASTIC\n         1  1.0 E-3     2x7.0       0.3\n");
  r.read_all();
  EXPECT_EQ(r.errors(), 2u);
  EXPECT_TRUE(r.says("MAT_ELASTIC RO found '1.0 E-3', expected a real number")) << r.rendered();
  EXPECT_TRUE(r.says("a number has no blanks inside"));
  EXPECT_TRUE(r.says("MAT_ELASTIC E found '2x7.0'"));
  Reading fraction("*MAT_ELASTIC\n       1.5       1.0\n");
  fraction.read_all();
  EXPECT_TRUE(fraction.says("MID found '1.5', expected an integer")) << fraction.rendered();
}

}  // namespace
}  // namespace cleave::deck
