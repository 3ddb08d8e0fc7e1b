#pragma once

namespace cnc::order {

/// Returns e^−x for x ≥ 0, with the same bits on every machine. The relative error is at most
/// kWideDecayError for x ≤ 40; for greater x the result is 0.
inline constexpr double kWideDecayError = 1.0e-13;
[[nodiscard]] constexpr double wide_decay(double x) {
  constexpr double kFarthest = 40.0;
  constexpr int kHalvings = 6;
  constexpr int kTerms = 16;
  if (x > kFarthest) return 0.0;
  // Computes e^+x, because all terms of its series have one sign and cannot cancel each other. The
  // method is a Taylor series of x / 64, squared six times.
  double small = x;
  for (int i = 0; i < kHalvings; ++i) small *= 0.5;
  double sum = 1.0;
  for (int n = kTerms; n > 0; --n) sum = 1.0 + small * sum / n;
  for (int i = 0; i < kHalvings; ++i) sum *= sum;
  return 1.0 / sum;
}

}  // namespace cnc::order
