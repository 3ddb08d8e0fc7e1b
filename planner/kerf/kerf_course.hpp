#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "planner/kerf/kerf_lookup.hpp"

namespace cnc::kerf {

/// The displacement of the cut's edge as a function of heat input per length: half the width of the
/// kerf, minus half of the programmed width. The heat input is given as its ratio to the programmed
/// heat input, which is the ratio of the powers divided by the ratio of the speeds.
///
/// Between the permissible speeds the course is piecewise linear in kPoints points, which is exact
/// for a linear law. A ratio outside this range is clamped to the hottest or the coldest of these
/// points, because no measurement exists there. Source: Park and Ahn 2007, equations 1 and 2.
class KerfCourse {
 public:
  static constexpr std::size_t kPoints = 33;

  /// Computes the course of a condition.
  /// @param table a sound table, used only during the call
  /// @param condition programmed condition
  /// @return the reason why there is no kerf; then the course is constant 0
  [[nodiscard]] std::optional<Refusal> begin(const TableView<float>& table,
                                             const Condition& condition);

  /// Returns the outward displacement of the edge from its programmed position, mm; 0 if the ratio
  /// is 1.
  /// @param heat ratio of the heat input to the programmed heat input, finite
  [[nodiscard]] float aside_mm(float heat) const;
  /// Returns the programmed speed, mm/s.
  [[nodiscard]] float speed_mm_s() const { return speed_mm_s_; }

 private:
  float coldest_ = 1.0F;
  /// Number of points per unit of the ratio; 0 if only one speed is permissible.
  float points_per_heat_ = 0.0F;
  float speed_mm_s_ = 1.0F;
  std::array<float, kPoints> aside_mm_{};
};

}  // namespace cnc::kerf
