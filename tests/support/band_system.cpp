#include "tests/support/band_system.hpp"

#include <algorithm>
#include <limits>

namespace sim {

void BandSystem::clear() {
  for (auto& diagonal : diagonals_) std::ranges::fill(diagonal, 0.0);
  std::ranges::fill(right_, 0.0);
}

std::vector<double> BandSystem::solve() {
  auto& [pivot, next, second] = diagonals_;
  std::vector<double> unknown = right_;
  const std::size_t count = size();
  // After the loop `next` and `second` hold L, and `pivot` holds D.
  for (std::size_t i = 0; i < count; ++i) {
    if (!(pivot[i] > 0.0)) pivot[i] = std::numeric_limits<double>::infinity();
    const double one = next[i];
    const double two = second[i];
    next[i] /= pivot[i];
    second[i] /= pivot[i];
    if (i + 1 < count) {
      pivot[i + 1] -= next[i] * one;
      next[i + 1] -= next[i] * two;
      unknown[i + 1] -= next[i] * unknown[i];
    }
    if (i + 2 < count) {
      pivot[i + 2] -= second[i] * two;
      unknown[i + 2] -= second[i] * unknown[i];
    }
  }
  for (std::size_t i = count; i-- > 0;) {
    unknown[i] /= pivot[i];
    if (i + 1 < count) unknown[i] -= next[i] * unknown[i + 1];
    if (i + 2 < count) unknown[i] -= second[i] * unknown[i + 2];
  }
  return unknown;
}

}  // namespace sim
