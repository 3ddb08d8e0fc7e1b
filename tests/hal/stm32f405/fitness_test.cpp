#include "hal/stm32f405/fitness.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hal/stm32f405/flash_size.hpp"
#include "hal/stm32f405/start_up.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

// End of the flash if it has only the sectors up to 6.
constexpr Address kShort = flash::kMemory + 256 * kKib;
constexpr Address kLong = kShort + 4;

ChipModel& chip_with(Word code, Word kib) {
  ChipModel& chip = ModelBus::start_anew();
  chip.cells[kDeviceCode] = 0x1000'0000 | code;
  chip.cells[kFlashSize] = kib << 16U | 0xABCD;
  return chip;
}

std::string told(const Fitness& fitness) {
  std::array<char, 160> text{};
  const std::size_t size = describe(fitness, text);
  EXPECT_LT(size, text.size()) << "cut off";
  return {text.data(), size};
}

TEST(Fitness, TheStoreLiesInTheLastSectorsOfTheChip) {
  EXPECT_EQ((StoreSectors{10, 11}), fitness_of(true, kShort, 1024).store);
  EXPECT_EQ((StoreSectors{10, 11}), fitness_of(true, kLong, 2048).store);
  EXPECT_EQ((StoreSectors{6, 7}), fitness_of(true, kShort, 512).store);
  EXPECT_FALSE(fitness_of(true, kShort, 512).fault);
}

TEST(Fitness, AnImageThatReachesIntoTheStoreIsRefused) {
  const Fitness fitness = fitness_of(true, kLong, 512);
  EXPECT_EQ(Unfitness::kSmallChip, fitness.fault);
  EXPECT_EQ(1024U, fitness.wanted_kib);
  EXPECT_EQ(
      "[MSG:Nothing runs: the chip has 512 KiB of flash, and the image with its store takes 1024 "
      "KiB. "
      "Use an image for 512 KiB, or a board with a larger chip]\r\n",
      told(fitness));
  EXPECT_FALSE(fitness_of(true, flash::kMemory + 768 * kKib, 1024).fault);
  EXPECT_EQ(Unfitness::kSmallChip, fitness_of(true, flash::kMemory + 768 * kKib + 4, 1024).fault);
}

TEST(Fitness, ASmallChipIsRefused) {
  const Fitness fitness = fitness_of(true, kShort, 256);
  EXPECT_EQ(Unfitness::kSmallChip, fitness.fault);
  EXPECT_EQ(
      "[MSG:Nothing runs: the chip has 256 KiB of flash, and the image with its store takes 512 "
      "KiB. "
      "Use a board with a larger chip]\r\n",
      told(fitness));
}

TEST(Fitness, DamageComesBeforeEverythingElse) {
  EXPECT_EQ(Unfitness::kDamaged, fitness_of(false, kShort, 0).fault);
  EXPECT_NE(std::string::npos, told(fitness_of(false, kShort, 1024)).find("damaged"));
}

TEST(Fitness, TheSizeIsReadOnChipsThatHaveItThere) {
  chip_with(0x413, 512);
  EXPECT_EQ(512U, flash_kib<ModelBus>());
  chip_with(0x419, 2048);
  EXPECT_EQ(2048U, flash_kib<ModelBus>());
  chip_with(0x413, 0xFFFF);
  EXPECT_EQ(0U, flash_kib<ModelBus>()) << "impossible";
  chip_with(0x450, 1024);
  EXPECT_EQ(0U, flash_kib<ModelBus>()) << "another family";
  EXPECT_EQ(Unfitness::kUnknownChip, fitness_of(true, kShort, 0).fault);
  EXPECT_NE(std::string::npos, told(fitness_of(true, kShort, 0)).find("F405"));
}

TEST(StartCore, ABarrierFollowsTheSetUp) {
  ChipModel& chip = ModelBus::start_anew();
  start_core<ModelBus>(flash::kMemory, 0x1000'0000);
  EXPECT_EQ(1U, chip.barriers);
  EXPECT_EQ(chip.writes.size(), chip.writes_at_barrier) << "all of it before the barrier";
}

}  // namespace
}  // namespace hal::stm32f405
