#include "tests/simulation/burnt_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace proof {
namespace {

/// Greatest distance between two edges of successive steps, and between edges on both sides of a
/// dark pixel, mm.
constexpr double kLongestStepMm = 0.02;
constexpr double kLongestPixelMm = 1.0;

double distance(const Burnt& a, const Burnt& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

BurntPath::BurntPath(std::vector<Burnt> rows)
    : rows_{std::move(rows)}, ways_(rows_.size(), 0.0), lit_(rows_.size(), 0.0) {
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    const double way = distance(rows_[i - 1], rows_[i]);
    ways_[i] = ways_[i - 1] + (way < kLongestPixelMm ? way : 0.0);
    lit_[i] = lit_[i - 1] + (way < kLongestStepMm ? way : 0.0);
  }
}

/// Returns the row nearest to a point, among the rows within `reach_mm` of path from row `near`.
std::size_t BurntPath::nearest(const Burnt& place, std::size_t near, double reach_mm) const {
  std::size_t best = near;
  for (std::size_t i = near; i-- > 0 && ways_[near] - ways_[i] < reach_mm;) {
    if (distance(rows_[i], place) < distance(rows_[best], place)) best = i;
  }
  for (std::size_t i = near; i < rows_.size() && ways_[i] - ways_[near] < reach_mm; ++i) {
    if (distance(rows_[i], place) < distance(rows_[best], place)) best = i;
  }
  return best;
}

/// Returns whether any row within 0.03 mm of path has this output.
bool BurntPath::burns_so(std::size_t row, double duty) const {
  for (std::size_t i = row; i < rows_.size() && ways_[i] - ways_[row] < 0.03; ++i) {
    if (std::abs(rows_[i].duty - duty) < 1.0e-4) return true;
  }
  for (std::size_t i = row; i-- > 0 && ways_[row] - ways_[i] < 0.03;) {
    if (std::abs(rows_[i].duty - duty) < 1.0e-4) return true;
  }
  return false;
}

BurntPath::Gap BurntPath::judge(const std::vector<Burnt>& burnt, std::size_t before) const {
  Gap gap;
  if (before >= burnt.size()) {
    if (before > 0) gap.left_mm = lit_.back() - lit_[before - 1];
    return gap;
  }
  const std::size_t came_to = before == 0 ? 0 : before - 1;
  std::size_t at = nearest(burnt[before], came_to, 2.0);
  gap.twice_mm = std::max(0.0, lit_[came_to] - lit_[at]);
  std::size_t covered = came_to;
  for (std::size_t i = before; i < burnt.size(); ++i) {
    at = nearest(burnt[i], at, 0.6);
    gap.beside_mm = std::max(gap.beside_mm, distance(rows_[at], burnt[i]));
    gap.left_mm = std::max(gap.left_mm, lit_[at] - lit_[covered]);
    covered = std::max(covered, at);
    if (!burns_so(at, burnt[i].duty)) ++gap.other_power;
  }
  gap.left_mm = std::max(gap.left_mm, lit_.back() - lit_[covered]);
  return gap;
}

}  // namespace proof
