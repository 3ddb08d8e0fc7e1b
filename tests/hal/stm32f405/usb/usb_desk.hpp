#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "hal/stm32f405/boards/generic.hpp"
#include "hal/stm32f405/usb/usb_line.hpp"
#include "tests/hal/stm32f405/usb/usb_host.hpp"

namespace hal::stm32f405 {

/// A serial line over USB on the core's model, connected to a host.
class UsbDesk {
 public:
  using Line = UsbLine<kGeneric, UsbBus>;
  using Bytes = UsbHost::Bytes;
  using Shake = UsbHost::Shake;

  explicit UsbDesk(std::uint64_t seed = 1, Clocks clocks = kFullSpeed)
      : chip{ModelBus::start_anew()}, host{start_core(), [this] { serve(); }, seed} {
    chip.cells[kDeviceCode] = 0x1000'0413;
    for (Address word = 0; word < 3; ++word) chip.cells[kUniqueId + 4 * word] = 0x1234'ABC0 + word;
    line.set_up(clocks);
  }

  /// Runs the interrupt until none is requested.
  void serve() {
    for (int calls = 0;; ++calls) {
      const auto asked = std::find(chip.pended.begin(), chip.pended.end(), Line::kInterrupt);
      if (asked == chip.pended.end() && !core.interrupts()) return;
      chip.pended.clear();
      line.on_interrupt();
      if (calls == 100) {
        ADD_FAILURE() << "the interrupt never ends";
        return;
      }
    }
  }

  /// Returns the bytes that the main loop reads now.
  std::string hear(std::size_t most = 4096) {
    std::string text(most, '\0');
    begin_turn();
    text.resize(line.read(std::as_writable_bytes(std::span{text})));
    serve();
    return text;
  }
  std::size_t say(std::string_view text) {
    const std::size_t taken = line.write(std::as_bytes(std::span{text}));
    serve();
    return taken;
  }
  /// Begins a cycle, from which on all arrived bytes may be read.
  void begin_turn() {
    line.note_turn(++turn_);
    line.begin_turn(turn_);
  }
  [[nodiscard]] bool ready() { return host.enumerate() && host.open(); }

  ChipModel& chip;
  OtgModel& core = UsbBus::core();
  UsbRings rings{};
  Line line{rings};
  UsbHost host;

 private:
  static OtgModel& start_core() { return UsbBus::core() = {}; }

  std::uint32_t turn_ = 0;
};

inline UsbDesk::Bytes bytes_in(std::string_view text) { return {text.begin(), text.end()}; }
inline std::string text_of(const UsbDesk::Bytes& bytes) { return {bytes.begin(), bytes.end()}; }
/// Returns the text of a string descriptor.
inline std::string letters_of(const UsbDesk::Bytes& descriptor) {
  std::string text;
  for (std::size_t at = 2; at + 1 < descriptor.size(); at += 2) {
    text += static_cast<char>(descriptor[at]);
  }
  return text;
}
/// Returns `bytes` bytes, each different from its neighbours.
inline std::string pattern(std::size_t bytes, unsigned from = 0) {
  std::string text(bytes, '\0');
  for (std::size_t at = 0; at < bytes; ++at) {
    text[at] = static_cast<char>((at + from) * 167 + (at + from) / 256);
  }
  return text;
}

/// Fails if the driver did anything that the manual forbids.
class UsbTest : public testing::Test {
 protected:
  void TearDown() override {
    EXPECT_TRUE(UsbBus::core().misuse.empty()) << UsbBus::core().misuse.front();
  }
};

}  // namespace hal::stm32f405
