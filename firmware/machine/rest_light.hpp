#pragma once

#include <atomic>
#include <cstdint>
#include <string_view>

namespace cnc {

/// The light that a beam gives where nothing moves, such as a pierce or a focus dot: within the
/// duty and the time that the settings allow, which as delivered is none.
///
/// The time counts from the last motion, or from when the beam was switched off. So dwells in a row
/// burn no longer than one does.
///
/// Main loop but for allowed(), which bounds duty and time once more for the watch that stops the
/// chip: it believes the allowance, whose memory is checked, and counts by itself.
class RestLight {
 public:
  /// What a sender is told of a refusal.
  static constexpr std::string_view kRefusalText = "Dark at rest: $870, $871";
  /// Periods of the watch in a millisecond.
  static constexpr std::uint32_t kPeriodsPerMs = 4;

  /// $870 and $871. Light needs both.
  struct Allowance {
    std::uint16_t greatest_duty = 0;  ///< 65535 is full.
    std::int32_t longest_us = 0;
  };

  enum class Wish : std::uint8_t {
    kNone,
    kDwell,  ///< At once, until end().
    kDot,    ///< When nothing has moved for kDotDelayUs.
  };
  /// Longer than a sender needs from M3 to the motion after it, which must not begin with a burn.
  static constexpr std::int32_t kDotDelayUs = 200'000;

  /// @pre not lit
  void configure(const Allowance& allowance);
  [[nodiscard]] const Allowance& allowance() const { return allowance_; }

  void ask(Wish wish);
  void end() { wish_ = Wish::kNone; }
  /// Something moves, or the beam was switched off: the next light may be as long as any.
  void renew();
  /// The program is over: the next one is told of a refusal again.
  void forget_program() { refusal_ = Refusal::kNone; }
  [[nodiscard]] Wish wish() const { return wish_; }

  /// Returns the duty from now on.
  /// @param elapsed_us since the last call
  /// @param duty what the program means; 0 where nothing may be lit
  [[nodiscard]] std::uint16_t pass(std::int32_t elapsed_us, std::uint16_t duty);
  [[nodiscard]] bool lit() const { return lit_; }
  /// Before light that pass() returned, and after the output is dark again.
  void arm();
  void disarm() { periods_.store(0, std::memory_order_release); }

  /// Returns whether take_refusal() will be true.
  [[nodiscard]] bool has_refusal() const { return refusal_ == Refusal::kUntold; }
  /// True once in a program that asked for light and gets none, or none any more.
  [[nodiscard]] bool take_refusal();

  /// Any context, once in each of the watch's periods in which the beam is lit without motion.
  /// Returns the greatest duty that it may have; 0 where it must be dark.
  [[nodiscard]] std::uint16_t allowed() noexcept;

 private:
  enum class Refusal : std::uint8_t { kNone, kUntold, kTold };
  /// Of the main loop, which may be late by that when it ends the light.
  static constexpr std::uint32_t kLatePeriods = 3 * kPeriodsPerMs;

  Allowance allowance_{};
  std::int32_t left_us_ = 0;
  std::int32_t waiting_us_ = 0;  ///< Since the wish.
  Wish wish_ = Wish::kNone;
  Refusal refusal_ = Refusal::kNone;
  bool lit_ = false;
  std::atomic<std::uint32_t> periods_{0};
};

}  // namespace cnc
