#pragma once

#include <cstddef>
#include <span>

namespace sim {

struct Sample {
  double x = 0.0;
  double y = 0.0;
};

/// y = slope · x + intercept by least squares.
struct Regression {
  double slope = 0.0;
  double intercept = 0.0;
  double correlation = 0.0;  ///< Pearson's r; 0 where x or y are all the same.
  double residual_sd = 0.0;  ///< Of one sample from the line, n − 2 degrees of freedom.
  std::size_t samples = 0;
  double mean_x = 0.0;
  double squares_x = 0.0;  ///< Sum of (x − mean)².

  [[nodiscard]] double at(double x) const { return slope * x + intercept; }
};

/// @pre at least three samples with at least two different x
[[nodiscard]] Regression fit_line(std::span<const Sample> samples);

/// The t that 95 % of Student's distribution lie within, either side; error at most 2e-5.
/// With 0 degrees of freedom, when they are not known, that of the normal distribution.
[[nodiscard]] double student_t95(std::size_t degrees);

}  // namespace sim
