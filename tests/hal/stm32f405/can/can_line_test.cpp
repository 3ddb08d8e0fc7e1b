#include "hal/stm32f405/can/can_line.hpp"

#include <gtest/gtest.h>

#include "hal/stm32f405/boards/generic.hpp"
#include "tests/hal/stm32f405/can/can_model.hpp"

namespace hal::stm32f405 {
namespace {

using Line = CanLine<kGenericCan, CanBus>;
using Mail = CanModel::Mail;

CanFrame frame_of(std::uint32_t id, std::initializer_list<int> bytes, bool extended = false) {
  CanFrame frame{.id = id, .extended = extended};
  for (const int byte : bytes) frame.data[frame.length++] = static_cast<std::byte>(byte);
  return frame;
}

TEST(CanTiming, IsExactAndLooksNearSevenEighths) {
  for (const std::uint32_t rate : {125'000U, 250'000U, 500'000U, 800'000U, 1'000'000U}) {
    for (const std::uint32_t clock : {42'000'000U, 16'000'000U}) {
      const CanTiming timing = can_timing(clock, rate);
      if (clock % rate != 0) {
        EXPECT_FALSE(timing.exists());
        continue;
      }
      ASSERT_TRUE(timing.exists()) << clock << " " << rate;
      EXPECT_EQ(clock, rate * timing.prescaler * timing.quanta());
      EXPECT_NEAR(875, timing.sample_point(), 25) << clock << " " << rate;
      EXPECT_TRUE(timing.before >= 1 && timing.before <= 16);
      EXPECT_TRUE(timing.after >= 1 && timing.after <= 8);
      EXPECT_TRUE(timing.jump() >= 1 && timing.jump() <= 4 && timing.jump() <= timing.after);
    }
  }
  EXPECT_FALSE(can_timing(42'000'000, 0).exists());
  EXPECT_FALSE(can_timing(42'000'000, 10'000'000).exists());
}

TEST(CanTiming, IsWrittenAsTheManualHasIt) {
  // A bit of 14 quanta (1 + 11 + 2) of 3 clocks.
  EXPECT_EQ(1U << 24 | 1U << 20 | 10U << 16 | 2U, can_timing(42'000'000, 1'000'000).word());
}

class CanLineTest : public testing::Test {
 protected:
  CanLineTest() {
    CanBus::can() = {};
    const std::array<CanFilter, 3> filters{
        {{.kind = CanFilter::Kind::kList, .fifo = 0, .id = 0x000, .other = 0x201},
         {.kind = CanFilter::Kind::kMask, .fifo = 1, .id = 0x300, .other = 0x7F0},
         {.kind = CanFilter::Kind::kMask,
          .fifo = 1,
          .extended = true,
          .id = 0x1234'5678,
          .other = 0x1FFF'FF00}}};
    EXPECT_TRUE(line_.set_up(kFullSpeed, filters));
  }
  ~CanLineTest() override { EXPECT_TRUE(can_.misuse.empty()) << can_.misuse.front(); }

  void speak() {
    EXPECT_TRUE(line_.speak(Line::Voice::kSpeaking));
    line_.on_interrupt();
  }

  ChipModel& chip_ = ModelBus::start_anew();
  CanModel& can_ = CanBus::can();
  Line line_;
};

TEST_F(CanLineTest, IsSilentUntilToldToSpeak) {
  EXPECT_EQ(1U, can_.timing >> 31);
  EXPECT_EQ(0U, can_.status & 3U);
  ASSERT_TRUE(line_.send(frame_of(1, {1})));
  line_.on_interrupt();
  EXPECT_TRUE(can_.requested.empty());
  speak();
  EXPECT_EQ(0U, can_.timing >> 30);
  EXPECT_EQ(1U, can_.requested.size());
  EXPECT_TRUE(line_.speak(Line::Voice::kSilent));
  EXPECT_EQ(1U, can_.timing >> 31);
}

TEST_F(CanLineTest, HasItsPinsAndFilters) {
  EXPECT_EQ(2U, chip_.mode_of(pd(0)));
  EXPECT_EQ(2U, chip_.mode_of(pd(1)));
  EXPECT_EQ(0x99U, chip_.cells[gpio::alternate(3, 0)] & 0xFFU);
  EXPECT_EQ(0U, can_.filter_master & 1U);
  EXPECT_EQ(7U, can_.filters_on);
  EXPECT_EQ(7U, can_.wide);
  EXPECT_EQ(1U, can_.lists);
  EXPECT_EQ(6U, can_.second);
  EXPECT_EQ(0U, can_.banks[0][0]);
  EXPECT_EQ(0x201U << 21, can_.banks[0][1]);
  EXPECT_EQ(0x300U << 21, can_.banks[1][0]);
  EXPECT_EQ(0x7F0U << 21 | 4U, can_.banks[1][1]);
  EXPECT_EQ(0x1234'5678U << 3 | 4U, can_.banks[2][0]);
  EXPECT_EQ(0x1FFF'FF00U << 3 | 4U, can_.banks[2][1]);
}

TEST_F(CanLineTest, SendsInOrderThroughThreeMailboxes) {
  constexpr int kFrames = Line::kSendFrames;
  speak();
  for (int i = 0; i < kFrames; ++i) ASSERT_TRUE(line_.send(frame_of(0x100U - i, {i, 2 * i})));
  line_.on_interrupt();
  EXPECT_NE(0U, can_.master & 1U << 2) << "in the order of requests";
  EXPECT_NE(0U, can_.master & 1U << 6) << "back from bus-off by itself";
  for (unsigned i = 0; i < Line::kSendFrames; ++i) {
    ASSERT_EQ(std::min(3U, Line::kSendFrames - i), can_.requested.size());
    const Mail mail = can_.take_sent();
    EXPECT_EQ((0x100 - i) << 21, mail[0] & ~1U);
    EXPECT_EQ(2U, mail[1]);
    EXPECT_EQ(i | 2 * i << 8, mail[2]);
    line_.on_interrupt();
  }
  EXPECT_EQ(0U, can_.transmitted) << "what was done is acknowledged";
}

TEST_F(CanLineTest, HearsOtherIdentifiersWhenItIsToldTo) {
  const std::array<std::uint32_t, 6> heard{0x000, 0x001, 0x211, 0x511, 0x77F, 0x7E5};
  line_.hear_only(heard, 3);
  EXPECT_EQ(0U, can_.filter_master & 1U);
  EXPECT_EQ(15U, can_.filters_on);
  EXPECT_EQ(15U, can_.lists & 15U);
  EXPECT_EQ(12U, can_.second) << "what is urgent has a FIFO of its own";
  const std::array<std::array<std::uint32_t, 2>, 4> pairs{
      {{0x000, 0x001}, {0x211, 0x211}, {0x511, 0x77F}, {0x7E5, 0x7E5}}};
  for (std::size_t bank = 0; bank < pairs.size(); ++bank) {
    EXPECT_EQ(pairs[bank][0] << 21, can_.banks[bank][0]);
    EXPECT_EQ(pairs[bank][1] << 21, can_.banks[bank][1]);
  }
}

TEST_F(CanLineTest, WritesEveryKindOfFrame) {
  speak();
  ASSERT_TRUE(line_.send(frame_of(0x1ABC'DEF0, {1, 2, 3, 4, 5, 6, 7, 8}, true)));
  ASSERT_TRUE(line_.send({.id = 0x7FF, .remote = true, .length = 4}));
  ASSERT_FALSE(line_.send({.id = 1, .length = 9}));
  line_.on_interrupt();
  EXPECT_EQ((Mail{0x1ABC'DEF0U << 3 | 5U, 8, 0x0403'0201, 0x0807'0605}), can_.mailboxes[0]);
  EXPECT_EQ((Mail{0x7FFU << 21 | 3U, 4, 0, 0}), can_.mailboxes[1]);
}

TEST_F(CanLineTest, ReadsEveryKindOfFrameFromBothFifos) {
  can_.arrive(0, {0x201U << 21, 0x0000'0502, 0xFFFF'2211, 0xFFFF'FFFF});
  can_.arrive(1, {0x1ABC'DEF0U << 3 | 4U, 15, 0x0403'0201, 0x0807'0605});
  can_.arrive(1, {0x300U << 21 | 2U, 3, 0, 0});
  line_.on_interrupt();
  CanFrame frame;
  ASSERT_TRUE(line_.receive(frame));
  EXPECT_EQ(frame_of(0x201, {0x11, 0x22}), frame);
  ASSERT_TRUE(line_.receive(frame));
  EXPECT_EQ(frame_of(0x1ABC'DEF0, {1, 2, 3, 4, 5, 6, 7, 8}, true), frame);
  ASSERT_TRUE(line_.receive(frame));
  EXPECT_EQ((CanFrame{.id = 0x300, .remote = true, .length = 3}), frame);
  EXPECT_FALSE(line_.receive(frame));
  EXPECT_EQ(0U, line_.health().lost_frames);
}

TEST_F(CanLineTest, CountsWhatIsLost) {
  for (unsigned i = 0; i < Line::kReceiveFrames + 2; ++i) {
    can_.arrive(0, {i << 21, 0, 0, 0});
    line_.on_interrupt();
  }
  EXPECT_EQ(2U, line_.health().lost_frames);
  CanFrame frame;
  for (unsigned i = 0; i < Line::kReceiveFrames; ++i) {
    ASSERT_TRUE(line_.receive(frame));
    EXPECT_EQ(i, frame.id);
  }
  for (int i = 0; i < 4; ++i) can_.arrive(1, {});
  line_.on_interrupt();
  EXPECT_EQ(3U, line_.health().lost_frames);
  EXPECT_FALSE(can_.fifos[1].overrun);
}

TEST_F(CanLineTest, TellsItsStateAndCountsBusOffs) {
  EXPECT_EQ(CanState::kActive, line_.health().state);
  can_.errors = 100U << 24 | 96U << 16 | 1U;
  EXPECT_EQ(CanState::kWarning, line_.health().state);
  EXPECT_EQ(96U, line_.health().transmit_errors);
  EXPECT_EQ(100U, line_.health().receive_errors);
  can_.errors |= 2U;
  EXPECT_EQ(CanState::kPassive, line_.health().state);
  can_.errors |= 4U;
  can_.status |= 4U;
  line_.on_interrupt();
  line_.on_interrupt();
  EXPECT_EQ(CanState::kBusOff, line_.health().state);
  EXPECT_EQ(1U, line_.health().bus_offs) << "told once";
}

TEST_F(CanLineTest, IsNotThereWithoutTheCrystalOrAnAnswer) {
  Clocks internal = kFullSpeed;
  internal.source = ClockSource::kInternal;
  Line other;
  EXPECT_FALSE(other.set_up(internal, {}));
  can_.answers = false;
  EXPECT_FALSE(other.set_up(kFullSpeed, {}));
  EXPECT_FALSE(other.set_up(kFullSpeed, std::array<CanFilter, 15>{}));
}

}  // namespace
}  // namespace hal::stm32f405
