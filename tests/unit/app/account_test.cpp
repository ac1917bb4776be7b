/// The table of how the keywords of a deck were taken.

#include "app/account.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/embedded_examples.hpp"

namespace cleave::app {
namespace {

using Policy = model::Account::Policy;

TEST(AccountTable, SaysEverythingOfEveryKeyword) {
  model::Account account;
  account.entries.push_back({"NODE", Policy::honoured, 12, 3, {}, ""});
  account.entries.push_back({"PART", Policy::in_part, 1, 0, {"TMID", "GRAV"}, ""});
  account.entries.push_back({"MAT_RIGID", Policy::refused, 1, 0, {}, "no such law"});
  const std::string text = table_of(account);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);  // a heading and a line each
  EXPECT_NE(text.find("NODE                                         12          3  honoured\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("in part; not honoured: TMID GRAV\n"), std::string::npos) << text;
  EXPECT_NE(text.find("REFUSED; no such law\n"), std::string::npos) << text;
}

TEST(AccountTable, IsEmptyForAnEmptyAccount) {
  EXPECT_EQ(table_of({}), "");
}

TEST(AccountTable, EveryPolicyHasItsWord) {
  std::vector<std::string> words;
  for (const Policy policy :
       {Policy::honoured, Policy::in_part, Policy::output_only, Policy::refused, Policy::unknown})
    words.emplace_back(word_for(policy));
  std::sort(words.begin(), words.end());
  EXPECT_EQ(std::unique(words.begin(), words.end()), words.end());
  EXPECT_FALSE(words.front().empty());
}

TEST(Examples, AreCarriedInTheProgram) {
  const auto examples = embedded_examples();
  const auto taylor =
      std::find_if(examples.begin(), examples.end(), [](const Example& e) { return e.name == "taylor"; });
  ASSERT_NE(taylor, examples.end());
  EXPECT_NE(taylor->text.find("*KEYWORD"), std::string_view::npos);
  EXPECT_NE(taylor->text.find("*END"), std::string_view::npos);
}

}  // namespace
}  // namespace cleave::app
