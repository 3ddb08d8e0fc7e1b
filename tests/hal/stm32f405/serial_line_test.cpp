#include "hal/stm32f405/serial_line.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "hal/stm32f405/boards/generic.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

using Line = SerialLine<kGeneric, ModelBus>;
constexpr Address kBase = 0x4001'1000;

class SerialLineTest : public testing::Test {
 protected:
  SerialLineTest() { line_.set_up(kFullSpeed); }

  void arrive(std::string_view bytes, Word damage = 0) {
    for (const char byte : bytes) {
      chip_.to_receive.emplace_back(usart::kReceived | damage, static_cast<Word>(byte));
      line_.on_interrupt();
    }
  }
  /// Begins a cycle, and returns all bytes that have arrived.
  std::string heard() {
    line_.note_turn(++turn_);
    line_.begin_turn(turn_);
    return heard_in_turn();
  }
  std::string heard_in_turn() {
    std::array<std::byte, 4096> bytes{};
    const std::size_t count = line_.read(bytes);
    return {reinterpret_cast<const char*>(bytes.data()), count};
  }

  ChipModel& chip_ = ModelBus::start_anew();
  ByteRings rings_{};
  Line line_{rings_};
  std::uint32_t turn_ = 0;
};

TEST_F(SerialLineTest, RunsAtItsRateFromEitherClock) {
  EXPECT_NEAR(115'200, 84e6 / chip_.cells[kBase + usart::kBaudRate], 115'200 * 0.02);
  line_.set_up(Clocks{});
  EXPECT_NEAR(115'200, 16e6 / chip_.cells[kBase + usart::kBaudRate], 115'200 * 0.02);
}

TEST_F(SerialLineTest, HandsOverWhatArrives) {
  arrive("G1 X1\n?");
  EXPECT_EQ("G1 X1\n?", heard());
  EXPECT_EQ("", heard());
  EXPECT_EQ(0U, line_.lost_bytes());
}

TEST_F(SerialLineTest, ATurnHearsWhatHadComeWhenItBegan) {
  arrive("G1");
  line_.note_turn(6);
  arrive(" X1");
  line_.note_turn(7);
  arrive("\n");
  line_.begin_turn(6);
  EXPECT_EQ("G1", heard_in_turn());
  EXPECT_EQ("", heard_in_turn());
  line_.begin_turn(7);
  EXPECT_EQ(" X1", heard_in_turn());
  line_.note_turn(8);
  line_.begin_turn(8);
  EXPECT_EQ("\n", heard_in_turn());
}

TEST_F(SerialLineTest, ADamagedByteIsMarked) {
  arrive("G1 X");
  arrive("1", bit(1));  // The byte has a framing error.
  arrive("0\n");
  EXPECT_EQ(
      "G1 X\x7F"
      "0\n",
      heard());
  EXPECT_EQ(1U, line_.lost_bytes());
}

TEST_F(SerialLineTest, AnOverrunIsMarkedAlsoWhenNothingElseArrived) {
  chip_.to_receive.emplace_back(bit(3), 'x');
  line_.on_interrupt();
  EXPECT_EQ("\x7F", heard());
}

TEST_F(SerialLineTest, WhatFindsNoRoomIsMarkedWhereItIsMissing) {
  const std::string full(ByteRings::kReceiveBytes, 'a');
  arrive(full + "bc");
  EXPECT_EQ(full, heard());
  EXPECT_EQ(2U, line_.lost_bytes());
  arrive("d\n");
  EXPECT_EQ(
      "\x7F"
      "d\n",
      heard());
}

TEST_F(SerialLineTest, SendsInOrderAndThenStopsAsking) {
  const std::string text = "ok\r\n";
  EXPECT_EQ(text.size(), line_.write(std::as_bytes(std::span{text})));
  EXPECT_FALSE(line_.sent());
  EXPECT_EQ(Line::kInterrupt, chip_.pended.back());
  EXPECT_NE(0U, chip_.cells[kBase + usart::kCr1] & usart::kRoomInterrupt);
  line_.on_interrupt();
  EXPECT_EQ((std::vector<Word>{'o', 'k', '\r', '\n'}), chip_.sent);
  EXPECT_EQ(0U, chip_.cells[kBase + usart::kCr1] & usart::kRoomInterrupt);
  EXPECT_TRUE(line_.sent());
}

TEST_F(SerialLineTest, TakesNoMoreThanItHasRoomFor) {
  const std::string text(2000, 'z');
  EXPECT_EQ(ByteRings::kSendBytes, line_.write(std::as_bytes(std::span{text})));
  EXPECT_EQ(0U, line_.write(std::as_bytes(std::span{text})));
}

}  // namespace
}  // namespace hal::stm32f405
