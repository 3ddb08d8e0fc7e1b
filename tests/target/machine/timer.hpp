#pragma once

#include <array>
#include <cstdint>

#include "tests/target/machine/peripheral.hpp"

namespace machine {

struct TimerKind {
  Place place;
  Bus bus;
  unsigned update_interrupt;
  unsigned compare_interrupt;
  unsigned channels;
  bool is_wide = false;    // Whether the counter has 32 bits instead of 16.
  bool has_break = false;  // Whether the timer has BDTR, whose MOE enables the outputs.
};

/// Model of a timer that counts up (RM0090, 17 to 20): prescaler, auto-reload with or without
/// preload, one-pulse mode, update and compare events with their flags and interrupts, PWM and
/// forced outputs, which are traced. Time is counted in exact clocks of the timer, so that periods
/// add up without error.
///
/// Not modelled but reported: counting down or centred, repetition, slave modes, input capture. A
/// counter starts with the write that enables it, not a clock later.
class Timer final : public Peripheral, public ClockFollower {
 public:
  Timer(const Services& services, const TimerKind& kind);

  void reset() override;
  void before_clock_change() override;
  void after_clock_change() override;

 private:
  static constexpr unsigned kChannels = 4;
  using Ticks = std::int64_t;

  /// Level of an output from now on: `z` not driven, `0` or `1` steady, `p` pulses.
  struct Course {
    char kind = 'z';
    Ticks on = 0, period = 0;
    bool operator==(const Course&) const = default;
  };
  struct Channel {
    std::uint32_t compare = 0;  // Value that the counter is compared with.
    std::uint32_t preload = 0;  // Value that was last written.
    Course course;
  };

  [[nodiscard]] std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void write_control(std::uint32_t value);
  void write_compare(unsigned index, std::uint32_t value);
  void write_reload(std::uint32_t value);

  [[nodiscard]] Ticks clock() const;
  [[nodiscard]] std::int64_t ns_of(Ticks ticks) const;
  [[nodiscard]] bool counting() const { return (control_ & 1U) != 0; }
  [[nodiscard]] Ticks step() const { return Ticks{prescaler_} + 1; }
  [[nodiscard]] std::uint32_t count() const;
  [[nodiscard]] Ticks overflow() const;
  [[nodiscard]] Ticks period() const { return (Ticks{reload_} + 1) * step(); }
  [[nodiscard]] bool blocked() const { return reload_ == 0; }
  [[nodiscard]] std::uint32_t mode_bits(unsigned index) const;
  [[nodiscard]] bool preload_waits() const;
  [[nodiscard]] Ticks next_event() const;
  [[nodiscard]] Course course_of(unsigned index) const;
  void set_place(Ticks place);
  void set_counting(bool on);
  void generate(std::uint32_t events);
  void advance();
  void note_matches(Ticks until);
  void wrap(Ticks at);
  void load_preloaded();
  void settle();

  TimerKind kind_;
  std::uint32_t widest_;
  InterruptLine update_line_, compare_line_;
  Alarm alarm_;
  std::array<std::uint32_t, 0x54 / 4> kept_{};  // Values of registers without their own member.
  std::uint32_t control_ = 0, enables_ = 0, flags_ = 0;
  std::uint32_t prescaler_ = 0, prescaler_preload_ = 0;
  std::uint32_t reload_ = 0, reload_preload_ = 0;
  // Whether the counter has passed the reload value and counts on to its widest value.
  bool misses_reload_ = false;
  Ticks origin_ = 0;  // Clock at which the counter was 0, while it counts.
  Ticks place_ = 0;   // Clocks since the counter was 0, while it is stopped.
  Ticks seen_ = 0;    // Clock up to which matches have been recorded.
  std::array<Channel, kChannels> channels_{};
};

}  // namespace machine
