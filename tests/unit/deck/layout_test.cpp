#include "deck/layout.hpp"

#include <set>

#include "deck/keyword_name.hpp"
#include "deck/layout_table.hpp"
#include "reading.hpp"

namespace cleave::deck {
namespace {

TEST(Layout, FieldsHaveNamesColumnsAndDefaults) {
  const auto fields = fields_of("MAT_PLASTIC_KINEMATIC");
  ASSERT_GE(fields.size(), 11u);
  const auto find = [&](std::string_view name) {
    for (const FieldLayout& f : fields) {
      if (f.name == name) return f;
    }
    ADD_FAILURE() << name;
    return fields[0];
  };
  EXPECT_EQ(find("MID").type, 'I');
  EXPECT_EQ(find("E").offset, 20);
  EXPECT_EQ(find("E").width, 10);
  EXPECT_TRUE(fields_of("NOT_A_KEYWORD").empty());
}

TEST(Layout, NodeAndElementColumns) {
  const auto node = fields_of("NODE");
  const std::vector<std::pair<int, int>> expected{{0, 8}, {8, 16}, {24, 16}, {40, 16}, {56, 8}, {64, 8}};
  ASSERT_EQ(node.size(), expected.size());
  for (std::size_t i = 0; i < node.size(); ++i) {
    EXPECT_EQ(node[i].offset, expected[i].first);
    EXPECT_EQ(node[i].width, expected[i].second);
  }
  EXPECT_EQ(fields_of("ELEMENT_SHELL")[9].offset, 72);
  EXPECT_EQ(fields_of("ELEMENT_DISCRETE")[5].width, 16);
}

/// No keyword names one column twice in one line, every width is positive, and columns rise.
TEST(Layout, TableIsConsistent) {
  for (const table::Keyword& k : table::keywords()) {
    for (std::size_t i = 0; i < k.field_count; ++i) {
      const table::Field& f = table::field(k, i);
      EXPECT_GT(f.width, 0) << k.name << " " << f.name;
      EXPECT_TRUE(f.type == 'I' || f.type == 'F' || f.type == 'A') << k.name << " " << f.name;
      EXPECT_GE(f.width10, f.width) << k.name << " " << f.name;
    }
    for (std::uint16_t i = k.first_item; i < k.first_item + k.item_count; ++i) {
      const table::Item& item = *table::item(i);
      std::set<std::string> names;
      for (std::size_t n = 0; n < item.field_count; ++n) {
        const table::Field& f = table::field(k, item.first_field + n);
        EXPECT_TRUE(names.insert(f.name).second) << k.name << " " << f.name;
        if (n == 0) continue;
        const table::Field& before = table::field(k, item.first_field + n - 1);
        EXPECT_GE(f.offset, before.offset + before.width) << k.name << " " << f.name;
        EXPECT_GT(f.comma, before.comma) << k.name << " " << f.name;
      }
    }
  }
}

/// The keywords this issue honours, by name.
TEST(Layout, KnowsWhatTheSolverNeeds) {
  for (const char* name : {"ELEMENT_SOLID",
                           "SECTION_SOLID",
                           "HOURGLASS",
                           "CONTROL_HOURGLASS",
                           "MAT_ELASTIC",
                           "MAT_PLASTIC_KINEMATIC",
                           "MAT_PIECEWISE_LINEAR_PLASTICITY",
                           "MAT_POWER_LAW_PLASTICITY",
                           "MAT_JOHNSON_COOK",
                           "MAT_SIMPLIFIED_JOHNSON_COOK",
                           "EOS_LINEAR_POLYNOMIAL",
                           "EOS_GRUNEISEN",
                           "MAT_MOONEY-RIVLIN_RUBBER",
                           "MAT_BLATZ-KO_RUBBER",
                           "MAT_NULL",
                           "MAT_ADD_EROSION",
                           "PART",
                           "SET_NODE_LIST",
                           "SET_SEGMENT",
                           "SET_PART_LIST",
                           "SET_SOLID",
                           "SET_NODE_GENERAL",
                           "SET_NODE_LIST_GENERATE",
                           "DEFINE_CURVE",
                           "DEFINE_TABLE",
                           "DEFINE_TABLE_2D",
                           "DEFINE_BOX",
                           "DEFINE_COORDINATE_SYSTEM",
                           "DEFINE_COORDINATE_NODES",
                           "DEFINE_COORDINATE_VECTOR",
                           "BOUNDARY_SPC_NODE",
                           "BOUNDARY_SPC_SET",
                           "BOUNDARY_PRESCRIBED_MOTION_NODE",
                           "BOUNDARY_PRESCRIBED_MOTION_SET",
                           "INITIAL_VELOCITY",
                           "INITIAL_VELOCITY_NODE",
                           "INITIAL_VELOCITY_GENERATION",
                           "LOAD_NODE_POINT",
                           "LOAD_NODE_SET",
                           "LOAD_SEGMENT",
                           "LOAD_SEGMENT_SET",
                           "LOAD_BODY_X",
                           "LOAD_BODY_RX",
                           "LOAD_BODY_PARTS",
                           "RIGIDWALL_PLANAR",
                           "RIGIDWALL_PLANAR_FINITE",
                           "RIGIDWALL_PLANAR_MOVING",
                           "RIGIDWALL_PLANAR_FINITE_MOVING",
                           "CONSTRAINED_GLOBAL",
                           "CONSTRAINED_LOCAL",
                           "DAMPING_GLOBAL",
                           "DAMPING_PART_MASS",
                           "DAMPING_PART_STIFFNESS",
                           "BOUNDARY_NON_REFLECTING",
                           "ELEMENT_MASS",
                           "CONTROL_TIMESTEP",
                           "CONTROL_TERMINATION",
                           "CONTROL_BULK_VISCOSITY",
                           "CONTROL_ENERGY",
                           "DATABASE_GLSTAT",
                           "DATABASE_MATSUM",
                           "DATABASE_NODOUT",
                           "DATABASE_ELOUT",
                           "DATABASE_RWFORC",
                           "DATABASE_SPCFORC",
                           "DATABASE_BINARY_D3PLOT",
                           "DATABASE_HISTORY_NODE",
                           "DATABASE_HISTORY_SOLID",
                           "DATABASE_EXTENT_BINARY"}) {
    EXPECT_EQ(canonical_keyword(name), name);
  }
}

TEST(Layout, DescribesAKeywordInWords) {
  const std::string motion = describe("BOUNDARY_PRESCRIBED_MOTION_SET");
  for (const char* words : {"*BOUNDARY_PRESCRIBED_MOTION_SET", "with _ID", "  1-10  NSID",
                            "if |DOF| = 9 or |DOF| = 10 or |DOF| = 11 or VAD = 4", "each set is one entry"}) {
    EXPECT_NE(motion.find(words), std::string::npos) << words << "\n" << motion;
  }
  EXPECT_NE(describe("MAT_PIECEWISE_LINEAR_PLASTICITY").find("also written *MAT_024"), std::string::npos);
  EXPECT_NE(describe("SECTION_SHELL").find("number of values: 2 if NIP = 0, else NIP"), std::string::npos)
      << describe("SECTION_SHELL");
  EXPECT_NE(describe("DEFINE_CURVE").find("repeats up to the next keyword"), std::string::npos);
  EXPECT_NE(describe("CONTACT_AUTOMATIC_SINGLE_SURFACE").find("optional card C"), std::string::npos);
  EXPECT_EQ(describe("NOT_A_KEYWORD"), "");
  for (const std::string_view name : known_keywords()) EXPECT_FALSE(describe(name).empty());
}

/// The layouts have no field between the table's columns in the 10- and 20-column formats: rows read the
/// same.
TEST(Layout, FormatsAgree) {
  const auto read = [](const std::string& text) {
    Reading r(text);
    std::vector<std::int64_t> values;
    r.deck.rows(r.block("ELEMENT_SOLID"), r.diagnostics, [&](const Row& row) {
      for (int i = 0; i < 12; ++i) values.push_back(row.integer(i));
    });
    EXPECT_EQ(r.errors(), 0u) << r.rendered();
    return values;
  };
  std::string plain = "*ELEMENT_SOLID\n", ten = "*ELEMENT_SOLID%\n", wide = "*ELEMENT_SOLID+\n",
              comma = "*ELEMENT_SOLID\n";
  for (int i = 1; i <= 10; ++i) {
    char text[64];
    std::snprintf(text, sizeof text, "%8d", i * 1001), plain += text;
    std::snprintf(text, sizeof text, "%10d", i * 1001), ten += text;
    std::snprintf(text, sizeof text, "%20d", i * 1001), wide += text;
    comma += std::to_string(i * 1001) + ",";
  }
  EXPECT_EQ(read(plain), read(ten));
  EXPECT_EQ(read(plain), read(wide));
  EXPECT_EQ(read(plain), read(comma));
}

}  // namespace
}  // namespace cleave::deck
