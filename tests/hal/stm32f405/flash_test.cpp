#include "hal/stm32f405/flash.hpp"

#include <gtest/gtest.h>

#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

/// Returns the flash of a chip with 512 KiB.
Flash<ModelBus> small_flash() {
  Flash<ModelBus> flash;
  flash.use(*store_sectors_of(512));
  return flash;
}

TEST(Flash, SectorsLieWhereTheManualHasThem) {
  EXPECT_EQ(0x4000U, sector_start(1));
  EXPECT_EQ(0x1'0000U, sector_start(4));
  EXPECT_EQ(0x2'0000U, sector_start(5));
  EXPECT_EQ(0x10'0000U, sector_start(12));
  EXPECT_EQ(64U * 1024, sector_bytes(4));
}

TEST(Flash, WhatIsProgrammedIsReadInTheChipsSectors) {
  ChipModel& chip = ModelBus::start_anew();
  Flash<ModelBus> flash = small_flash();
  EXPECT_EQ(2U, flash.sector_count());
  EXPECT_EQ(4'096U, flash.words_per_sector());
  EXPECT_TRUE(flash.program(1, 3, 0x1234'5678));
  EXPECT_EQ(0x1234'5678U, flash.read(1, 3));
  EXPECT_EQ(0x1234'5678U, chip.flash_words[0x0806'000C]);
  EXPECT_EQ(FlashSectors::kErased, flash.read(0, 3));
  EXPECT_TRUE(chip.flash_locked) << "locked again";
}

TEST(Flash, WithoutSectorsThereIsNothing) {
  ChipModel& chip = ModelBus::start_anew();
  Flash<ModelBus> flash;
  EXPECT_FALSE(flash.program(0, 0, 1));
  EXPECT_FALSE(flash.erase(0));
  EXPECT_EQ(FlashSectors::kErased, flash.read(0, 0));
  EXPECT_TRUE(chip.writes.empty());
  flash.use({10, 11});
  EXPECT_TRUE(flash.program(0, 0, 1));
  EXPECT_EQ(1U, chip.flash_words[0x080C'0000]);
}

TEST(Flash, KeysAreWrittenOnlyToAFlashThatIsLocked) {
  ChipModel& chip = ModelBus::start_anew();
  chip.flash_locked = false;  // A boot loader may leave the flash unlocked.
  Flash<ModelBus> flash = small_flash();
  EXPECT_TRUE(flash.program(0, 0, 1));
  EXPECT_TRUE(chip.flash_locked);
  EXPECT_TRUE(flash.program(0, 1, 2)) << "a key too many would lock it for good";
  EXPECT_EQ(2U, flash.read(0, 1));
}

TEST(Flash, NothingIsWrittenWhileTheSupplyFails) {
  ChipModel& chip = ModelBus::start_anew();
  Flash<ModelBus> flash = small_flash();
  EXPECT_TRUE(flash.program(0, 0, 1));
  chip.cells[pwr::kCsr] = pwr::kSupplyIsLow;
  EXPECT_FALSE(flash.program(0, 1, 1));
  EXPECT_FALSE(flash.erase(0));
  EXPECT_EQ(1U, flash.read(0, 0));
  EXPECT_EQ(FlashSectors::kErased, flash.read(0, 1));
  chip.cells[pwr::kCsr] = 0;
  EXPECT_TRUE(flash.program(0, 1, 1)) << "as soon as it is back";
}

TEST(Flash, BitsOnlyFall) {
  ModelBus::start_anew();
  Flash<ModelBus> flash = small_flash();
  EXPECT_TRUE(flash.program(0, 0, 0xFFFF'0000));
  EXPECT_TRUE(flash.program(0, 0, 0x0FFF'0000));
  EXPECT_FALSE(flash.program(0, 0, 0xFFFF'FFFF));
  EXPECT_EQ(0x0FFF'0000U, flash.read(0, 0));
}

TEST(Flash, ErasingTakesOneSector) {
  ChipModel& chip = ModelBus::start_anew();
  Flash<ModelBus> flash = small_flash();
  ASSERT_TRUE(flash.program(0, 5, 1));
  ASSERT_TRUE(flash.program(1, 5, 2));
  EXPECT_TRUE(flash.erase(0));
  EXPECT_EQ(FlashSectors::kErased, flash.read(0, 5));
  EXPECT_EQ(2U, flash.read(1, 5));
  EXPECT_TRUE(chip.flash_locked);
}

TEST(Flash, RefusalsAreToldAndPlacesOutsideDoNotExist) {
  ChipModel& chip = ModelBus::start_anew();
  Flash<ModelBus> flash = small_flash();
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
