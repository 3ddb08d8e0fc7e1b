#include "firmware/machine/machine_set_up.hpp"

#include <gtest/gtest.h>

#include <array>

namespace cnc {
namespace {

motion::PowerTable table_with_threshold() {
  constexpr std::array<motion::PowerPoint, 2> kPoints{
      {{.duty = 1000, .milliwatts = 0}, {.duty = 10'000, .milliwatts = 9000}}};
  const auto table = motion::PowerTable::make(kPoints);
  EXPECT_TRUE(table.ok());
  return table.value();
}

class MachineSetUpTest : public testing::Test {
 protected:
  MachineSetUpTest() { set_up_.apply(); }

  MachineSetUp set_up_;
};

TEST_F(MachineSetUpTest, GivesTheLimitsOfTheSettingsOnceTheyAreApplied) {
  const float before = set_up_.limits().scale[0].steps_per_mm();
  EXPECT_TRUE(set_up_.set(setting::kStepsPerMm, 4.0F * before).ok());
  EXPECT_EQ(set_up_.settings().get(setting::kStepsPerMm), 4.0F * before);
  EXPECT_EQ(set_up_.limits().scale[0].steps_per_mm(), before);
  set_up_.apply();
  EXPECT_EQ(set_up_.limits().scale[0].steps_per_mm(), 4.0F * before);
}

TEST_F(MachineSetUpTest, KeepsItsSettingsWhenAValueIsRefused) {
  const float before = set_up_.settings().get(setting::kStepsPerMm);
  EXPECT_FALSE(set_up_.set(setting::kStepsPerMm, -1.0F).ok());
  EXPECT_EQ(set_up_.settings().get(setting::kStepsPerMm), before);
}

TEST_F(MachineSetUpTest, GivesALaserAloneTheResponseOfThePowerTable) {
  set_up_.set_power_table(table_with_threshold());
  set_up_.apply();
  EXPECT_EQ(set_up_.power_table(), table_with_threshold());
  EXPECT_EQ(set_up_.limits().beam.table, motion::PowerTable{}) << "of a spindle";
  EXPECT_TRUE(set_up_.set(setting::kLaserMode, 1.0F).ok());
  set_up_.apply();
  EXPECT_EQ(set_up_.limits().beam.table, table_with_threshold());
}

}  // namespace
}  // namespace cnc
