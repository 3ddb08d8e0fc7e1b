/// Runs the driver of CAN1 on the emulated chip: in loopback first, then silent, then sending.
/// Prints each received frame and the state of the bus; can_driver.py sets up the bus.

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/stm32f405/boards/generic.hpp"
#include "hal/stm32f405/can/can_line.hpp"
#include "hal/stm32f405/clock.hpp"
#include "hal/stm32f405/time_base.hpp"
#include "tests/target/start_up.hpp"

namespace {

namespace chip = hal::stm32f405;
using Line = chip::CanLine<chip::kGenericCan>;
using Routine = void (*)();

constexpr unsigned kToItself = 5;
constexpr unsigned kToOthers = 24;  ///< Number of frames, more than the driver has space for.
constexpr std::uint32_t kFirstId = 0x300;

constinit Line line{};
constinit chip::TimeBase<> time{};

constexpr std::size_t kTick = 15;
constexpr std::size_t kFirstInterrupt = 16;
alignas(512) constinit std::array<Routine, kFirstInterrupt + chip::interrupt::kCount> vectors{};

void on_can() { line.on_interrupt(); }
void on_tick() { time.on_interrupt(); }
void on_other() {
  write_text("unexpected exception\n");
  for (;;) {
  }
}

/// Prints lines `name number number…`, hexadecimal.
class Telling {
 public:
  explicit Telling(const char* name) {
    while (*name != '\0') put(*name++);
  }
  Telling& number(std::uint32_t value) {
    put(' ');
    for (unsigned digit = 8; digit-- > 0;) put("0123456789abcdef"[value >> (4 * digit) & 0xFU]);
    return *this;
  }
  void end() {
    put('\n');
    text_[size_] = '\0';
    write_text(text_.data());
  }

 private:
  void put(char letter) {
    if (size_ + 1 < text_.size()) text_[size_++] = letter;
  }

  std::array<char, 96> text_{};
  std::size_t size_ = 0;
};

void tell_received() {
  hal::CanFrame frame;
  while (line.receive(frame)) {
    std::uint32_t low = 0;
    for (std::size_t at = 0; at < 4; ++at)
      low |= static_cast<std::uint32_t>(frame.data[at]) << 8 * at;
    Telling{"received"}.number(frame.id).number(frame.length).number(low).end();
  }
}

void tell_health() {
  const hal::CanHealth health = line.health();
  Telling{"health"}
      .number(static_cast<std::uint32_t>(health.state))
      .number(health.transmit_errors)
      .number(health.receive_errors)
      .number(health.bus_offs)
      .number(health.lost_frames)
      .end();
}

void listen(std::uint32_t milliseconds) {
  const hal::TickCount end = time.now().plus(1000 * milliseconds);
  while (!time.now().reached(end)) tell_received();
}

void send(unsigned count) {
  for (unsigned i = 0; i < count; ++i) {
    hal::CanFrame frame{.id = kFirstId + i, .length = static_cast<std::uint8_t>(i % 9)};
    for (unsigned at = 0; at < frame.length; ++at) frame.data[at] = static_cast<std::byte>(i + at);
    for (unsigned wait = 0; wait < 200 && !line.send(frame); ++wait) listen(1);
  }
}

void begin() {
  vectors.fill(on_other);
  vectors[kTick] = on_tick;
  for (unsigned number = 19; number <= 22; ++number) vectors[kFirstInterrupt + number] = on_can;
  chip::MemoryBus::write(chip::core::kVectors,
                         static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(&vectors)));
  const chip::Clocks clocks = chip::ClockStart<chip::MemoryBus>::run(8'000'000);
  time.set_up(clocks);
  constexpr std::array<chip::CanFilter, 3> kFilters{
      {{.kind = chip::CanFilter::Kind::kList, .fifo = 0, .id = 0x001, .other = 0x123},
       {.kind = chip::CanFilter::Kind::kMask, .fifo = 1, .id = 0x2A0, .other = 0x7F0},
       {.kind = chip::CanFilter::Kind::kMask, .fifo = 1, .id = kFirstId, .other = 0x7C0}}};
  Telling{"ready"}.number(line.set_up(clocks, kFilters) ? 1 : 0).end();
}

}  // namespace

void run_on_target() {
  begin();
  Telling{"alone"}.number(line.speak(Line::Voice::kToItself) ? 1 : 0).end();
  send(kToItself);
  listen(5);
  tell_health();
  Telling{"silent"}.number(line.speak(Line::Voice::kSilent) ? 1 : 0).end();
  listen(15);
  tell_health();
  Telling{"speaks"}.number(line.speak(Line::Voice::kSpeaking) ? 1 : 0).end();
  send(kToOthers);
  listen(60);
  tell_health();
}
