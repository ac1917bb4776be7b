#include "deck/expression.hpp"

#include <cmath>

#include "reading.hpp"

namespace cleave::deck {
namespace {

ExpressionResult run(const std::string& text) {
  return evaluate(text, [](std::string_view name, Number& value, std::string& error) {
    if (name == "i")
      value = Number::of(std::int64_t{7});
    else if (name == "x")
      value = Number::of(2.5);
    else
      error = "unknown " + std::string(name);
    return error.empty();
  });
}
double real(const std::string& text) {
  const ExpressionResult r = run(text);
  EXPECT_EQ(r.error, "") << text;
  EXPECT_FALSE(r.value.is_integer) << text;
  return r.value.real;
}
std::int64_t integer(const std::string& text) {
  const ExpressionResult r = run(text);
  EXPECT_EQ(r.error, "") << text;
  EXPECT_TRUE(r.value.is_integer) << text;
  return r.value.integer;
}
std::string error(const std::string& text) {
  return run(text).error;
}

TEST(Expression, PrecedenceIsFortrans) {
  EXPECT_EQ(integer("2+3*4"), 14);
  EXPECT_EQ(integer("(2+3)*4"), 20);
  EXPECT_EQ(integer("-2**2"), -4);
  EXPECT_EQ(integer("2**3**2"), 512);
  EXPECT_EQ(real("2.**-1"), 0.5);
  EXPECT_EQ(integer("10-4-3"), 3);
  EXPECT_EQ(real("8./4./2."), 1.0);
  EXPECT_EQ(integer(" 2 * -3 "), -6);
}

TEST(Expression, IntegersDivideAsInFortran) {
  EXPECT_EQ(integer("7/2"), 3);
  EXPECT_EQ(integer("-7/2"), -3);
  EXPECT_TRUE(run("7/2").truncated_division);
  EXPECT_FALSE(run("8/2").truncated_division);
  EXPECT_EQ(real("7./2"), 3.5);
  EXPECT_EQ(integer("i/2"), 3);
  EXPECT_EQ(real("x/2"), 1.25);
  EXPECT_EQ(integer("2**-1"), 0);
  EXPECT_EQ(integer("mod(7,4)"), 3);
  EXPECT_EQ(integer("mod(-7,4)"), -3);
}

TEST(Expression, NamesWithAndWithoutMark) {
  EXPECT_EQ(real("&x+i"), 9.5);
  EXPECT_EQ(real("x*&x"), 6.25);
  EXPECT_EQ(error("y+1"), "unknown y");
  EXPECT_EQ(run("1+ y").position, 3u);
}

TEST(Expression, Functions) {
  EXPECT_DOUBLE_EQ(real("sqrt(2.0)**2"), 2.0);
  EXPECT_EQ(real("atan2(1.,1)*4"), std::atan2(1.0, 1.0) * 4.0);
  EXPECT_EQ(integer("max(1,5,3)"), 5);
  EXPECT_EQ(real("min(1,5.0)"), 1.0);
  EXPECT_EQ(integer("int(2.9)"), 2);
  EXPECT_EQ(integer("int(-2.9)"), -2);
  EXPECT_EQ(integer("nint(2.5)"), 3);
  EXPECT_EQ(integer("abs(-4)"), 4);
  EXPECT_EQ(real("sign(3.0,-1)"), -3.0);
  EXPECT_EQ(real("log10(1000.)"), 3.0);
  EXPECT_EQ(real("1.5d3"), 1500.0);
  EXPECT_EQ(real("EXP(0.)"), 1.0);
}

TEST(Expression, Failures) {
  for (const char* text : {"",         "1+",        "(1",         "1)",
                           "sqrt(-1)", "1/0",       "2**",        "foo(1)",
                           "max()",    "sqrt(1,2)", "1..2",       "9223372036854775807+1",
                           "2**64",    "0**-1",     "(-8.)**0.5", "&",
                           "1 2",      "log(0)",    "int(1e30)",  "-9223372036854775807-2"}) {
    EXPECT_NE(error(text), "") << text;
  }
}

TEST(Expression, DeepNestingIsAnErrorNotACrash) {
  EXPECT_NE(error(std::string(100000, '(') + "1"), "");
  EXPECT_NE(error(std::string(100000, '-') + "1"), "");
  std::string powers = "2";
  for (int i = 0; i < 100000; ++i) powers += "**1";
  EXPECT_NE(error(powers), "");
  std::string sum = "1";
  for (int i = 0; i < 100000; ++i) sum += "+1";
  EXPECT_EQ(integer(sum), 100001);
}

TEST(Expression, InAField) {
  Reading r("*PARAMETER\nR gap          0.5\n*MAT_ELASTIC\n1,<12.5+2*gap>,<max(1.,2.)>,0.3\n");
  const Card card = r.card("MAT_ELASTIC");
  EXPECT_EQ(card.real("RO"), 13.5);
  EXPECT_EQ(card.real("E"), 2.0) << "a comma inside <> parts no fields";
  EXPECT_EQ(card.real("PR"), 0.3);
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
  Reading whole("*MAT_ELASTIC\n<3/2>,1.\n");
  EXPECT_EQ(whole.card("MAT_ELASTIC").integer("MID"), 1);
  EXPECT_TRUE(whole.says("remainder is dropped"));
  Reading open("*MAT_ELASTIC\n1,<2+3\n");
  open.read_all();
  EXPECT_TRUE(open.says("without its closing '>'")) << open.rendered();
}

}  // namespace
}  // namespace cleave::deck
