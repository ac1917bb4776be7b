#include "deck/condition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.hpp"

namespace cleave::deck {

double evaluate(const table::Op* code, std::size_t count, const ConditionValues& values) {
  using table::Code;
  double stack[32] = {};
  std::size_t top = 0;
  const auto binary = [&](auto operation) {
    CLEAVE_ASSERT(top >= 2, "a condition of the card table is malformed");
    stack[top - 2] = static_cast<double>(operation(stack[top - 2], stack[top - 1]));
    --top;
  };
  for (const table::Op* op = code; op != code + count; ++op) {
    CLEAVE_ASSERT(top < 31, "a condition of the card table is too deep");
    switch (op->code) {
      case Code::number:
        stack[top++] = op->number;
        break;
      case Code::field:
        stack[top++] = values.number(op->argument);
        break;
      case Code::same_text:
        stack[top++] = values.text(op->argument) == op->word ? 1.0 : 0.0;
        break;
      case Code::line_fields:
        stack[top++] = static_cast<double>(values.next_line_values());
        break;
      case Code::line_starts:
        stack[top++] = values.next_line_starts(op->word) ? 1.0 : 0.0;
        break;
      case Code::rows:
        stack[top++] = static_cast<double>(values.rows(op->argument));
        break;
      case Code::negate:
        stack[top - 1] = -stack[top - 1];
        break;
      case Code::absolute:
        stack[top - 1] = std::fabs(stack[top - 1]);
        break;
      case Code::invert:
        stack[top - 1] = stack[top - 1] == 0.0 ? 1.0 : 0.0;
        break;
      case Code::add:
        binary([](double a, double b) { return a + b; });
        break;
      case Code::subtract:
        binary([](double a, double b) { return a - b; });
        break;
      case Code::multiply:
        binary([](double a, double b) { return a * b; });
        break;
      case Code::divide:
        binary([](double a, double b) { return b == 0.0 ? 0.0 : a / b; });
        break;
      case Code::equal:
        binary([](double a, double b) { return a == b; });
        break;
      case Code::differ:
        binary([](double a, double b) { return a != b; });
        break;
      case Code::less:
        binary([](double a, double b) { return a < b; });
        break;
      case Code::less_equal:
        binary([](double a, double b) { return a <= b; });
        break;
      case Code::greater:
        binary([](double a, double b) { return a > b; });
        break;
      case Code::greater_equal:
        binary([](double a, double b) { return a >= b; });
        break;
      case Code::both:
        binary([](double a, double b) { return a != 0.0 && b != 0.0; });
        break;
      case Code::either:
        binary([](double a, double b) { return a != 0.0 || b != 0.0; });
        break;
      case Code::choose:
        stack[top - 3] = stack[top - 3] != 0.0 ? stack[top - 2] : stack[top - 1];
        top -= 2;
        break;
    }
  }
  return top == 0 ? 0.0 : stack[top - 1];
}

std::size_t repeats(const table::Item& item, const ConditionValues& values) {
  if (item.to_end) return std::numeric_limits<std::size_t>::max();
  if (item.repeat_count == 0) return 1;
  const double count = evaluate(table::code(item.repeat_first), item.repeat_count, values);
  if (!(count > 0.0)) return 0;
  return count < 1e18 ? static_cast<std::size_t>(count) : std::numeric_limits<std::size_t>::max();
}

}  // namespace cleave::deck
