#include <gtest/gtest.h>

#include <array>

#include "planner/gcode/kerf_condition.hpp"
#include "planner/kerf/csp_1n.hpp"
#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

/// Tests M190, and G41 and G42 with the kerf of the selected material.
class KerfWords : public InterpreterTest {
 protected:
  KerfWords() {
    options.laser = true;
    kerf = {.count = 2, .view = kerf::kCsp1n<float>};
    options.kerf = &kerf;
    options.full_power_speed = 1000.0F;
    options.greatest_power_mw = 2'000'000;
    interpreter.set_options(options);
  }
  [[nodiscard]] kerf::Condition asked() const {
    return kerf_condition(interpreter.state(), options);
  }
  FaultDetail refused(std::string_view line) { return refuse(line).detail; }

  kerf::SelectedTable kerf;
  Options options{};
};

/// The worked example of Park and Ahn 2007: 2 mm at 1800 W and 4000 mm/min.
TEST_F(KerfWords, TakeTheWidthFromTheTable) {
  static_cast<void>(take("M190 P0 Q2"));
  const auto actions = take("G42 F4000 S900");
  ASSERT_EQ(actions.size(), 2U);
  const CutterCompensation wanted = actions[1].compensation;
  EXPECT_EQ(wanted.side, CutterSide::kRight);
  EXPECT_TRUE(wanted.by_kerf);
  EXPECT_EQ(asked(), (kerf::Condition{2000, 1'800'000, 4'000'000}));
  const auto exact = kerf::kerf_width(kerf::kCsp1n<float>, asked());
  ASSERT_TRUE(exact.ok());
  EXPECT_EQ(wanted.width_mm, exact.value());
}

TEST_F(KerfWords, ReadInchesAsTheyAre) {
  static_cast<void>(take("G20 M190 P1 Q.078740157"));
  EXPECT_EQ(interpreter.state().material, (Material{.table = 1, .thickness_um = 2000}));
  kerf.index = 1;
  static_cast<void>(take("G41 F157.4803150 S900"));
  EXPECT_EQ(asked(), (kerf::Condition{2000, 1'800'000, 4'000'000}));
}

TEST_F(KerfWords, KeepPowerAndSpeedUntilG40) {
  static_cast<void>(take("M190 P0 Q2"));
  static_cast<void>(take("G41 F4000 S900"));
  EXPECT_EQ(refused("G1 X5 F3900"), FaultDetail::kNotBesideThePath);
  EXPECT_EQ(refused("G1 X5 S300"), FaultDetail::kNotBesideThePath);
  EXPECT_EQ(take("G1 X5 F4000 S900").back().kind, ActionKind::kLine);
  EXPECT_TRUE(take("G41").empty()) << "as it is";
  EXPECT_EQ(refused("G41.1 D0.3"), FaultDetail::kAlreadyBesideThePath);
  EXPECT_EQ(take("G40 G1 X9 F3900 S300").back().kind, ActionKind::kLine);
  static_cast<void>(take("G41.1 D0.3"));
  EXPECT_EQ(take("G1 X5 F3900 S200").back().kind, ActionKind::kLine) << "that width is fixed";
}

TEST_F(KerfWords, SayWhatIsMissing) {
  EXPECT_EQ(refused("G41 F4000 S900"), FaultDetail::kMaterialMissing);
  EXPECT_EQ(refused("M190 P1 Q2 G41 F4000 S900"), FaultDetail::kMaterialMissing)
      << "its table is not at hand yet";
  EXPECT_EQ(refused("M190"), FaultDetail::kWordMissing);
  EXPECT_EQ(refused("M190 P0"), FaultDetail::kWordMissing);
  EXPECT_EQ(refused("M190 P2 Q2"), FaultDetail::kNoSuchMaterial);
  EXPECT_EQ(refused("M190 P0.5 Q2"), FaultDetail::kNotAnInteger);
  for (const char* line : {"M190 P0 Q0", "M190 P0 Q-1"}) {
    EXPECT_EQ(refused(line), FaultDetail::kNegative) << line;
  }
  EXPECT_EQ(refused("M190 P0 Q101"), FaultDetail::kTooLarge);
  EXPECT_EQ(interpreter.state().material, Material{}) << "a refused line changes nothing";
  static_cast<void>(take("M190 P0 Q2"));
  EXPECT_EQ(refused("G41 S900"), FaultDetail::kFeedMissing);
  options.greatest_power_mw = 0;
  interpreter.set_options(options);
  EXPECT_EQ(refused("G41 F4000 S900"), FaultDetail::kKerfNeedsWatts);
  options.laser = false;
  interpreter.set_options(options);
  EXPECT_EQ(refused("G41 F4000 S900"), FaultDetail::kToolHasNoRadius);
}

/// The refusal contains the nearest permissible value.
TEST_F(KerfWords, RefuseWhatNobodyHasCut) {
  const auto told = [this](std::string_view line) {
    std::array<char, 96> text{};
    const Fault fault = refuse(line);
    return std::string(text.data(), describe(fault, text));
  };
  static_cast<void>(take("M190 P0 Q2"));
  EXPECT_EQ(told("G41 F4000 S250"),
            "500.000 W does not cut the material, the nearest is 1200.000 W");
  EXPECT_EQ(told("G41 F9000 S900").substr(0, 41), "9000.000 mm/min does not cut the material");
  static_cast<void>(take("M190 P0 Q50"));
  EXPECT_EQ(told("G41 F4000 S900").substr(0, 41), "50.000 mm is no thickness of the material");
}

TEST_F(KerfWords, OutliveTheProgramAndNotAReset) {
  static_cast<void>(take("M190 P0 Q2"));
  static_cast<void>(take("M2"));
  EXPECT_EQ(interpreter.state().material.thickness_um, 2000U);
  interpreter.reset();
  EXPECT_EQ(interpreter.state().material, Material{});
}

}  // namespace
}  // namespace cnc::gcode
