#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cnc::motion {

/// Kinds of input shapers. Their numbers are the values of `$810`.
enum class ShaperKind : std::uint8_t { kNone, kZv, kZvd, kMzv, kEi };

/// Frequency and damping of the swing of an axis, and the shaper that suppresses this swing.
struct ShaperSetting {
  static constexpr float kMinFrequency = 10.0F;
  static constexpr float kMaxFrequency = 200.0F;
  static constexpr float kMaxDamping = 0.5F;

  ShaperKind kind = ShaperKind::kNone;
  float frequency_hz = 40.0F;  ///< Frequency of the swing without damping, Hz.
  float damping = 0.0F;        ///< Damping ratio of the swing; 1 would be critical.
  constexpr bool operator==(const ShaperSetting&) const = default;
};

/// Impulses of a shaper. The shaped position is Σ amplitude · position(t − delay).
///
/// Amplitudes are above 0 and their sum is 1, so a shaped position is a mean of earlier positions.
/// So the speed, the acceleration and any further derivative of the shaped motion never exceed
/// their greatest values in the original motion. Both motions come to rest at the same position.
struct ShaperImpulses {
  static constexpr std::size_t kMax = 3;

  std::size_t count = 1;
  std::array<float, kMax> amplitude{1.0F};
  std::array<float, kMax> delay_s{};  ///< Delays in s, from 0, in rising order.

  /// Returns the time, in s, by which the shaped position lags behind in a motion at constant
  /// speed.
  [[nodiscard]] float mean_delay_s() const;
};

/// Returns the impulses of a shaper. T = 1 / (f √(1 − ζ²)) is the damped period, and K = e^(−πζ /
/// √(1 − ζ²)) is the decay of a swing in half of T:
///
/// | kind | amplitudes before scaling | delays | residual swing at f, source |
/// |---|---|---|---|
/// | ZV | 1, K | 0, T/2 | none; Singer and Seering 1990 |
/// | ZVD | 1, 2 K, K² | 0, T/2, T | none, also with slope 0 over f; Singer and Seering 1990 |
/// | MZV | a, (√2 − 1) k, a k² | 0, 3T/8, 3T/4 | none; a = 1 − 1/√2, k = K^(3/4) |
/// | EI | 1 + V, 2 (1 − V) K, (1 + V) K² | 0, T/2, T | V = 5 %; Singhose and others 1994 |
///
/// @pre the setting is within its ranges
[[nodiscard]] ShaperImpulses impulses_of(const ShaperSetting& setting);

}  // namespace cnc::motion
