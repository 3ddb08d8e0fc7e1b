#pragma once

#include <algorithm>
#include <cstdint>

namespace cnc {

/// Measures the time since the last element came, and the time for which elements have been held
/// back.
///
/// If the sender has further elements, it sends them within a few milliseconds. During this time,
/// the last elements are held back, because later elements decide how they are welded and rounded.
class SupplyWatch {
 public:
  /// Restarts the measurement of the time since the last element, because an element has come.
  void restart() { silence_us_ = 0; }
  /// Adds the time that has passed. @param holds whether elements are held back
  void pass(std::int32_t elapsed_us, bool holds) {
    silence_us_ = std::min(silence_us_ + elapsed_us, kSilenceUs);
    held_us_ = holds ? std::min(held_us_ + elapsed_us, kGatheringUs) : 0;
  }

  /// Returns whether the time since the last element is so long that the sender has no element to
  /// send, on the condition that the machine is at rest.
  [[nodiscard]] bool silent_at_rest() const { return silence_us_ >= kSilenceAtRestUs; }
  /// Returns the same for a moving machine. It leaves the sender more time than a machine at rest.
  [[nodiscard]] bool silent() const { return silence_us_ >= kSilenceUs; }
  /// Returns whether the first held element has waited for the gathering time. The wait lets a weld
  /// gather lines before the start, because a motion that begins with few lines starts slowly.
  [[nodiscard]] bool has_gathered() const { return held_us_ >= kGatheringUs; }

 private:
  static constexpr std::int32_t kSilenceAtRestUs = 5'000;
  static constexpr std::int32_t kSilenceUs = 20'000;
  static constexpr std::int32_t kGatheringUs = 10'000;

  std::int32_t silence_us_ = 0;  ///< Time since the last element came.
  std::int32_t held_us_ = 0;     ///< Time for which elements have been held back.
};

}  // namespace cnc
