#pragma once
/// Deck text in comma format: every number with as many digits as bring its bits back.

#include <initializer_list>
#include <string>
#include <string_view>

#include "deck/write.hpp"
#include "model/mesh.hpp"

namespace cleave::model {

/// One value of a line: an integer, a real in shortest round-trip form, a word, or a blank.
class Value {
 public:
  Value(std::string_view word) : text_(word) {}     // NOLINT: values are listed in braces
  Value(const char* word) : text_(word) {}          // NOLINT
  Value(double v) { deck::append_real(text_, v); }  // NOLINT
  Value(int v) : text_(std::to_string(v)) {}        // NOLINT
  Value(Id v) : text_(std::to_string(v)) {}         // NOLINT
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

class DeckText {
 public:
  /// Starts a keyword; with a title the option _TITLE and its line are added.
  void keyword(std::string_view name, std::string_view title = {}) {
    (text_ += '*') += name;
    if (!title.empty()) text_ += "_TITLE";
    text_ += '\n';
    if (!title.empty()) text(title);
  }
  void text(std::string_view line) { (text_ += line) += '\n'; }
  void lines(const std::string& whole) { text_ += whole; }
  void line(std::initializer_list<Value> values) {
    for (const Value* v = values.begin(); v != values.end(); ++v) {
      if (v != values.begin()) text_ += ',';
      text_ += v->text();
    }
    text_ += '\n';
  }
  /// Number and title of an _ID line, which has fixed columns because titles may hold commas.
  void id_line(Id id, std::string_view title) {
    std::string number = std::to_string(id);
    text_.append(number.size() < 10 ? 10 - number.size() : 0, ' ');
    ((text_ += number) += title) += '\n';
  }
  /// Ids, eight a line.
  template <class Range, class Number>
  void ids(const Range& range, const Number& number) {
    std::size_t k = 0;
    for (const auto& item : range) {
      text_ += std::to_string(number(item));
      text_ += ++k % 8 == 0 ? '\n' : ',';
    }
    if (k % 8 != 0) text_.back() = '\n';
    if (k == 1) text_.insert(text_.size() - 1, ",");  // a comma tells free format from columns
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

}  // namespace cleave::model
