#include <cstdint>
#include <utility>
#include <vector>

#include "tests/planner/pipeline/pipeline_test.hpp"

namespace cnc {
namespace {

/// Tests a chain of lines and arcs that is halted during its motion.
class TakenBackTest : public PipelineTest {
 protected:
  void begin(int elements) {
    for (int i = 0; i < elements; ++i) {
      wait_for_room();
      const Position& from = pipeline->target();
      Position to = from;
      to[0] += Coordinate{2'000'000};
      to[1] += Coordinate{i % 2 == 0 ? 0 : 1'000'000};
      EXPECT_TRUE(pipeline
                      ->append({.request = {.element = {.start = from,
                                                        .end = to,
                                                        .bulge = i % 3 == 0 ? 0.4F : 0.0F},
                                            .feed_mm_s = 50.0F}})
                      .ok());
    }
  }
  void halt_after(double mm) {
    while (travelled_mm() < mm) cycle(1);
    pipeline->keep_path(true);
    pipeline->halt();
    while (!pipeline->held()) cycle(1);
  }
  [[nodiscard]] double travelled_mm() const {
    return static_cast<double>(pipeline->travelled()) / static_cast<double>(motion::kUnitsPerMm);
  }
};

TEST_F(TakenBackTest, GoesOnFromWhereItWasAsIfItHadBeenHaltedThere) {
  begin(20);
  std::vector<std::pair<double, Steps>> way;
  while (travelled_mm() < 17.0) {
    cycle(1);
    way.emplace_back(travelled_mm(), motors);
  }
  halt_after(17.0);
  const double stood = travelled_mm();
  const double back = stood - way[way.size() / 2].first;
  EXPECT_EQ(pipeline->go_back(
                static_cast<motion::PathUnits>(back * static_cast<double>(motion::kUnitsPerMm))),
            0);
  EXPECT_NEAR(travelled_mm(), stood - back, 1.0e-6);
  EXPECT_TRUE(pipeline->held());
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto step = pipeline->place()[axis].nearest_step();
    EXPECT_NEAR(step, way[way.size() / 2].second[axis], 1);
    motors[axis] = step;
  }
  pipeline->go_on();
  for (std::size_t i = way.size() / 2; i < way.size(); ++i) {
    while (travelled_mm() < way[i].first && step()) {
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
      EXPECT_NEAR(motors[axis], way[i].second[axis], 20) << travelled_mm();
    }
  }
  finish();
  EXPECT_EQ(motors, steps_at(pipeline->target()));
}

TEST_F(TakenBackTest, SaysHowMuchIsNotKnownAnyMore) {
  begin(300);
  halt_after(500.0);
  const double stood = travelled_mm();
  const float unknown_mm = motion::to_mm(pipeline->go_back(
      static_cast<motion::PathUnits>(400.0 * static_cast<double>(motion::kUnitsPerMm))));
  EXPECT_GT(unknown_mm, 1.0F);
  EXPECT_LT(unknown_mm, 400.0F - 2.0F * motion::kBlocksKept);
  EXPECT_NEAR(travelled_mm(), stood - 400.0 + static_cast<double>(unknown_mm), 1.0e-3);
  motors = {};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    motors[axis] = pipeline->place()[axis].nearest_step();
  }
  pipeline->go_on();
  pipeline->keep_path(false);
  finish();
  EXPECT_EQ(motors, steps_at(pipeline->target()));
}

TEST_F(TakenBackTest, TakesBackWhatWasDrivenToTheEnd) {
  begin(3);
  finish();
  EXPECT_EQ(pipeline->go_back(motion::to_units(3.0F)), 0);
  EXPECT_FALSE(pipeline->empty());
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    motors[axis] = pipeline->place()[axis].nearest_step();
  }
  finish();
  EXPECT_EQ(motors, steps_at(pipeline->target()));
}

TEST_F(TakenBackTest, TakesNothingBackAfterAllWasForgotten) {
  begin(3);
  finish();
  pipeline->restart(motors, motors);
  EXPECT_EQ(pipeline->go_back(motion::to_units(3.0F)), motion::to_units(3.0F));
  EXPECT_TRUE(pipeline->empty());
}

}  // namespace
}  // namespace cnc
