#include <cstdio>
#include <string>

#include "app/account.hpp"
#include "app/commands.hpp"
#include "deck/layout.hpp"
#include "model/support.hpp"

namespace cleave::app {
namespace {

/// Which fields are honoured, in the words of the tables that build() works by.
void print_support(const model::KeywordSupport& support) {
  using Use = model::FieldSupport::Use;
  const auto list = [&](Use use, const char* heading) {
    std::string line;
    for (const model::FieldSupport& field : support.fields)
      if (field.use == use)
        line += " " + field.name + (field.dimension.empty() ? "" : " [" + field.dimension + "]");
    if (!line.empty()) std::printf("%s%s\n", heading, line.c_str());
  };
  std::printf("\nThis program: %s%s%s\n", word_for(support.policy), support.remark.empty() ? "" : "; ",
              support.remark.c_str());
  list(Use::honoured, "honoured:      ");
  list(Use::harmless, "no influence:  ");
  list(Use::refused, "refused:       ");
  if (!support.source.empty()) std::printf("source:        %s\n", support.source.c_str());
}

}  // namespace

int explain(const Options& options) {
  std::string written = options.keyword;
  if (!written.empty() && written[0] == '*') written.erase(0, 1);
  const std::string_view keyword = deck::canonical_keyword(written);
  if (keyword.empty()) {
    const std::string_view near = deck::nearest_keyword(written);
    std::fprintf(stderr, "cleave: no keyword *%s is known%s%.*s%s\n", written.c_str(),
                 near.empty() ? "" : "; did you mean *", static_cast<int>(near.size()), near.data(),
                 near.empty() ? "" : "?");
    return bad_usage;
  }
  std::fputs(deck::describe(keyword).c_str(), stdout);
  print_support(model::support_of(keyword));
  return done;
}

}  // namespace cleave::app
