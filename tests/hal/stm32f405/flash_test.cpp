#include "hal/stm32f405/flash.hpp"

#include <gtest/gtest.h>

#include "hal/stm32f405/boards/generic.hpp"
#include "hal/stm32f405/boards/mks_robin_nano_v3.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

using RobinFlash = Flash<kMksRobinNanoV3, ModelBus>;

TEST(Flash, SectorsLieWhereTheManualHasThem) {
  EXPECT_EQ(0x4000U, sector_start(1));
  EXPECT_EQ(0x1'0000U, sector_start(4));
  EXPECT_EQ(0x2'0000U, sector_start(5));
  EXPECT_EQ(0x10'0000U, sector_start(12));
  EXPECT_EQ(64U * 1024, sector_bytes(4));
}

TEST(Flash, WhatIsProgrammedIsReadWhereTheBoardSays) {
  ChipModel& chip = ModelBus::start_anew();
  RobinFlash flash;
  EXPECT_EQ(2U, flash.sector_count());
  EXPECT_EQ(4'096U, flash.words_per_sector());
  EXPECT_TRUE(flash.program(1, 3, 0x1234'5678));
  EXPECT_EQ(0x1234'5678U, flash.read(1, 3));
  EXPECT_EQ(0x1234'5678U, chip.flash_words[0x0806'000C]);
  EXPECT_EQ(FlashSectors::kErased, flash.read(0, 3));
  EXPECT_TRUE(chip.flash_locked) << "locked again";
}

TEST(Flash, BitsOnlyFall) {
  ModelBus::start_anew();
  RobinFlash flash;
  EXPECT_TRUE(flash.program(0, 0, 0xFFFF'0000));
  EXPECT_TRUE(flash.program(0, 0, 0x0FFF'0000));
  EXPECT_FALSE(flash.program(0, 0, 0xFFFF'FFFF));
  EXPECT_EQ(0x0FFF'0000U, flash.read(0, 0));
}

TEST(Flash, ErasingTakesOneSector) {
  ChipModel& chip = ModelBus::start_anew();
  RobinFlash flash;
  ASSERT_TRUE(flash.program(0, 5, 1));
  ASSERT_TRUE(flash.program(1, 5, 2));
  EXPECT_TRUE(flash.erase(0));
  EXPECT_EQ(FlashSectors::kErased, flash.read(0, 5));
  EXPECT_EQ(2U, flash.read(1, 5));
  EXPECT_TRUE(chip.flash_locked);
}

TEST(Flash, RefusalsAreToldAndPlacesOutsideDoNotExist) {
  ChipModel& chip = ModelBus::start_anew();
  RobinFlash flash;
  EXPECT_FALSE(flash.program(2, 0, 1));
  EXPECT_FALSE(flash.program(0, 32'768, 1));
  EXPECT_FALSE(flash.erase(2));
  EXPECT_EQ(FlashSectors::kErased, flash.read(2, 0));
  EXPECT_TRUE(chip.flash_words.empty());
  chip.flash_weak_bits = 1;
  EXPECT_FALSE(flash.program(0, 1, 0)) << "a bit that does not fall";
  chip.flash_refuses = true;
  EXPECT_FALSE(flash.program(0, 2, 0));
  EXPECT_FALSE(flash.erase(0));
}

}  // namespace
}  // namespace hal::stm32f405
