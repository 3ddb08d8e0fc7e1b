#include "host-sim/knowledge/regression.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {

constexpr double kNormal95 = 1.959963984540054;

/// Returns the probability that |T| is below t. Source: Abramowitz and Stegun 26.7.3 and 26.7.4.
double within(double t, std::size_t degrees) {
  const double angle = std::atan(t / std::sqrt(static_cast<double>(degrees)));
  const double cosine = std::cos(angle);
  const bool odd = degrees % 2 == 1;
  double term = odd ? cosine : 1.0;
  double sum = degrees == 1 ? 0.0 : term;
  for (std::size_t i = odd ? 3 : 2; i + 2 <= degrees; i += 2) {
    const auto n = static_cast<double>(i);
    term *= cosine * cosine * (n - 1.0) / n;
    sum += term;
  }
  const double series = std::sin(angle) * sum;
  return odd ? 2.0 / std::numbers::pi * (angle + series) : series;
}

}  // namespace

Regression fit_line(std::span<const Sample> samples) {
  Regression line{.samples = samples.size()};
  const auto count = static_cast<double>(samples.size());
  double mean_y = 0.0;
  for (const Sample& sample : samples) {
    line.mean_x += sample.x / count;
    mean_y += sample.y / count;
  }
  double products = 0.0;
  double squares_y = 0.0;
  for (const Sample& sample : samples) {
    const double dx = sample.x - line.mean_x;
    const double dy = sample.y - mean_y;
    line.squares_x += dx * dx;
    products += dx * dy;
    squares_y += dy * dy;
  }
  line.slope = products / line.squares_x;
  line.intercept = mean_y - line.slope * line.mean_x;
  if (squares_y > 0.0) line.correlation = products / std::sqrt(line.squares_x * squares_y);
  double rest = 0.0;
  for (const Sample& sample : samples) {
    const double off = sample.y - line.at(sample.x);
    rest += off * off;
  }
  line.residual_sd = std::sqrt(rest / (count - 2.0));
  return line;
}

double student_t95(std::size_t degrees) {
  if (degrees == 0) return kNormal95;
  constexpr std::size_t kAlmostNormal = 200;
  // The first two terms of the series in Abramowitz and Stegun 26.7.5 suffice.
  if (degrees > kAlmostNormal) {
    const double z = kNormal95;
    const auto n = static_cast<double>(degrees);
    const double cube = z * z * z;
    return z + (cube + z) / (4.0 * n) +
           (5.0 * z * z * cube + 16.0 * cube + 3.0 * z) / (96.0 * n * n);
  }
  double low = kNormal95;
  double high = 13.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (within(middle, degrees) < 0.95 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace sim
