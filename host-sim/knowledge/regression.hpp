#pragma once

#include <cstddef>
#include <span>

namespace sim {

struct Sample {
  double x = 0.0;
  double y = 0.0;
};

/// The line y = slope · x + intercept by least squares.
struct Regression {
  double slope = 0.0;
  double intercept = 0.0;
  double correlation = 0.0;  ///< Pearson's r; 0 if all x or all y are equal.
  /// Standard deviation of one sample from the line, with n − 2 degrees of freedom.
  double residual_sd = 0.0;
  std::size_t samples = 0;
  double mean_x = 0.0;
  double squares_x = 0.0;  ///< Sum of (x − mean)².

  [[nodiscard]] double at(double x) const { return slope * x + intercept; }
};

/// Fits a line.
/// @pre at least three samples with at least two different x
[[nodiscard]] Regression fit_line(std::span<const Sample> samples);

/// Returns the t for which 95 % of Student's distribution are between −t and t, with an error of at
/// most 2e-5. For 0 degrees of freedom, which stand for an unknown number, returns the t of the
/// normal distribution.
[[nodiscard]] double student_t95(std::size_t degrees);

}  // namespace sim
