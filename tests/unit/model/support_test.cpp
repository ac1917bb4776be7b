/// What the program says it honours is what build() does.

#include "model/support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "deck/layout.hpp"
#include "deck_text.hpp"
#include "model/keyword/handler.hpp"

namespace cleave::model {
namespace {

using Use = FieldSupport::Use;

Use use_of(std::string_view keyword, std::string_view field) {
  const auto support = support_of(keyword);
  const auto at = std::find_if(support.fields.begin(), support.fields.end(),
                               [&](const auto& f) { return f.name == field; });
  EXPECT_NE(at, support.fields.end()) << keyword << " " << field;
  return at == support.fields.end() ? Use::refused : at->use;
}

TEST(Support, OfFields) {
  EXPECT_EQ(use_of("CONTROL_TIMESTEP", "TSSFAC"), Use::honoured);
  EXPECT_EQ(use_of("CONTROL_TIMESTEP", "IMSCL"), Use::refused);
  EXPECT_EQ(use_of("CONTROL_SOLID", "FMATRX"), Use::harmless);
  EXPECT_EQ(use_of("MAT_ELASTIC", "DA"), Use::harmless);
  EXPECT_EQ(use_of("MAT_MOONEY-RIVLIN_RUBBER", "SGL"), Use::refused);
  EXPECT_EQ(use_of("MAT_ELASTIC", "RO"), Use::honoured);
  EXPECT_EQ(use_of("MAT_ADD_EROSION", "SIGP1"), Use::honoured);
}

TEST(Support, OfKeywords) {
  EXPECT_EQ(support_of("NODE").policy, Account::Policy::honoured);
  EXPECT_EQ(support_of("CONTROL_TIMESTEP").policy, Account::Policy::in_part);
  EXPECT_EQ(support_of("CONTACT_AUTOMATIC_GENERAL").policy, Account::Policy::refused);
  EXPECT_EQ(support_of("MAT_HONEYCOMB").policy, Account::Policy::refused);
  EXPECT_EQ(support_of("DATABASE_SBTOUT").policy, Account::Policy::output_only);
  EXPECT_EQ(support_of("NO_SUCH_THING").policy, Account::Policy::unknown);
  EXPECT_FALSE(support_of("MAT_PLASTIC_KINEMATIC").source.empty());
}

/// Keywords share lists of names, so each name must be a field of at least one keyword with that list.
TEST(Support, ListsNameFieldsOfTheCardTable) {
  std::map<std::string_view, std::set<std::string>> fields_by_list;
  for (const Family* family : families())
    for (const Handler& handler : *family)
      for (const auto list : {handler.honoured, handler.harmless})
        for (const std::string_view keyword : deck::known_keywords())
          if (find_handler(keyword) == &handler)
            for (const auto& field : deck::fields_of(keyword)) {
              fields_by_list[list].insert(std::string(field.name));
              fields_by_list[list].insert(std::string(field.name.substr(0, field.name.find('/'))));
            }
  for (const auto& [list, fields] : fields_by_list) {
    std::istringstream words{std::string(list)};
    for (std::string name; words >> name;)
      if (name != "*") {
        EXPECT_TRUE(fields.contains(name)) << name << " in: " << list;
      }
  }
}

TEST(Support, EveryRefusedKeywordSaysWhatToDo) {
  for (const std::string_view keyword : deck::known_keywords()) {
    const auto support = support_of(keyword);
    if (support.policy == Account::Policy::refused) {
      EXPECT_FALSE(support.remark.empty()) << keyword;
    }
  }
}

}  // namespace
}  // namespace cleave::model
