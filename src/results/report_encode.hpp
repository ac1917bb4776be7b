#pragma once
/// Text that is safe inside the page: base64 for numbers, JSON for words.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cleave::results {

/// Base64 (RFC 4648) of some bytes.
std::string base64(std::string_view bytes);

/// A JSON string with quotes; `<` is written as an escape, so that no text can end a script element.
std::string json_text(std::string_view text);

/// A JSON number; null where the value is not finite.
std::string json_number(double value);

/// Appends the bytes of an array.
template <class Value>
void append_bytes(std::string& out, const std::vector<Value>& values) {
  out.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
}

}  // namespace cleave::results
