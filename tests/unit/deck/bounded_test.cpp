/// Hostile decks: work and memory follow the size of the text, not the numbers in it.
#include <chrono>

#include "reading.hpp"

namespace cleave::deck {
namespace {

/// Reads everything and shows every message within the time a reader of any length of text may take.
std::string read_quickly(const std::string& text) {
  const auto start = std::chrono::steady_clock::now();
  Reading r(text);
  r.read_all();
  std::string shown = r.rendered();
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 20.0)
      << text.substr(0, 60);
  return shown;
}

std::string repeated(const std::string& piece, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += piece;
  return text;
}

TEST(Bounded, CountsInFieldsAllocateNothing) {
  read_quickly("*SECTION_SOLID\n1,101\n1000000000,0,0,0,1000000000\n.1,.2\n");
  read_quickly("*SECTION_SHELL\n1,2,1.,9000000000000000000,,,1\n1.\n45.,30.\n");
  read_quickly("*INITIAL_STRESS_SHELL\n1,1000000,1000000,1000000\n" + repeated("1.,2.\n", 3000));
  read_quickly("*BOUNDARY_PRECRACK\n1,1,9223372036854775807\n" + repeated("1.,2.,3.\n", 1000));
  read_quickly("*BOUNDARY_PRECRACK\n1,1,-5\n");
}

TEST(Bounded, LongLines) {
  constexpr int many = 300000;
  read_quickly("*SET_NODE_LIST\n1\n" + repeated("1,", many) + "\n");
  read_quickly("*SET_NODE_LIST\n1\n" + repeated("<,", many) + "\n");
  read_quickly("*DEFINE_CURVE\n1\n" + repeated("1,2,", many) + "\n");
  read_quickly("*PARAMETER\n" + repeated("Ra,1,", many) + "\n");
  read_quickly("*PARAMETER_EXPRESSION\nRa, " + repeated("1+", many) + "1\n");
  read_quickly("*MAT_ELASTIC\n" + std::string(many, ' ') + "1\n");
  read_quickly("*MAT_ELASTIC\n" + std::string(many, '9') + ",1\n");
  read_quickly("*MAT_ELASTIC\n1,<" + std::string(many, '(') + "\n");
  read_quickly("*MAT_ELASTIC\n1,&" + std::string(many, 'x') + "\n");
  read_quickly("*TITLE\n" + std::string(many, 't') + "\n");
  read_quickly("*" + std::string(many, 'K') + "\n");
  read_quickly("*NODE\n" + std::string(many, '\t') + "1\n");
}

TEST(Bounded, ManyLinesAndKeywords) {
  read_quickly(repeated("*\n", 20000));
  read_quickly(repeated("*MAT_ELASTIC\n", 20000));
  read_quickly("*KEYWORD\r" + repeated("\r", 300000));
  read_quickly("*DEFINE_TRANSFORMATION\n1\n" + repeated("MATRIX\n", 20000));
  read_quickly("*INITIAL_STRESS_SHELL\n" + repeated("\n", 20000) + "1\n");
  std::string unknown;
  for (int i = 0; i < 5000; ++i) unknown += "*NO_SUCH_KEYWORD_" + std::to_string(i) + "\n";
  read_quickly(unknown);
}

TEST(Bounded, ManyDefinitionsAndUses) {
  std::string text = "*PARAMETER\n";
  for (int i = 0; i < 20000; ++i) text += "Ra" + std::to_string(i) + ", 1.\n";
  text += repeated("Ra, 1.\n", 20000) + "*SET_NODE_LIST\n1\n" + repeated("&a,&missing\n", 5000);
  read_quickly(text);
}

TEST(Bounded, ParametersDoNotGrow) {
  // Each is the sum of the one before it with itself: values are kept, never texts.
  std::string text = "*PARAMETER_EXPRESSION\nRa0, 1.\n";
  for (int i = 1; i < 2000; ++i)
    text += "Ra" + std::to_string(i) + ", a" + std::to_string(i - 1) + "+a" + std::to_string(i - 1) + "\n";
  EXPECT_NE(read_quickly(text).find("not a finite number"), std::string::npos);
}

}  // namespace
}  // namespace cleave::deck
