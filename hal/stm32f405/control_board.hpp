#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/interface/control_board.hpp"
#include "hal/stm32f405/board.hpp"
#include "hal/stm32f405/image.hpp"
#include "hal/stm32f405/reset_cause.hpp"
#include "hal/stm32f405/text_row.hpp"
#include "hal/stm32f405/unique_id.hpp"

namespace hal::stm32f405 {

/// Facts that start-up has determined, and the stack whose use `$I+` reports.
struct StartReport {
  Clocks clocks{};
  ResetCause cause = ResetCause::kUnknown;
  FaultRecord fault{};  ///< Record of the fault; valid if `cause` is ResetCause::kFault.
  std::uint32_t image_bytes = 0;
  std::uint32_t image_checksum = 0;  ///< CRC-32 of the image.
  std::span<const std::uint32_t> stack{};
};

/// A board with an F405 or F407, as `$I+` reports it.
template <const Board& kBoard, RegisterBus Bus = MemoryBus>
class ChipBoard final : public ControlBoard {
 public:
  void set_report(const StartReport& report) { report_ = report; }
  /// Returns whether enter_boot_loader() was called.
  [[nodiscard]] bool wants_boot_loader() const { return wants_boot_loader_; }

  [[nodiscard]] std::size_t describe(std::size_t row, std::span<char> into) override {
    TextRow text{into};
    switch (row) {
      case 0:
        text.text("BOARD:").text(kBoard.name);
        break;
      case 1:
        text.text("DRIVER:STM32F405");
        break;
      case 2:
        text.text("IMAGE:").hexadecimal(report_.image_checksum);
        text.text(",").number(report_.image_bytes);
        break;
      case 3:
        text.text("CLOCK:").number(report_.clocks.core / 1'000'000).text(" MHz,");
        text.text(text_of(report_.clocks.source));
        break;
      case 4:
        text.text("RESET:").text(text_of(report_.cause));
        break;
      case 5:
        stack_row(text);
        break;
      case 6:
        unique_id_row(text);
        break;
      case 7:
        text.text("BROWN-OUT:").text(brown_out_level());
        break;
      default:
        break;
    }
    return text.size();
  }

  [[nodiscard]] std::size_t describe_trouble(std::span<char> into) override {
    TextRow text{into};
    if (report_.cause == ResetCause::kFault) {
      text.text("Restarted after a fault: ").text(text_of(report_.fault.fault));
      if (report_.fault.fault == Fault::kBeam) {
        text.text(", step timer 0x").hexadecimal(report_.fault.place);
      } else {
        text.text(" ").number(report_.fault.exception);
        text.text(" at 0x").hexadecimal(report_.fault.place);
      }
    } else if (report_.cause == ResetCause::kWatchdog) {
      text.text("Restarted by the watchdog");
    } else if (report_.cause == ResetCause::kBrownOut) {
      text.text("Restarted after the supply was too low");
    } else if (report_.clocks.source == ClockSource::kSlow) {
      text.text("The clock does not reach 168 MHz: nothing will move");
    } else if (report_.clocks.source == ClockSource::kInternal) {
      text.text("The crystal does not start: speeds are off by up to 1 %");
    }
    return text.size();
  }

  void enter_boot_loader() override { wants_boot_loader_ = true; }

 private:
  static constexpr const char* text_of(ClockSource source) {
    switch (source) {
      case ClockSource::kCrystal:
        return "crystal";
      case ClockSource::kInternal:
        return "internal";
      case ClockSource::kSlow:
        break;
    }
    return "internal without PLL";
  }
  static constexpr const char* text_of(ResetCause cause) { return stm32f405::text_of(cause); }
  static constexpr const char* text_of(Fault fault) { return stm32f405::text_of(fault); }

  /// Returns the supply voltage below which the chip holds itself in reset (RM0090, 3.9.10, and
  /// VBOR in the data sheet). An option byte determines it, which the board's maker or owner has
  /// set; the firmware does not change it.
  static const char* brown_out_level() {
    static constexpr std::array kLevels{"2.7 V", "2.4 V", "2.1 V", "1.8 V, BOR level 3 is safer"};
    return kLevels[Bus::read(flash::kOptions) >> flash::kBrownOutShift & 3U];
  }

  /// Writes the greatest stack use so far and the size of the stack, in bytes.
  void stack_row(TextRow& text) const {
    const std::size_t used = report_.stack.size() - unused_words(report_.stack);
    text.text("STACK:").number(static_cast<std::uint32_t>(4 * used));
    text.text(",").number(static_cast<std::uint32_t>(4 * report_.stack.size()));
  }

  static void unique_id_row(TextRow& text) {
    text.text("UID:");
    const auto id = unique_id<Bus>();
    if (!id) {
      text.text("unknown");
      return;
    }
    for (const Word word : *id) text.hexadecimal(word);
  }

  StartReport report_{};
  bool wants_boot_loader_ = false;
};

}  // namespace hal::stm32f405
