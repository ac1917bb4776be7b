#pragma once
/// Deck -> model -> deck -> model gives the same model.

#include <gtest/gtest.h>

#include "deck_text.hpp"
#include "model/equal.hpp"

namespace cleave::model {

inline void expect_round_trip(const std::string& text) {
  const Built first = build_text(text);
  ASSERT_FALSE(first.failed()) << first.text();
  const std::string written = write(first.model);
  const Built second = build_text(written);
  ASSERT_FALSE(second.failed()) << second.text() << written;
  EXPECT_EQ(first_difference(first.model, second.model), "") << written;
  EXPECT_EQ(write(second.model), written);
}

}  // namespace cleave::model
