#pragma once

#include <atomic>
#include <cstdint>
#include <string_view>

namespace cnc {

/// Controls the light of a beam at rest, such as a pierce or a focus dot. The settings limit its
/// duty and its time; by default, no light is allowed.
///
/// The allowed time is a total. It restarts only with a motion or a change of the spindle mode, so
/// that several dwells in a row together get no more light than one dwell.
///
/// Main loop, except allowed(). This function is called by the watch, an interrupt that ends the
/// program if the beam exceeds the duty or the time. The watch uses the allowance, whose memory is
/// checked for flipped bits, and counts the time independently of the main loop.
class RestLight {
 public:
  /// Message to the sender when light was required but not allowed.
  static constexpr std::string_view kRefusalText = "Beam off at rest: $870 and $871 allow light";
  /// Number of periods of the watch in a millisecond.
  static constexpr std::uint32_t kPeriodsPerMs = 4;

  /// Limits of the light by $870 and $871. Light is allowed only if both are above 0.
  struct Allowance {
    std::uint16_t greatest_duty = 0;  ///< 65535 is full power.
    std::int32_t longest_us = 0;
  };

  enum class Wish : std::uint8_t {
    kNone,
    kDwell,  ///< Light immediately, until end().
    kDot,    ///< Light after kDotDelayUs without motion.
  };
  /// Delay before a dot. It is longer than a sender needs between M3 and the next motion, so that
  /// no point is burnt where this motion begins.
  static constexpr std::int32_t kDotDelayUs = 200'000;

  /// Sets the allowance.
  /// @pre not lit
  void configure(const Allowance& allowance);
  [[nodiscard]] const Allowance& allowance() const { return allowance_; }

  void ask(Wish wish);
  void end() { wish_ = Wish::kNone; }
  /// Restarts the allowed time and ends the light, because the machine moves or the spindle mode
  /// was set.
  void renew();
  /// Forgets that light was refused in a program, because the program has ended. A refusal in the
  /// next program is reported again.
  void forget_program() { refusal_ = Refusal::kNone; }
  [[nodiscard]] Wish wish() const { return wish_; }

  /// Returns the duty that the beam must have from now on.
  /// @param elapsed_us time since the last call
  /// @param duty duty that the program requires; 0 if the state of the machine permits no light
  [[nodiscard]] std::uint16_t pass(std::int32_t elapsed_us, std::uint16_t duty);
  [[nodiscard]] bool lit() const { return lit_; }
  /// Starts the count of the watch, before the output is switched on with the duty of pass().
  /// disarm() ends the count, after the output was switched off.
  void arm();
  void disarm() { periods_.store(0, std::memory_order_release); }

  /// Returns whether take_refusal() would return true.
  [[nodiscard]] bool has_refusal() const { return refusal_ == Refusal::kUntold; }
  /// Returns whether light that the program required was refused, or ended because the time was
  /// over. Returns true once in a program.
  [[nodiscard]] bool take_refusal();

  /// Returns the maximum duty of the beam; 0 if the beam must be off. Any context. To be called
  /// once in each period of the watch in which the beam is on at rest.
  [[nodiscard]] std::uint16_t allowed() noexcept;

 private:
  enum class Refusal : std::uint8_t { kNone, kUntold, kTold };
  /// Maximum delay with which the main loop ends the light, in periods of the watch.
  static constexpr std::uint32_t kLatePeriods = 3 * kPeriodsPerMs;

  Allowance allowance_{};
  std::int32_t left_us_ = 0;
  std::int32_t waiting_us_ = 0;  ///< Time since ask(), µs; counted up to the delay of the dot.
  Wish wish_ = Wish::kNone;
  Refusal refusal_ = Refusal::kNone;
  bool lit_ = false;
  std::atomic<std::uint32_t> periods_{0};
};

}  // namespace cnc
