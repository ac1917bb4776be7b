#pragma once
/// What is honoured of a keyword, straight from the tables that build() works by. For `explain` and the
/// manual.

#include <string>
#include <string_view>
#include <vector>

#include "model/model.hpp"

namespace cleave::model {

struct FieldSupport {
  enum class Use { honoured, harmless, refused };  ///< harmless: read, without influence on what is computed
  std::string name;
  Use use = Use::refused;
  std::string dimension;              ///< of laws only, e.g. "stress"
  double low = -1e300, high = 1e300;  ///< admissible range, laws only
  bool required = false;              ///< laws only
};

struct KeywordSupport {
  Account::Policy policy = Account::Policy::unknown;
  std::string remark;                ///< what to do instead, or a restriction
  std::string source;                ///< of laws: paper and equation
  std::vector<FieldSupport> fields;  ///< every named field of the card table, in its order
};

/// @param keyword canonical name. An unknown one gives policy `unknown` and no fields.
KeywordSupport support_of(std::string_view keyword);

}  // namespace cleave::model
