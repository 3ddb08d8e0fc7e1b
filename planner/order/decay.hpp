#pragma once

namespace cnc::order {

/// Returns e^−x for x ≥ 0, with the same bits on every machine. Relative error at most
/// kWideDecayError for x ≤ 40; 0 beyond that.
inline constexpr double kWideDecayError = 1.0e-13;
[[nodiscard]] constexpr double wide_decay(double x) {
  constexpr double kFarthest = 40.0;
  constexpr int kHalvings = 6;
  constexpr int kTerms = 16;
  if (x > kFarthest) return 0.0;
  // A Taylor series of x / 64, squared six times; by e^+x, whose terms have one sign.
  double small = x;
  for (int i = 0; i < kHalvings; ++i) small *= 0.5;
  double sum = 1.0;
  for (int n = kTerms; n > 0; --n) sum = 1.0 + small * sum / n;
  for (int i = 0; i < kHalvings; ++i) sum *= sum;
  return 1.0 / sum;
}

}  // namespace cnc::order
