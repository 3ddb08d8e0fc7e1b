#include "tests/support/speed_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {
namespace {

/// Greatest number of bottlenecks that are treated separately; if there are more, the slowest one
/// stands for all.
constexpr std::size_t kMaxBottlenecks = 2000;

/// Factor on the limit of a²/v. A start from rest is at this limit all the time, and a cell at a
/// joint is subject to the rules of both sides.
constexpr double kSlack = 1.01;

}  // namespace

SpeedProblem::SpeedProblem(const SpeedSection& cells, bool exact) : cells_{cells}, exact_{exact} {
  places_.push_back(0.0);
  for (const SpeedCell& cell : cells) places_.push_back(places_.back() + cell.length);
}

double SpeedProblem::length_of(std::ptrdiff_t cell) const {
  if (cell < 0 || cell >= std::ssize(cells_)) return 0.0;
  return cells_[static_cast<std::size_t>(cell)].length;
}

// Quadratic B-splines with threefold end knots (de Boor, A Practical Guide to Splines, 1978).
SpeedProblem::Basis SpeedProblem::basis(std::size_t cell, double share) const {
  const auto index = static_cast<std::ptrdiff_t>(cell);
  const double h = cells_[cell].length;
  const double before = length_of(index - 1) + h;
  const double after = h + length_of(index + 1);
  const double rest = 1.0 - share;
  Basis rows{{{rest * rest * h / before, 0.0, share * share * h / after},
              {-2.0 * rest / before, 0.0, 2.0 * share / after},
              {2.0 / (before * h), 0.0, 2.0 / (after * h)}}};
  rows[0][1] = 1.0 - rows[0][0] - rows[0][2];
  rows[1][1] = -rows[1][0] - rows[1][2];
  rows[2][1] = -rows[2][0] - rows[2][2];
  return rows;
}

std::array<double, 3> SpeedProblem::apply(const Basis& basis,
                                          std::size_t cell,
                                          const std::vector<double>& unknown) {
  std::array<double, 3> result{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (cell + k < 2 || cell + k - 2 >= unknown.size()) continue;
    for (std::size_t row = 0; row < 3; ++row) result[row] += basis[row][k] * unknown[cell + k - 2];
  }
  return result;
}

/// Calls the visitor with the barrier of each point. Returns false as soon as a rule is violated.
template <typename Visitor>
bool SpeedProblem::visit(const std::vector<double>& unknown,
                         double weight,
                         Visitor&& visitor) const {
  const std::size_t last = cells_.size() - 1;
  // Weight of the time at the end of a cell: exact for y ~ d² in the cells next to the stops.
  const auto end_weight = [&](std::size_t i) {
    const double before = cells_[i].length * (i == 0 ? 3.0 : 1.0 / 6.0);
    return weight * (before + cells_[i + 1].length * (i + 1 == last ? 3.0 : 1.0 / 6.0));
  };
  const auto at = [&](std::size_t i, double share, auto&& rules) {
    const Basis rows = basis(i, share);
    const auto [y, first, second] = apply(rows, i, unknown);
    PlaceBarrier place{y, first, second};
    if (place.kept()) rules(place);
    if (!place.kept()) return false;
    visitor(place, rows, i);
    return true;
  };
  for (std::size_t i = 0; i <= last; ++i) {
    const SpeedCell& cell = cells_[i];
    const bool starts = i > 0 && (cell.begins_piece || cell.turns);
    if (starts && !at(i, 0.0, [&](auto& p) { p.keep_acceleration(cell.start); })) return false;
    const bool middle = at(i, 0.5, [&](PlaceBarrier& place) {
      place.keep_jerk(cell.middle, exact_ ? JerkRelief{} : cell.relief);
      if (i > 0 && i < last) place.add_time(weight * cell.length * 4.0 / 6.0);
    });
    if (!middle) return false;
    const bool end =
        i == last || at(i, 1.0, [&](PlaceBarrier& place) {
          place.keep_below(cell.cap_end);
          place.keep_acceleration(cell.end);
          place.keep_ramp(kSlack * std::max(cell.relief.most, cells_[i + 1].relief.most));
          place.add_time(end_weight(i));
        });
    if (!end) return false;
  }
  return true;
}

double SpeedProblem::value(const std::vector<double>& unknown, double weight) const {
  double sum = 0.0;
  const bool kept = visit(unknown, weight, [&sum](const PlaceBarrier& place, const Basis&, auto) {
    sum += place.value();
  });
  return kept && std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

double SpeedProblem::rule_count() const {
  double count = 0.0;
  for (const SpeedCell& cell : cells_) {
    const auto axes = static_cast<double>(cell.middle.count);
    const double jerk = exact_ || cell.relief.slope <= 0.0 ? 2.0 : 3.0;
    count += 3.0 + axes * (jerk + (cell.begins_piece || cell.turns ? 4.0 : 2.0));
  }
  return count;
}

double SpeedProblem::time(const std::vector<double>& unknown) const {
  constexpr double kOne = 1.0;
  // The logarithms cancel in the difference.
  return value(unknown, 2.0 * kOne) - value(unknown, kOne);
}

void SpeedProblem::derive(const std::vector<double>& unknown,
                          double weight,
                          BandSystem& system) const {
  system.clear();
  visit(unknown, weight, [&](const PlaceBarrier& place, const Basis& rows, std::size_t cell) {
    lay(place, rows, cell, system);
  });
}

void SpeedProblem::lay(const PlaceBarrier& place,
                       const Basis& basis,
                       std::size_t cell,
                       BandSystem& system) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (cell + k < 2 || cell + k - 2 >= unknowns()) continue;
    const std::size_t row = cell + k - 2;
    double slope = 0.0;
    std::array<double, 3> half{};  // Row k of Eᵀ M.
    for (std::size_t i = 0; i < 3; ++i) {
      slope += basis[i][k] * place.gradient()[i];
      for (std::size_t j = 0; j < 3; ++j) {
        half[j] += basis[i][k] * place.hessian(std::min(i, j), std::max(i, j));
      }
    }
    system.add_right(row, -slope);
    for (std::size_t m = k; m < 3 && cell + m - 2 < unknowns(); ++m) {
      double sum = 0.0;
      for (std::size_t j = 0; j < 3; ++j) sum += half[j] * basis[j][m];
      system.add(row, m - k, sum);
    }
  }
}

SpeedProblem::Place SpeedProblem::end_of(std::size_t cell,
                                         const std::vector<double>& unknown) const {
  const auto [y, first, second] = apply(basis(cell, 1.0), cell, unknown);
  return {y, first};
}

/// Returns 1/y = Σ 1/(cap + C d²) over the stops and the slow stretches, where d is the distance
/// from each of them. So y ≤ every cap, y″ ~ C and a²/v ≤ 4 C/9, for any number of terms.
std::vector<double> SpeedProblem::start_of_height(double curve, double share) const {
  struct Bottleneck {
    double from, to, cap;
  };
  std::vector<Bottleneck> slow{{0.0, 0.0, 0.0}, {places_.back(), places_.back(), 0.0}};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const double cap = 0.2 * share * std::min(cells_[i].cap_inside, cells_[i].cap_end);
    least = std::min(least, cap);
    if (slow.back().cap == cap && slow.back().to == places_[i]) {
      slow.back().to = places_[i + 1];
    } else {
      slow.push_back({places_[i], places_[i + 1], cap});
    }
  }
  if (slow.size() > kMaxBottlenecks) {
    slow.resize(2);
    slow.push_back({0.0, places_.back(), least});
  }
  std::vector<double> unknown(unknowns());
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    // A coefficient of the spline is the polar form of a square at its two knots.
    double sum = 0.0;
    for (const Bottleneck& place : slow) {
      const auto beside = [&](double at) { return at - std::clamp(at, place.from, place.to); };
      const double square = std::max(0.0, beside(places_[i + 1]) * beside(places_[i + 2]));
      sum += 1.0 / std::max(place.cap + curve * square, 1.0e-300);
    }
    unknown[i] = 1.0 / sum;
  }
  return unknown;
}

std::vector<double> SpeedProblem::slow_start(double share) const {
  double jerk = std::numeric_limits<double>::infinity();
  for (const SpeedCell& cell : cells_) {
    for (std::size_t i = 0; i < cell.middle.count; ++i) {
      jerk = std::min({jerk, cell.middle.axes[i].jerk, 1.0e12});
    }
  }
  double curve = share * jerk / 20.0;
  std::vector<double> unknown = start_of_height(curve, share);
  constexpr int kHalvings = 200;
  for (int i = 0; i < kHalvings && std::isinf(value(unknown, 1.0)); ++i) {
    if (i < 30) {
      curve *= 0.5;
      unknown = start_of_height(curve, share);
    } else {
      for (double& height : unknown) height *= 0.5;
    }
  }
  return unknown;
}

}  // namespace sim
