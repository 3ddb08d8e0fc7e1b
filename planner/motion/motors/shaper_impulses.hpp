#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cnc::motion {

/// Input shapers; the numbers are those of `$810`.
enum class ShaperKind : std::uint8_t { kNone, kZv, kZvd, kMzv, kEi };

/// What an axis swings like, and the shaper that keeps it from swinging.
struct ShaperSetting {
  static constexpr float kLeastFrequency = 10.0F;
  static constexpr float kMostFrequency = 200.0F;
  static constexpr float kMostDamping = 0.5F;

  ShaperKind kind = ShaperKind::kNone;
  float frequency_hz = 40.0F;  ///< Undamped.
  float damping = 0.0F;        ///< Ratio; 1 would be critical.
  constexpr bool operator==(const ShaperSetting&) const = default;
};

/// A shaped place is Σ amplitude · place(t − delay).
///
/// With amplitudes above 0 that sum to 1 it is a mean of places that were: no
/// derivative of it is ever greater than the greatest of the place's own, and
/// it comes to rest where the place does.
struct ShaperImpulses {
  static constexpr std::size_t kMost = 3;

  std::size_t count = 1;
  std::array<float, kMost> amplitude{1.0F};
  std::array<float, kMost> delay_s{};  ///< From 0, increasing.

  /// s: how far the shaped place of an even motion is behind.
  [[nodiscard]] float mean_delay_s() const;
};

/// The impulses of a shaper. With the damped period T = 1 / (f √(1 − ζ²)) and
/// K = e^(−πζ / √(1 − ζ²)), the decay of a swing in half of it:
///
/// | kind | amplitudes before scaling | delays | residual swing at f, source |
/// |---|---|---|---|
/// | ZV | 1, K | 0, T/2 | none; Singer and Seering 1990 |
/// | ZVD | 1, 2 K, K² | 0, T/2, T | none, and level there; Singer and Seering 1990 |
/// | MZV | a, (√2 − 1) k, a k² | 0, 3T/8, 3T/4 | none; a = 1 − 1/√2, k = K^(3/4) |
/// | EI | 1 + V, 2 (1 − V) K, (1 + V) K² | 0, T/2, T | V = 5 %; Singhose and others 1994 |
///
/// @pre the setting is within its ranges
[[nodiscard]] ShaperImpulses impulses_of(const ShaperSetting& setting);

}  // namespace cnc::motion
