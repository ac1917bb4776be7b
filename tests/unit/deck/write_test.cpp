#include "deck/write.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "deck/layout.hpp"
#include "deck/layout_table.hpp"
#include "reading.hpp"

namespace cleave::deck {
namespace {

TEST(Write, RealsReadBackToTheSameBits) {
  std::uint64_t seed = 1;
  for (int i = 0; i < 20000; ++i) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    double value;
    std::memcpy(&value, &seed, sizeof value);
    if (!std::isfinite(value)) continue;
    Reading r(CardWriter("CONTROL_CPU").set("CPUTIM", value).text());
    const double back = r.card("CONTROL_CPU").real("CPUTIM");
    ASSERT_EQ(std::memcmp(&back, &value, sizeof value), 0) << value << " " << back;
  }
}

TEST(Write, IdsOf64BitsSurvive) {
  const std::int64_t big = std::numeric_limits<std::int64_t>::max();
  Reading r(CardWriter("MAT_ELASTIC").set("MID", big).set("RO", 1.0).text());
  EXPECT_EQ(r.card("MAT_ELASTIC").integer("MID"), big);
  EXPECT_EQ(r.errors(), 0u) << r.rendered();
}

TEST(Write, TitlesKeepTheirCommas) {
  const std::string title = "a plate, 2 mm & more $ <x>";
  Reading r(CardWriter("PART").set("HEADING", title).set("PID", 3).set("SECID", 1).set("MID", 2).text());
  EXPECT_EQ(r.card("PART").text("HEADING"), title);
  EXPECT_EQ(r.card("PART").integer("MID"), 2);
  Reading contact(CardWriter("CONTACT_AUTOMATIC_SINGLE_SURFACE", {"ID"})
                      .set("CID", 12)
                      .set("HEADING", title)
                      .set("SSID", 4)
                      .text());
  EXPECT_EQ(contact.card("CONTACT_AUTOMATIC_SINGLE_SURFACE").text("HEADING"), title);
  EXPECT_EQ(contact.card("CONTACT_AUTOMATIC_SINGLE_SURFACE").integer("CID"), 12);
  EXPECT_EQ(contact.card("CONTACT_AUTOMATIC_SINGLE_SURFACE").integer("SURFA"), 4);
}

TEST(Write, SeriesAndCurves) {
  std::vector<std::int64_t> ids;
  for (int i = 0; i < 21; ++i) ids.push_back(1000000000000 + i);
  Reading set(CardWriter("SET_NODE_LIST").set("SID", 7).series("NODES", ids).text());
  const Card back = set.card("SET_NODE_LIST");
  EXPECT_EQ(std::vector<std::int64_t>(back.integers("NODES").begin(), back.integers("NODES").end()), ids);

  CardWriter curve("DEFINE_CURVE");
  curve.set("LCID", 1);
  for (std::size_t i = 0; i < 5; ++i)
    curve.set("A1", 0.1 * static_cast<double>(i), i).set("O1", 1.0 / 3.0, i);
  Reading r(curve.text());
  const Card points = r.card("DEFINE_CURVE");
  ASSERT_EQ(points.row_count("A1"), 5u);
  EXPECT_EQ(points.real("A1", 3), 0.1 * 3.0);
  EXPECT_EQ(points.real("O1", 4), 1.0 / 3.0);
}

TEST(Write, QuadraticTetrahedraTakeTwoLines) {
  CardWriter writer("ELEMENT_SOLID");
  writer.set("EID", 1).set("PID", 2);
  for (int i = 1; i <= 10; ++i) writer.set("N" + std::to_string(i), 100 + i);
  Reading r(writer.text());
  EXPECT_EQ(r.card("ELEMENT_SOLID").integer("N10"), 110);
  EXPECT_EQ(r.card("ELEMENT_SOLID").integer("EID"), 1);
}

TEST(Write, RowsOfNodes) {
  std::string text = "*NODE\n";
  RowWriter row(text);
  row.integer(5).real(0.1).real(-1e-300).real(1.0 / 3.0).end();
  row.integer(6).blank().real(2.0).real(0.0).end();
  Reading r(text);
  std::vector<double> x;
  r.deck.rows(r.block("NODE"), r.diagnostics,
              [&](const Row& n) { x.push_back(n.real(3)), x.push_back(n.real(2)); });
  EXPECT_EQ(x, (std::vector<double>{1.0 / 3.0, -1e-300, 0.0, 2.0}));
}

/// Every keyword of the table, every field set once: what is written is read back, with all conditions.
TEST(Write, EveryKeywordReadsBack) {
  for (const std::string_view name : known_keywords()) {
    const table::Keyword& layout = *table::find(name);
    if (layout.item_count == 0 || name == "KEYWORD" || name == "COMMENT" || name.starts_with("INCLUDE") ||
        name.starts_with("PARAMETER"))
      continue;
    std::vector<std::string> options;
    for (std::uint16_t i = 0; i < layout.option_count; ++i) {
      const std::string suffix = table::option(static_cast<std::uint16_t>(layout.first_option + i))->suffix;
      if (!suffix.empty()) options.push_back(suffix.substr(0, suffix.find('|')));
    }
    CardWriter writer(name, options);
    double next = 0.7;
    for (const FieldLayout& f : fields_of(name)) {
      next += 1.0;
      if (f.type == 'I') writer.set(f.name, static_cast<int>(next));
      if (f.type == 'F') writer.set(f.name, next + 1.0 / 3.0);
      if (f.name == "OPTC")
        writer.set(f.name, "OPTCARD", 0).set(f.name, "OPTCARD", 1).set(f.name, "OPTCARD", 2);
      else if (f.type == 'A')
        writer.set(f.name, "W" + std::to_string(static_cast<int>(next)));
    }
    const std::string text = writer.text();
    Reading r(text);
    ASSERT_EQ(r.deck.blocks().at(0).keyword, name) << text;
    const std::vector<Card> cards = r.cards(name);
    ASSERT_EQ(cards.size(), 1u) << text << r.rendered();
    EXPECT_EQ(r.errors(), 0u) << text << r.rendered();
    // The last setting of a doubled name counts; a second row of it is blank.
    double expected = 0.7;
    std::vector<std::pair<std::string, double>> last;
    for (const FieldLayout& f : fields_of(name)) last.emplace_back(f.name, expected += 1.0);
    std::size_t given = 0;
    for (std::size_t i = 0; i < last.size(); ++i) {
      const auto& [field, number] = last[i];
      bool again = false;
      for (std::size_t j = i + 1; j < last.size(); ++j) again |= last[j].first == field;
      if (again || field == "OPTC" || !cards[0].given(field)) continue;
      ++given;
      const char type = fields_of(name)[i].type;
      if (!cards[0].integers(field).empty())
        EXPECT_EQ(cards[0].integers(field)[0], static_cast<int>(number)) << field << "\n" << text;
      else if (!cards[0].reals(field).empty())
        EXPECT_EQ(cards[0].reals(field)[0], number + 1.0 / 3.0) << field << "\n" << text;
      else if (type == 'I')
        EXPECT_EQ(cards[0].integer(field), static_cast<int>(number)) << field << "\n" << text;
      else if (type == 'F')
        EXPECT_EQ(cards[0].real(field), number + 1.0 / 3.0) << field << "\n" << text;
      else
        EXPECT_EQ(cards[0].text(field), "W" + std::to_string(static_cast<int>(number))) << field << "\n"
                                                                                        << text;
    }
    EXPECT_GT(given, 0u) << text;
  }
}

}  // namespace
}  // namespace cleave::deck
