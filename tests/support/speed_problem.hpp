#pragma once

#include <vector>

#include "tests/support/band_system.hpp"
#include "tests/support/speed_mesh.hpp"

namespace sim {

/// One section's y = v³ as a quadratic spline of its cells, at rest at both ends, and
/// the barrier of its rules: weight · time − Σ log(room of each rule).
///
/// Rules are held at the ends of the cells (rates, acceleration) and in their
/// middles (jerk); time is counted by Simpson's rule, beside a stop exactly for y ~ d².
class SpeedProblem {
 public:
  /// @param exact whether a²/v stands for itself or is relaxed (JerkRelief).
  /// @pre at least three cells
  SpeedProblem(const SpeedSection& cells, bool exact);

  /// Unknowns are the spline's coefficients but the first and the last two, which are 0.
  [[nodiscard]] std::size_t unknowns() const { return cells_.size() - 2; }

  /// The time alone, s.
  [[nodiscard]] double time(const std::vector<double>& unknown) const;
  /// Infinity where a rule is broken.
  [[nodiscard]] double value(const std::vector<double>& unknown, double weight) const;
  /// Fills the Newton system: Hessian, and the negative gradient on the right.
  void derive(const std::vector<double>& unknown, double weight, BandSystem& system) const;
  /// How many logarithms there are.
  [[nodiscard]] double rule_count() const;

  /// A slow motion within every rule. @param share of y of the usual one, or less.
  [[nodiscard]] std::vector<double> slow_start(double share = 1.0) const;

  /// y and y′ at the end of a cell.
  struct Place {
    double y = 0.0;
    double first = 0.0;
  };
  [[nodiscard]] Place end_of(std::size_t cell, const std::vector<double>& unknown) const;

 private:
  /// y, y′ and y″ as rows over the three coefficients that reach a cell.
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
  std::vector<double> places_{};  ///< mm, of the cells' ends from the section's start.
};

}  // namespace sim
