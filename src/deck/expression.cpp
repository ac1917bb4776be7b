#include "deck/expression.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "deck/number.hpp"

namespace cleave::deck {
namespace {

constexpr int deepest = 200;
constexpr std::size_t most_arguments = 64;

struct Failure {
  std::string message;
  std::size_t position;
};

bool is_name_start(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Recursive descent; a failure is remembered once and unwinds by returning zero.
class Parser {
 public:
  Parser(std::string_view text, const NameLookup& lookup) : text_(text), lookup_(lookup) {}

  ExpressionResult run() {
    ExpressionResult result;
    result.value = sum(0);
    skip_blanks();
    if (!failure_ && at_ < text_.size()) fail("an operator was expected");
    if (!failure_ && !result.value.is_integer && !std::isfinite(result.value.real))
      fail("the result is not a finite number");
    if (failure_) {
      result.value = Number::of(std::int64_t{0});
      result.error = failure_->message;
      result.position = failure_->position;
    }
    result.truncated_division = truncated_;
    return result;
  }

 private:
  Number fail(std::string message) {
    if (!failure_) failure_ = Failure{std::move(message), std::min(at_, text_.size())};
    at_ = text_.size();
    return Number::of(std::int64_t{0});
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }

  bool take(std::string_view symbol) {
    skip_blanks();
    if (text_.substr(at_, symbol.size()) != symbol) return false;
    if (symbol == "*" && text_.substr(at_, 2) == "**") return false;
    at_ += symbol.size();
    return true;
  }

  Number sum(int depth) {
    if (depth > deepest) return fail("the expression is nested too deeply");
    Number left;
    if (take("-"))
      left = negative(product(depth));
    else
      left = (take("+"), product(depth));
    while (!failure_) {
      if (take("+"))
        left = add(left, product(depth));
      else if (take("-"))
        left = add(left, negative(product(depth)));
      else
        break;
    }
    return left;
  }

  Number product(int depth) {
    Number left = power(depth);
    while (!failure_) {
      if (take("*"))
        left = multiply(left, power(depth));
      else if (take("/"))
        left = divide(left, power(depth));
      else
        break;
    }
    return left;
  }

  /// `a ** b ** c` is `a ** (b ** c)`; a sign may stand before the exponent.
  Number power(int depth) {
    if (depth > deepest) return fail("the expression is nested too deeply");
    const Number base = operand(depth);
    if (failure_ || !take("**")) return base;
    const bool minus = take("-");
    if (!minus) take("+");
    Number exponent = power(depth + 1);
    if (minus) exponent = negative(exponent);
    return raise(base, exponent);
  }

  Number operand(int depth) {
    skip_blanks();
    if (at_ == text_.size()) return fail("the expression ends too early");
    const char c = text_[at_];
    if (c == '(') {
      ++at_;
      const Number inner = sum(depth + 1);
      if (!failure_ && !take(")")) return fail("a closing parenthesis was expected");
      return inner;
    }
    if (is_digit(c) || c == '.') return literal();
    if (c == '-' || c == '+') {  // after an operator, as in 2*-3
      ++at_;
      const Number inner = depth < deepest ? operand(depth + 1) : fail("the expression is nested too deeply");
      return c == '-' ? negative(inner) : inner;
    }
    const bool marked = c == '&';
    if (marked) ++at_;
    if (at_ == text_.size() || !is_name_start(text_[at_])) return fail("a number, a name or ( was expected");
    const std::size_t start = at_;
    while (at_ < text_.size() && is_name(text_[at_])) ++at_;
    const std::string_view name = text_.substr(start, at_ - start);
    if (!marked && take("(")) return call(name, depth);
    Number value;
    std::string error;
    if (lookup_(name, value, error)) return value;
    at_ = start;
    return fail(std::move(error));
  }

  Number literal() {
    const std::size_t start = at_;
    bool real = false;
    while (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) real |= text_[at_++] == '.';
    if (at_ < text_.size() && std::string_view("eEdD").find(text_[at_]) != std::string_view::npos) {
      std::size_t next = at_ + 1;
      if (next < text_.size() && (text_[next] == '+' || text_[next] == '-')) ++next;
      if (next < text_.size() && is_digit(text_[next])) {
        real = true;
        at_ = next;
        while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
      }
    }
    const std::string_view word = text_.substr(start, at_ - start);
    Number value;
    const NumberState state = real ? parse_real(word, value.real) : parse_integer(word, value.integer);
    if (state == NumberState::good) return real ? Number::of(value.real) : Number::of(value.integer);
    at_ = start;
    return fail("'" + std::string(word) + "' is not a number");
  }

  Number call(std::string_view written, int depth) {
    std::string name(written);
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::vector<Number> arguments;
    do {
      arguments.push_back(sum(depth + 1));
      if (failure_) return arguments.front();
      if (arguments.size() > most_arguments) return fail("too many arguments");
    } while (take(","));
    if (!take(")")) return fail("a closing parenthesis was expected");
    return apply(name, arguments);
  }

  Number apply(const std::string& name, const std::vector<Number>& arguments);

  Number negative(Number a) {
    if (!a.is_integer) return Number::of(-a.real);
    if (a.integer == std::numeric_limits<std::int64_t>::min()) return fail("integer overflow");
    return Number::of(-a.integer);
  }

  Number add(Number a, Number b) {
    if (!a.is_integer || !b.is_integer) return Number::of(a.real + b.real);
    std::int64_t result = 0;
    return __builtin_add_overflow(a.integer, b.integer, &result) ? fail("integer overflow")
                                                                 : Number::of(result);
  }

  Number multiply(Number a, Number b) {
    if (!a.is_integer || !b.is_integer) return Number::of(a.real * b.real);
    std::int64_t result = 0;
    return __builtin_mul_overflow(a.integer, b.integer, &result) ? fail("integer overflow")
                                                                 : Number::of(result);
  }

  Number divide(Number a, Number b) {
    if (b.real == 0.0) return fail("division by zero");
    if (!a.is_integer || !b.is_integer) return Number::of(a.real / b.real);
    if (b.integer == -1) return negative(a);
    truncated_ |= a.integer % b.integer != 0;
    return Number::of(a.integer / b.integer);
  }

  Number raise(Number base, Number exponent) {
    if (failure_) return base;
    if (base.is_integer && exponent.is_integer) {
      if (exponent.integer < 0) {  // the reciprocal, truncated
        if (base.integer == 0) return fail("division by zero");
        if (base.integer == 1) return base;
        if (base.integer == -1)
          return Number::of(exponent.integer % 2 == 0 ? std::int64_t{1} : std::int64_t{-1});
        truncated_ = true;
        return Number::of(std::int64_t{0});
      }
      Number result = Number::of(std::int64_t{1});
      std::int64_t left = exponent.integer;
      for (Number square = base; left > 0 && !failure_; left /= 2) {  // repeated squaring
        if (left % 2 == 1) result = multiply(result, square);
        if (left > 1) square = multiply(square, square);
      }
      return result;
    }
    const double result = std::pow(base.real, exponent.real);
    return std::isnan(result) ? fail("a negative number has no real power") : Number::of(result);
  }

  std::string_view text_;
  const NameLookup& lookup_;
  std::size_t at_ = 0;
  bool truncated_ = false;
  std::optional<Failure> failure_;
};

struct RealFunction {
  const char* name;
  double (*value)(double);
};

constexpr RealFunction real_functions[] = {
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"sinh", [](double x) { return std::sinh(x); }},
    {"cosh", [](double x) { return std::cosh(x); }},
    {"tanh", [](double x) { return std::tanh(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"log10", [](double x) { return std::log10(x); }},
    {"float", [](double x) { return x; }},
    {"real", [](double x) { return x; }},
};

Number Parser::apply(const std::string& name, const std::vector<Number>& a) {
  const bool all_integer = std::all_of(a.begin(), a.end(), [](const Number& n) { return n.is_integer; });
  const auto needs = [&](std::size_t count) {
    if (a.size() != count)
      fail(name + " takes " + std::to_string(count) + (count == 1 ? " value" : " values"));
    return a.size() == count;
  };
  for (const RealFunction& f : real_functions) {
    if (name != f.name) continue;
    if (!needs(1)) return a.front();
    const double result = f.value(a[0].real);
    return std::isfinite(result) ? Number::of(result) : fail(name + " has no finite value there");
  }
  if (name == "min" || name == "max") {
    const auto less = [](const Number& x, const Number& y) { return x.real < y.real; };
    const Number best = name == "min" ? *std::min_element(a.begin(), a.end(), less)
                                      : *std::max_element(a.begin(), a.end(), less);
    return all_integer ? best : Number::of(best.real);
  }
  if (name == "abs") return !needs(1) ? a[0] : a[0].real < 0.0 ? negative(a[0]) : a[0];
  if (name == "atan2") return needs(2) ? Number::of(std::atan2(a[0].real, a[1].real)) : a[0];
  if (name == "int" || name == "nint") {
    if (!needs(1) || a[0].is_integer) return a[0];
    const double whole = name == "int" ? std::trunc(a[0].real) : std::round(a[0].real);
    if (!(std::fabs(whole) < 9.2e18)) return fail("integer overflow");
    return Number::of(static_cast<std::int64_t>(whole));
  }
  if (name == "mod") {
    if (!needs(2)) return a[0];
    if (a[1].real == 0.0) return fail("division by zero");
    if (!all_integer) return Number::of(std::fmod(a[0].real, a[1].real));
    return Number::of(a[1].integer == -1 ? std::int64_t{0} : a[0].integer % a[1].integer);
  }
  if (name == "sign") {  // magnitude of the first, sign of the second
    if (!needs(2)) return a[0];
    const bool flip = std::signbit(a[0].real) != std::signbit(a[1].real);
    return flip && (a[0].real != 0.0 || !a[0].is_integer) ? negative(a[0]) : a[0];
  }
  return fail("there is no function " + name);
}

}  // namespace

ExpressionResult evaluate(std::string_view text, const NameLookup& lookup) {
  return Parser(text, lookup).run();
}

}  // namespace cleave::deck
