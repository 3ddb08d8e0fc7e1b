#include "firmware/steps/turn_gate.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace cnc {
namespace {

class TurnGateTest : public testing::Test {
 protected:
  /// Advances to a boundary. Returns the content of the cycle that is let in, if any.
  std::optional<std::uint32_t> boundary() {
    const Handover* const due = gate.due();
    const std::optional<std::uint32_t> segments =
        due != nullptr ? std::optional{due->segments} : std::nullopt;
    gate.show({});
    return segments;
  }
  std::uint32_t take() {
    StepView view;
    return gate.take(view) ? view.turn : kNone;
  }

  static constexpr std::uint32_t kNone = ~0U;
  TurnGate gate;
};

TEST_F(TurnGateTest, WhatATurnHandsOverComesInThreeBoundariesLaterHoweverLateItIsRun) {
  for (const bool late : {false, true}) {
    for (int i = 0; i < 3; ++i) boundary();
    const std::uint32_t first = take();
    ASSERT_NE(first, kNone);
    gate.hand_over({.turn = first, .segments = 10 + first});
    if (late) {
      EXPECT_EQ(take(), first + 1);
      gate.hand_over({.turn = first + 1, .segments = 11 + first});
    }
    EXPECT_EQ(boundary(), 10 + first);
    while (take() != kNone) {
    }
  }
}

TEST_F(TurnGateTest, ALateTurnIsCountedAndComesInWithALaterOne) {
  for (int i = 0; i < 4; ++i) boundary();
  EXPECT_EQ(gate.late(), 1U) << "turn 0 is not over at boundary 3";
  EXPECT_EQ(gate.behind(), 1U);
  EXPECT_EQ(take(), 0U);
  gate.hand_over({.turn = 0, .segments = 5});
  EXPECT_EQ(take(), 1U);
  gate.hand_over({.turn = 1, .segments = 6});
  EXPECT_EQ(boundary(), 6U);
  EXPECT_EQ(gate.late(), 1U);
  EXPECT_EQ(gate.behind(), 0U);
}

TEST_F(TurnGateTest, TurnsAtWhoseBoundaryOneWasLateKnowIt) {
  for (int i = 0; i < 5; ++i) boundary();
  for (const bool late : {false, false, false, true, true}) {
    StepView view;
    ASSERT_TRUE(gate.take(view));
    EXPECT_EQ(view.late, late) << view.turn;
    gate.hand_over({.turn = view.turn});
  }
  boundary();
  StepView view;
  ASSERT_TRUE(gate.take(view));
  EXPECT_FALSE(view.late);
}

/// A main loop that is late for a while keeps the motors supplied with the content of finished
/// cycles.
TEST_F(TurnGateTest, WhatIsOverComesInWhileLaterTurnsAreLate) {
  for (int i = 0; i < 5; ++i) boundary();
  for (std::uint32_t turn = 0; turn < 50; ++turn) {
    ASSERT_EQ(take(), turn);
    gate.hand_over({.turn = turn, .segments = 10 + turn});
    EXPECT_EQ(boundary(), 10 + turn) << "two turns were due after it";
    EXPECT_EQ(gate.behind(), 2U);
  }
  EXPECT_EQ(gate.late(), 2U + 50U);
}

/// After views that found no free space, there are cycles that are never run.
TEST_F(TurnGateTest, TurnsThatAreNeverRunHoldNothingUp) {
  for (int i = 0; i < 20; ++i) boundary();
  std::uint32_t last = kNone;
  for (std::uint32_t turn = take(); turn != kNone; turn = take()) {
    gate.hand_over({.turn = turn, .segments = 10 + turn});
    last = turn;
  }
  ASSERT_LT(last, 16U);
  EXPECT_EQ(boundary(), 10 + last);
  EXPECT_EQ(gate.behind(), 17 - last);
  EXPECT_EQ(take(), 20U);
  gate.hand_over({.turn = 20, .segments = 40});
  EXPECT_EQ(boundary(), 10 + last) << "turn 20 is not due yet";
  EXPECT_EQ(boundary(), 10 + last);
  EXPECT_EQ(boundary(), 40U);
  EXPECT_EQ(gate.behind(), 0U);
}

}  // namespace
}  // namespace cnc
