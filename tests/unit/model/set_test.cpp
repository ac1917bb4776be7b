/// *SET_*: lists, ranges, columns, sums, intersections, general selections, number spaces.

#include <gtest/gtest.h>

#include "deck_text.hpp"

namespace cleave::model {
namespace {

std::vector<Id> node_ids(const Built& b, std::size_t set) {
  std::vector<Id> ids;
  for (const Index i : b.model.node_sets.at(set).members) ids.push_back(b.model.mesh.nodes.id[i]);
  return ids;
}
using Ids = std::vector<Id>;

TEST(Set, ListsPadWithZeros) {
  const Built b = build_text(
      cube + "*SET_NODE_LIST_TITLE\nthe top\n7\n         5         6         0         0\n         7\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.node_sets[0].id, 7);
  EXPECT_EQ(b.model.node_sets[0].title, "the top");
  EXPECT_EQ(node_ids(b, 0), (Ids{5, 6, 7}));
}

TEST(Set, GenerateTakesWhatIsDefinedInTheRange) {
  const Built b = build_text(cube + "*SET_NODE_LIST_GENERATE\n1\n1,3,7,100\n8,8\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(node_ids(b, 0), (Ids{1, 2, 3, 7, 8}));
  EXPECT_TRUE(build_text(cube + "*SET_NODE_LIST_GENERATE\n1\n5,3\n").failed());
}

TEST(Set, ColumnAddAndIntersect) {
  const Built b = build_text(cube +
                             "*SET_NODE_ADD\n1\n2,3\n*SET_NODE_COLUMN\n2\n4\n2\n*SET_NODE_LIST\n3\n2,8\n"
                             "*SET_NODE_INTERSECT\n4\n1,3\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(node_ids(b, 0), (Ids{2, 4, 8}));
  EXPECT_EQ(node_ids(b, 1), (Ids{2, 4}));
  EXPECT_EQ(node_ids(b, 3), (Ids{2, 8}));
}

TEST(Set, ASetOfItselfIsAnError) {
  const Built b = build_text(cube + "*SET_NODE_ADD\n1\n2\n*SET_NODE_ADD\n2\n1\n");
  EXPECT_NE(b.text().find("contains itself"), std::string::npos) << b.text();
}

TEST(Set, GeneralSelectsAndTakesAway) {
  const Built b = build_text(cube +
                             "*NODE\n9,9,9,9\n*DEFINE_BOX\n4,-0.5,0.5,-9,9,-9,9\n"
                             "*SET_NODE_GENERAL\n1\nALL\nDNODE,9\nDBOX,4\n*SET_NODE_GENERAL\n2\nPART,1\n"
                             "*SET_NODE_GENERAL\n3\nNODE,1,9\nBOX,4\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(node_ids(b, 0), (Ids{2, 3, 6, 7}));
  EXPECT_EQ(node_ids(b, 1), (Ids{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(node_ids(b, 2), (Ids{1, 4, 5, 8, 9}));
  EXPECT_TRUE(build_text(cube + "*SET_NODE_GENERAL\n1\nVOL,3\n").failed());
}

TEST(Set, KindsAreNumberedApart) {
  const Built b =
      build_text(cube + "*SET_NODE\n1\n1\n*SET_PART\n1\n1\n*SET_SOLID\n1\n1\n*SET_SEGMENT\n1\n5,6,7,8\n");
  ASSERT_FALSE(b.failed()) << b.text();
  EXPECT_EQ(b.model.part_sets[0].members, (std::vector<Index>{0}));
  EXPECT_EQ(b.model.solid_sets[0].members, (Ids{1}));
  EXPECT_TRUE(build_text(cube + "*SET_NODE\n1\n1\n*SET_NODE\n1\n2\n").failed());
}

TEST(Set, SegmentsReadTrianglesBothWays) {
  const Built b =
      build_text(cube + "*SET_SEGMENT\n1\n5,6,7,7\n5,7,8\n*SET_SEGMENT_GENERAL\n2\nPART,1\nDSEG,1,2,3,4\n");
  ASSERT_FALSE(b.failed()) << b.text();
  const auto& s = b.model.segment_sets[0].members;
  ASSERT_EQ(s.size(), 2u);
  EXPECT_EQ(s[1].node[3], s[1].node[2]);
  EXPECT_EQ(b.model.segment_sets[1].members.size(), 5u);
}

TEST(Set, MissingMembersAreNamed) {
  EXPECT_NE(build_text(cube + "*SET_NODE\n1\n77\n").text().find("node 77"), std::string::npos);
  EXPECT_NE(build_text(cube + "*SET_PART\n1\n77\n").text().find("part 77"), std::string::npos);
  EXPECT_NE(build_text(cube + "*SET_SOLID\n1\n77\n").text().find("element 77"), std::string::npos);
  EXPECT_NE(build_text(cube + "*BOUNDARY_SPC_SET\n77,0,1\n").text().find("node set 77"), std::string::npos);
}

}  // namespace
}  // namespace cleave::model
