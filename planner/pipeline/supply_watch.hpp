#pragma once

#include <algorithm>
#include <cstdint>

namespace cnc {

/// Measures how long no element has come, and how long elements have been held back.
///
/// A sender with more to send does so within a few milliseconds. Until then the last elements are
/// held back, because the ones after them decide how they are welded and rounded.
class SupplyWatch {
 public:
  /// An element has come.
  void restart() { silence_us_ = 0; }
  /// Time has passed.
  /// @param holds elements are held back
  void pass(std::int32_t elapsed_us, bool holds) {
    silence_us_ = std::min(silence_us_ + elapsed_us, kSilenceUs);
    held_us_ = holds ? std::min(held_us_ + elapsed_us, kGatheringUs) : 0;
  }

  /// Returns whether a sender that could have sent an element to the standing machine has none.
  [[nodiscard]] bool silent_at_rest() const { return silence_us_ >= kSilenceAtRestUs; }
  /// The same while the machine moves, which leaves the sender more time.
  [[nodiscard]] bool silent() const { return silence_us_ >= kSilenceUs; }
  /// Returns whether the first held element has waited long enough: a weld of few lines makes a
  /// slow start.
  [[nodiscard]] bool has_gathered() const { return held_us_ >= kGatheringUs; }

 private:
  static constexpr std::int32_t kSilenceAtRestUs = 5'000;
  static constexpr std::int32_t kSilenceUs = 20'000;
  static constexpr std::int32_t kGatheringUs = 10'000;

  std::int32_t silence_us_ = 0;  ///< Since the last element.
  std::int32_t held_us_ = 0;     ///< Since elements have been held back.
};

}  // namespace cnc
