#include "hal/stm32f405/control_board.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "hal/stm32f405/boards/generic.hpp"
#include "hal/stm32f405/protection.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

std::string row_of(ControlBoard& board, std::size_t row) {
  std::array<char, 80> text{};
  return {text.data(), board.describe(row, text)};
}
std::string trouble_of(ControlBoard& board) {
  std::array<char, 120> text{};
  return {text.data(), board.describe_trouble(text)};
}

TEST(ChipBoard, TellsWhatItIs) {
  ChipModel& chip = ModelBus::start_anew();
  std::array<std::uint32_t, 16> stack{};
  stack.fill(kPaint);
  stack[12] = 0;
  ChipBoard<kGeneric, ModelBus> board;
  board.set_report({.clocks = kFullSpeed,
                    .cause = ResetCause::kPowerOn,
                    .image_bytes = 187'972,
                    .image_checksum = 0xB2CB'D1E6,
                    .stack = stack});
  EXPECT_EQ("BOARD:Generic F405/F407", row_of(board, 0));
  EXPECT_EQ("DRIVER:STM32F405", row_of(board, 1));
  EXPECT_EQ("IMAGE:b2cbd1e6,187972", row_of(board, 2));
  EXPECT_EQ("CLOCK:168 MHz,crystal", row_of(board, 3));
  EXPECT_EQ("RESET:power on", row_of(board, 4));
  EXPECT_EQ("STACK:16,64", row_of(board, 5));
  EXPECT_EQ("UID:unknown", row_of(board, 6));
  chip.cells[kDeviceCode] = 0x1000'0413;
  chip.cells[kUniqueId] = 0x0012'3456;
  EXPECT_EQ("UID:001234560000000000000000", row_of(board, 6));
  EXPECT_EQ("BROWN-OUT:2.7 V", row_of(board, 7));
  chip.cells[flash::kOptions] = 0x0FFF'AAED;  // Option bytes as the chips are delivered.
  EXPECT_EQ("BROWN-OUT:1.8 V, BOR level 3 is safer", row_of(board, 7));
  chip.cells[flash::kOptions] = 0x0FFF'AAE5;
  EXPECT_EQ("BROWN-OUT:2.4 V", row_of(board, 7));
  EXPECT_EQ("", row_of(board, 8));
  EXPECT_EQ("", trouble_of(board));
}

TEST(ChipBoard, CutsOffWhatDoesNotFit) {
  ModelBus::start_anew();
  ChipBoard<kGeneric, ModelBus> board;
  std::array<char, 5> text{};
  EXPECT_EQ(5U, board.describe(0, text));
  EXPECT_EQ("BOARD", std::string(text.data(), text.size()));
}

TEST(ChipBoard, TellsWhatWasWrong) {
  ModelBus::start_anew();
  ChipBoard<kGeneric, ModelBus> board;
  board.set_report({.clocks = kFullSpeed, .cause = ResetCause::kWatchdog});
  EXPECT_EQ("Restarted by the watchdog", trouble_of(board));
  board.set_report({.clocks = kFullSpeed,
                    .cause = ResetCause::kFault,
                    .fault = {.mark = FaultRecord::kValid,
                              .fault = Fault::kException,
                              .exception = 3,
                              .place = 0x0800'2120}});
  EXPECT_EQ("Restarted after a fault: exception 3 at 0x08002120", trouble_of(board));
  board.set_report({.clocks = kFullSpeed,
                    .cause = ResetCause::kFault,
                    .fault = {.mark = FaultRecord::kValid,
                              .fault = Fault::kBeam,
                              .exception = 0,
                              .place = 0xFFFF'FFE0}});
  EXPECT_EQ("Restarted after a fault: the beam was on at rest, step timer 0xffffffe0",
            trouble_of(board));
  board.set_report({.clocks = Clocks{}, .cause = ResetCause::kPowerOn});
  EXPECT_EQ("The clock does not reach 168 MHz: nothing will move", trouble_of(board));
}

TEST(ResetCause, TellsTheRealOneOfSeveralFlags) {
  const Word pin = rcc::kPinReset;
  EXPECT_EQ(ResetCause::kPowerOn, cause_of(rcc::kPowerOnReset | rcc::kBrownOutReset | pin, false));
  EXPECT_EQ(ResetCause::kBrownOut, cause_of(rcc::kBrownOutReset | pin, false));
  EXPECT_EQ(ResetCause::kWatchdog, cause_of(rcc::kWatchdogReset | pin, false));
  EXPECT_EQ(ResetCause::kSoftware, cause_of(rcc::kSoftwareReset | pin, false));
  EXPECT_EQ(ResetCause::kFault, cause_of(rcc::kSoftwareReset | pin, true));
  EXPECT_EQ(ResetCause::kPin, cause_of(pin, false));
  EXPECT_EQ(ResetCause::kUnknown, cause_of(0, false));
}

TEST(Protection, TheGuardIsOneRegionWithoutAnyAccess) {
  ChipModel& chip = ModelBus::start_anew();
  guard_stack<ModelBus>(0x2000'0000);
  EXPECT_EQ(0x2000'0000U, chip.cells[core::kRegionBase]);
  EXPECT_EQ(0U, chip.cells[core::kRegionSize] >> 24 & 7U) << "no access";
  EXPECT_EQ(7U, chip.cells[core::kRegionSize] >> 1 & 0x1FU) << "of 256 bytes";
  EXPECT_EQ(5U, chip.cells[core::kProtection]);
}

}  // namespace
}  // namespace hal::stm32f405
