#include "host-sim/measure/shaping_meter.hpp"

#include <gtest/gtest.h>

#include "host-sim/measure/tool_trace.hpp"

namespace sim {
namespace {

constexpr cnc::AxisArray<double> kTenStepsPerMm{10.0, 10.0, 10.0, 10.0, 10.0, 10.0};

TEST(ShapingMeter, MeasuresFromThePathAndNotFromThePlaceInTime) {
  ShapingMeter meter{kTenStepsPerMm};
  cnc::AxisArray<cnc::StepPosition> planned{};
  for (int cell = 0; cell < 6; ++cell) {
    planned[0] = cnc::StepPosition::whole(20 * cell);
    cnc::AxisArray<cnc::StepPosition> shaped{};
    shaped[0] = cnc::StepPosition::whole(15 * cell);
    meter.on_cell({planned, shaped, 3, 1'000'000});
  }
  EXPECT_NEAR(meter.greatest_distance(), 0.0, 1.0e-9) << "behind, but on the line";
  cnc::AxisArray<cnc::StepPosition> beside{};
  beside[0] = cnc::StepPosition::whole(75);
  beside[1] = cnc::StepPosition::whole(3);
  meter.on_cell({planned, beside, 3, 1'000'000});
  EXPECT_NEAR(meter.greatest_distance(), 0.3, 1.0e-9);
}

TEST(PlayModel, LeavesAnAxisUntilItsPlayIsCrossed) {
  MachineModel model;
  model.backlash_mm[0] = 0.04;  // Ten steps at 250 steps/mm, the default of a new controller.
  PlayModel play{model};
  play.place(cnc::Settings{});
  EXPECT_EQ(play.follow({-5})[0], -5) << "homing pulls off towards minus";
  EXPECT_EQ(play.follow({5})[0], -5);
  EXPECT_EQ(play.follow({8})[0], -2);
  EXPECT_EQ(play.follow({0})[0], -2);
  EXPECT_EQ(play.follow({-3})[0], -3);
}

}  // namespace
}  // namespace sim
