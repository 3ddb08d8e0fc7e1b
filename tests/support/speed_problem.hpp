#pragma once

#include <vector>

#include "tests/support/band_system.hpp"
#include "tests/support/speed_mesh.hpp"

namespace sim {

/// The problem of one section: y = v³ as a quadratic spline over its cells, at rest at both ends.
/// The class evaluates the barrier function: weight · time − Σ log(margin of each rule).
///
/// Rules apply at the ends of the cells (rates, acceleration) and in their middles (jerk). Time is
/// computed by Simpson's rule; next to a stop it is exact for y ~ d².
class SpeedProblem {
 public:
  /// @param exact whether the jerk rule uses a²/v itself, or its upper bounds (JerkRelief)
  /// @pre at least three cells
  SpeedProblem(const SpeedSection& cells, bool exact);

  /// Returns the number of unknowns. They are the spline's coefficients except the first and the
  /// last two, which are 0.
  [[nodiscard]] std::size_t unknowns() const { return cells_.size() - 2; }

  /// Returns the time alone, s.
  [[nodiscard]] double time(const std::vector<double>& unknown) const;
  /// Returns the barrier function; infinity if a rule is violated.
  [[nodiscard]] double value(const std::vector<double>& unknown, double weight) const;
  /// Fills Newton's system of equations: the Hessian, and the negative gradient as the right side.
  void derive(const std::vector<double>& unknown, double weight, BandSystem& system) const;
  /// Returns the number of logarithms in the barrier function.
  [[nodiscard]] double rule_count() const;

  /// Returns a slow motion that satisfies every rule. @param share height y as a share of the usual
  /// one, ≤ 1
  [[nodiscard]] std::vector<double> slow_start(double share = 1.0) const;

  /// The values y and y′ at the end of a cell.
  struct Place {
    double y = 0.0;
    double first = 0.0;
  };
  [[nodiscard]] Place end_of(std::size_t cell, const std::vector<double>& unknown) const;

 private:
  /// Rows that yield y, y′ and y″ from the three coefficients that affect a cell.
  using Basis = std::array<std::array<double, 3>, 3>;
  [[nodiscard]] Basis basis(std::size_t cell, double share) const;
  [[nodiscard]] static std::array<double, 3> apply(const Basis& basis,
                                                   std::size_t cell,
                                                   const std::vector<double>& unknown);
  template <typename Visitor>
  bool visit(const std::vector<double>& unknown, double weight, Visitor&& visitor) const;
  void lay(const PlaceBarrier& place,
           const Basis& basis,
           std::size_t cell,
           BandSystem& system) const;
  [[nodiscard]] std::vector<double> start_of_height(double curve, double share) const;
  [[nodiscard]] double length_of(std::ptrdiff_t cell) const;

  const SpeedSection& cells_;
  bool exact_;
  std::vector<double> places_{};  ///< Positions of the cells' ends from the section's start, mm.
};

}  // namespace sim
