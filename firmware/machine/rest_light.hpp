#pragma once

#include <atomic>
#include <cstdint>
#include <string_view>

namespace cnc {

/// The light that a beam gives at rest, such as a pierce or a focus dot, within the duty and the
/// time that the settings allow. The default allows none.
///
/// The time counts from the last motion, or from the moment when the beam was switched off. So
/// several dwells in a row burn no longer than one.
///
/// Main loop, except allowed(), by which the watch that stops the chip bounds duty and time once
/// more. The watch relies on the allowance, whose memory is checked, and has its own count of the
/// time.
class RestLight {
 public:
  /// Text of a refusal, for the sender.
  static constexpr std::string_view kRefusalText = "Dark at rest: $870, $871";
  /// Periods of the watch in a millisecond.
  static constexpr std::uint32_t kPeriodsPerMs = 4;

  /// Limits by $870 and $871; light requires both to be above 0.
  struct Allowance {
    std::uint16_t greatest_duty = 0;  ///< 65535 is full power.
    std::int32_t longest_us = 0;
  };

  enum class Wish : std::uint8_t {
    kNone,
    kDwell,  ///< Light at once, until end().
    kDot,    ///< Light after kDotDelayUs without motion.
  };
  /// Delay before a dot: longer than a sender needs from M3 to the next motion, which must not
  /// begin with a burn.
  static constexpr std::int32_t kDotDelayUs = 200'000;

  /// Sets the allowance.
  /// @pre not lit
  void configure(const Allowance& allowance);
  [[nodiscard]] const Allowance& allowance() const { return allowance_; }

  void ask(Wish wish);
  void end() { wish_ = Wish::kNone; }
  /// Restarts the allowed time, because the machine moves or the beam was switched off.
  void renew();
  /// Restarts after the end of a program: a refusal in the next program is reported again.
  void forget_program() { refusal_ = Refusal::kNone; }
  [[nodiscard]] Wish wish() const { return wish_; }

  /// Returns the duty from now on.
  /// @param elapsed_us time since the last call
  /// @param duty duty that the program requires; 0 if no light is allowed
  [[nodiscard]] std::uint16_t pass(std::int32_t elapsed_us, std::uint16_t duty);
  [[nodiscard]] bool lit() const { return lit_; }
  /// Starts and ends the watch's count. arm() is called before light that pass() returned, disarm()
  /// after the output is off again.
  void arm();
  void disarm() { periods_.store(0, std::memory_order_release); }

  /// Returns whether take_refusal() will be true.
  [[nodiscard]] bool has_refusal() const { return refusal_ == Refusal::kUntold; }
  /// Returns true once in a program that required light and gets none, or gets none any longer.
  [[nodiscard]] bool take_refusal();

  /// Returns the greatest duty that the beam may have; 0 if it must be off. Any context; to be
  /// called once in each period of the watch in which the beam is on without motion.
  [[nodiscard]] std::uint16_t allowed() noexcept;

 private:
  enum class Refusal : std::uint8_t { kNone, kUntold, kTold };
  /// Greatest lateness of the main loop in ending the light, in periods.
  static constexpr std::uint32_t kLatePeriods = 3 * kPeriodsPerMs;

  Allowance allowance_{};
  std::int32_t left_us_ = 0;
  std::int32_t waiting_us_ = 0;  ///< Time since the wish.
  Wish wish_ = Wish::kNone;
  Refusal refusal_ = Refusal::kNone;
  bool lit_ = false;
  std::atomic<std::uint32_t> periods_{0};
};

}  // namespace cnc
