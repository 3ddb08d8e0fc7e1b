#include "firmware/store/flash_log.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <random>

#include "tests/firmware/store/power_cut.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

using hal::host::FlashModel;

Value bytes(std::size_t count, unsigned char value) { return Value(count, std::byte{value}); }

/// Sectors of 1 KiB, so that compactions are frequent.
class FlashLogTest : public testing::Test {
 protected:
  static constexpr std::size_t kWords = 256;

  Values after_power_up() {
    FlashLog again{flash};
    return all_of(again);
  }

  FlashModel flash{2, kWords};
};

TEST_F(FlashLogTest, KeepsTheLastValueOfEachNumber) {
  FlashLog log{flash};
  EXPECT_TRUE(log.save(3, bytes(4, 1)));
  EXPECT_TRUE(log.save(0, bytes(1, 0)));
  EXPECT_TRUE(log.save(0xFFFF, bytes(96, 0xFF)));
  EXPECT_TRUE(log.save(3, bytes(5, 2)));
  EXPECT_TRUE(log.save(8, bytes(4, 8)));
  EXPECT_TRUE(log.save(8, {}));
  const Values expected{{0, bytes(1, 0)}, {3, bytes(5, 2)}, {0xFFFF, bytes(96, 0xFF)}};
  EXPECT_EQ(all_of(log), expected);
  EXPECT_EQ(after_power_up(), expected);
}

TEST_F(FlashLogTest, WritesNothingForWhatItHasAlready) {
  FlashLog log{flash};
  EXPECT_TRUE(log.save(3, {}));
  EXPECT_EQ(flash.operations(), 0U) << "nothing to forget";
  EXPECT_TRUE(log.save(3, bytes(4, 1)));
  const std::uint64_t before = flash.operations();
  EXPECT_TRUE(log.save(3, bytes(4, 1)));
  EXPECT_EQ(flash.operations(), before);
}

TEST_F(FlashLogTest, WritesNothingAtAPowerUpAfterWhichNothingWasSaved) {
  FlashLog{flash};
  EXPECT_EQ(flash.operations(), 0U);
  EXPECT_TRUE(FlashLog{flash}.save(3, bytes(4, 1)));
  FlashLog{flash};
  const std::uint64_t before = flash.operations();
  for (int i = 0; i < 5; ++i) FlashLog{flash};
  EXPECT_EQ(flash.operations(), before);
}

TEST_F(FlashLogTest, TakesAnyFlashForAnEmptyLogAndErasesItOnlyToSave) {
  std::mt19937 random{proof::test_seed()};
  for (int fill = 0; fill < 50; ++fill) {
    FlashModel any{2, kWords};
    for (std::size_t i = 0; i < 2 * kWords; ++i) {
      const auto word = static_cast<std::uint32_t>(random());
      any.set_word(i / kWords, i % kWords, fill == 0 ? 0U : fill == 1 ? word % 7 : word);
    }
    FlashLog log{any};
    EXPECT_TRUE(all_of(log).empty());
    EXPECT_EQ(any.operations(), 0U);
    EXPECT_TRUE(log.save(1, bytes(4, 1)));
    FlashLog again{any};
    EXPECT_EQ(all_of(again).size(), 1U);
  }
}

TEST_F(FlashLogTest, DoesNotTakeALogOfAnotherVersion) {
  EXPECT_TRUE(FlashLog{flash}.save(1, bytes(4, 1)));
  const log_format::SectorHead head{.sequence = 1, .erases = 1};
  flash.set_word(0, log_format::kMagicAt, log_format::kMagic + 1);
  flash.set_word(0, log_format::kHeadCrcAt, log_format::head_crc(head, log_format::kMagic + 1));
  EXPECT_TRUE(after_power_up().empty());
  EXPECT_FALSE(FlashLog{flash}.damaged());
}

TEST_F(FlashLogTest, LosesOfADamagedSectorOnlyWhatIsDamaged) {
  FlashLog log{flash};
  for (std::uint16_t number = 1; number <= 5; ++number) {
    EXPECT_TRUE(log.save(number, bytes(8, static_cast<unsigned char>(number))));
  }
  // Each record consists of four words and its mark. Any word of the second record is set to any
  // value.
  std::mt19937 random{proof::test_seed()};
  for (int i = 0; i < 200; ++i) {
    FlashModel damaged = flash;
    const std::size_t place = log_format::kFirstRecord + 5 + i % 4;
    damaged.set_word(0, place, damaged.read(0, place) ^ (1U << (random() % 32)));
    FlashLog again{damaged};
    const Values found = all_of(again);
    EXPECT_EQ(found.size(), 4U);
    EXPECT_FALSE(found.contains(2));
    EXPECT_TRUE(again.damaged());
    EXPECT_TRUE(FlashLog{damaged}.damaged()) << "at each power-up until something is saved";
    EXPECT_TRUE(again.save(2, bytes(8, 9)));
    EXPECT_FALSE(FlashLog{damaged}.damaged());
    for (int k = 0; k < 60; ++k) EXPECT_TRUE(again.save(6, bytes(16, k % 2 == 0)));
    EXPECT_EQ(all_of(again).size(), 6U) << "compaction, too";
  }
}

TEST_F(FlashLogTest, FallsBackToTheSectorBeforeWhenTheLastOneCannotBeRead) {
  FlashLog log{flash};
  EXPECT_TRUE(log.save(1, bytes(4, 1)));
  for (int k = 0; flash.erases(1) == 0; ++k) EXPECT_TRUE(log.save(2, bytes(16, k % 2 == 0)));
  flash.set_word(1, log_format::kSequenceAt, 0);
  EXPECT_EQ(after_power_up()[1], bytes(4, 1));
  EXPECT_TRUE(FlashLog{flash}.damaged());
}

/// Flips each bit of all words that are not erased, and of the two words behind them.
void expect_each_flip_harmless_or_noticed(const FlashModel& flash, const char* state) {
  FlashModel sound = flash;
  FlashLog whole{sound};
  const Values expected = all_of(whole);
  EXPECT_FALSE(whole.damaged()) << state;
  int flips = 0;
  int noticed = 0;
  for (std::size_t sector = 0; sector < flash.sector_count(); ++sector) {
    std::size_t end = flash.words_per_sector();
    while (end > 0 && flash.read(sector, end - 1) == FlashModel::kErased) --end;
    if (end > 0) end = std::min(end + 2, flash.words_per_sector());
    for (std::size_t bit = 0; bit < 32 * end; ++bit) {
      FlashModel flipped = flash;
      flipped.set_word(sector, bit / 32, flash.read(sector, bit / 32) ^ (1U << bit % 32));
      for (int power_up = 0; power_up < 2; ++power_up) {
        FlashLog log{flipped};
        if (power_up == 0) noticed += log.damaged() ? 1 : 0;
        ASSERT_TRUE(log.damaged() || all_of(log) == expected)
            << state << ", sector " << sector << ", word " << bit / 32 << ", bit " << bit % 32
            << ", power-up " << power_up;
      }
      ++flips;
    }
  }
  std::printf("%s: %d flips, %d noticed\n", state, flips, noticed);
}

TEST_F(FlashLogTest, EachBitThatTurnsOverIsHarmlessOrNoticed) {
  {
    FlashLog log{flash};
    EXPECT_TRUE(log.save(1, bytes(4, 1)));
    expect_each_flip_harmless_or_noticed(flash, "one save");
    EXPECT_TRUE(log.save(2, bytes(4, 0)));
    expect_each_flip_harmless_or_noticed(flash, "two saves");
    EXPECT_TRUE(log.save(1, bytes(12, 0xFF)));
    EXPECT_TRUE(log.save(2, {}));
    expect_each_flip_harmless_or_noticed(flash, "another value, and one forgotten");
  }
  FlashLog{flash};
  expect_each_flip_harmless_or_noticed(flash, "after a power-up");
  FlashLog log{flash};
  EXPECT_TRUE(log.save(3, bytes(4, 3)));
  expect_each_flip_harmless_or_noticed(flash, "a save after a power-up");
  for (int k = 0; flash.erases(1) == 0; ++k) EXPECT_TRUE(log.save(4, bytes(16, k % 2 == 0)));
  expect_each_flip_harmless_or_noticed(flash, "in the second sector");
  FlashLog{flash};
  expect_each_flip_harmless_or_noticed(flash, "in the second sector after a power-up");
  FlashLog again{flash};
  for (int k = 0; flash.erases(0) == 1; ++k) EXPECT_TRUE(again.save(4, bytes(16, k % 2 == 0)));
  expect_each_flip_harmless_or_noticed(flash, "in the first sector again");
}

TEST_F(FlashLogTest, RefusesWhatDoesNotFitAndChangesNothing) {
  FlashLog log{flash};
  EXPECT_FALSE(log.save(1, bytes(97, 1)));
  std::uint16_t number = 0;
  while (log.save(number, bytes(96, 7))) ++number;
  EXPECT_EQ(number, (kWords - log_format::kFirstRecord - 1) / 26U);
  const Values full = all_of(log);
  const std::uint64_t operations = flash.operations();
  EXPECT_FALSE(log.save(number, bytes(96, 7)));
  EXPECT_EQ(flash.operations(), operations);
  EXPECT_EQ(all_of(log), full);
  EXPECT_EQ(after_power_up(), full);
  FlashLog again{flash};
  EXPECT_TRUE(again.save(0, bytes(96, 8))) << "another value of the same size";
  EXPECT_TRUE(again.save(1, {})) << "and forgetting";
  EXPECT_TRUE(again.save(number, bytes(96, 7)));
  EXPECT_EQ(after_power_up().size(), full.size());
}

TEST_F(FlashLogTest, CountsErasesAndTakesTurns) {
  FlashLog log{flash};
  EXPECT_EQ(log.wear().erases, 0U);
  for (int k = 0; k < 5000; ++k) EXPECT_TRUE(log.save(2, bytes(4, k % 2 == 0)));
  const std::uint32_t erases = flash.erases(0) + flash.erases(1);
  EXPECT_EQ(log.wear().erases, erases);
  EXPECT_EQ(FlashLog{flash}.wear().erases, erases);
  EXPECT_LE(flash.erases(0) - flash.erases(1), 1U);
  EXPECT_LT(log.wear().bytes_to_next_erase, 4 * kWords);
  EXPECT_LE(erases, 5000U / ((kWords - log_format::kFirstRecord) / 4 - 1) + 1);
}

TEST_F(FlashLogTest, IsFalseWhenFlashRefusesAndKeepsWhatItHad) {
  // Tests both a save with free space and a save that has to compact.
  for (const std::uint32_t room : {600U, 20U}) {
    std::uint64_t needed = 0;
    for (std::uint64_t operations = 0; operations < 40 && needed == 0; ++operations) {
      FlashModel refusing{2, kWords};
      FlashLog log{refusing};
      for (int k = 0; log.wear().bytes_to_next_erase > room || k < 2; ++k) {
        ASSERT_TRUE(log.save(2, bytes(8, k % 2 == 0)));
      }
      Values expected = all_of(log);
      refusing.refuse_after(operations);
      if (log.save(2, bytes(20, 0xAB))) {
        expected[2] = bytes(20, 0xAB);
        needed = operations;
      }
      ASSERT_EQ(all_of(log), expected) << operations;
      FlashLog again{refusing};
      ASSERT_EQ(all_of(again), expected) << operations;
    }
    EXPECT_EQ(needed, room == 600U ? 7U : 14U) << "erase, head, record, mark and commit";
  }
}

TEST_F(FlashLogTest, GoesOnInTheNextSectorWhenAWordIsWornOut) {
  FlashLog log{flash};
  EXPECT_TRUE(log.save(1, bytes(4, 1)));
  // The programmed word reads back with another value.
  flash.set_word(0, log_format::kFirstRecord + 4, 0);
  EXPECT_TRUE(log.save(2, bytes(4, 2)));
  EXPECT_EQ(flash.erases(1), 1U);
  EXPECT_EQ(after_power_up(), (Values{{1, bytes(4, 1)}, {2, bytes(4, 2)}}));
}

TEST_F(FlashLogTest, RemembersWhatAMapRemembers) {
  std::mt19937 random{proof::test_seed()};
  Values expected;
  auto log = std::make_unique<FlashLog>(flash);
  for (int i = 0; i < 20'000; ++i) {
    const auto number = static_cast<std::uint16_t>(random() % 9 * 7);
    const Value value = bytes(random() % 40, static_cast<unsigned char>(random()));
    if (random() % 20 == 0) log = std::make_unique<FlashLog>(flash);
    ASSERT_TRUE(log->save(number, value));
    if (value.empty()) {
      expected.erase(number);
    } else {
      expected[number] = value;
    }
  }
  EXPECT_EQ(after_power_up(), expected);
}

}  // namespace
}  // namespace cnc
