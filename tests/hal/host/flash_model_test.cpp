#include "hal/host/flash_model.hpp"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace hal::host {
namespace {

constexpr FlashOperation kProgram{
    .kind = FlashOperation::Kind::kProgram, .sector = 0, .word = 3, .value = 0x0000'FFFF};
constexpr FlashOperation kErase{.kind = FlashOperation::Kind::kErase, .sector = 0};

class FlashModelTest : public testing::Test {
 protected:
  std::set<std::uint32_t> readings(std::size_t word) {
    std::set<std::uint32_t> seen;
    for (int i = 0; i < 200; ++i) seen.insert(flash.read(0, word));
    return seen;
  }

  FlashModel flash{2, 64};
};

TEST_F(FlashModelTest, ClearsBitsAndSetsThemOnlyByErasing) {
  EXPECT_TRUE(flash.program(0, 3, 0xFFFF'0000));
  EXPECT_FALSE(flash.program(0, 3, 0x00FF'FFFF)) << "reads otherwise";
  EXPECT_EQ(flash.read(0, 3), 0x00FF'0000U);
  EXPECT_TRUE(flash.erase(0));
  EXPECT_EQ(flash.read(0, 3), FlashSectors::kErased);
  EXPECT_EQ(flash.erases(0), 1U);
  EXPECT_EQ(flash.erases(1), 0U);
  EXPECT_THROW(static_cast<void>(flash.read(0, 64)), std::out_of_range);
}

TEST_F(FlashModelTest, ATornWordHasSomeOfItsZerosAndNoOther) {
  std::set<std::uint32_t> seen;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    FlashModel torn = flash;
    torn.cut_at(kProgram, CutKind::kTorn, seed);
    seen.insert(torn.read(0, 3));
    EXPECT_EQ(torn.read(0, 3) & kProgram.value, kProgram.value);
    EXPECT_EQ(torn.read(0, 3), torn.read(0, 3));
  }
  EXPECT_GT(seen.size(), 30U);
}

TEST_F(FlashModelTest, AnUnsteadyWordIsFirmWhenProgrammedAgain) {
  bool any = false;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    flash = FlashModel{2, 64};
    flash.cut_at(kProgram, CutKind::kMarginal, seed);
    any = any || readings(3).size() > 1;
    flash.power_up(seed, Unsteadiness::kEachPowerUp);
    EXPECT_EQ(readings(3).size(), 1U) << "the same within one life";
    flash.power_up(seed, Unsteadiness::kEachRead);
    EXPECT_TRUE(flash.program(0, 3, kProgram.value));
    EXPECT_EQ(readings(3), std::set<std::uint32_t>{kProgram.value});
  }
  EXPECT_TRUE(any);
}

TEST_F(FlashModelTest, AnEraseThatIsCutOffLeavesAnythingBetween) {
  for (std::size_t word = 0; word < 64; ++word) ASSERT_TRUE(flash.program(0, word, 0));
  flash.cut_at(kErase, CutKind::kTorn, 7);
  std::set<std::uint32_t> seen;
  for (std::size_t word = 0; word < 64; ++word) seen.insert(flash.read(0, word));
  EXPECT_GT(seen.size(), 1U);
  EXPECT_EQ(flash.erases(0), 1U);
  EXPECT_TRUE(flash.erase(0));
  for (std::size_t word = 0; word < 64; ++word) EXPECT_EQ(flash.read(0, word), 0xFFFF'FFFFU);
}

TEST_F(FlashModelTest, RefusesFromAnOperationOn) {
  flash.refuse_after(1);
  EXPECT_TRUE(flash.program(0, 0, 1));
  EXPECT_FALSE(flash.program(0, 1, 1));
  EXPECT_FALSE(flash.erase(0));
  EXPECT_EQ(flash.read(0, 1), FlashSectors::kErased);
}

}  // namespace
}  // namespace hal::host
