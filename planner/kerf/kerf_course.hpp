#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "planner/kerf/kerf_lookup.hpp"

namespace cnc::kerf {

/// How the edge of the cut moves with the heat: half the width of the kerf by heat input per
/// length, less half of what it is as programmed. Power and thickness are one each, so the heat is
/// known by its ratio to the programmed one: power by power over speed by speed.
///
/// Between the speeds that are permissible straight between kPoints of them, which is exact for a
/// linear law; what is hotter or colder is taken for the hottest or coldest of these, because
/// nobody has cut there. Source: Park and Ahn 2007, equations 1 and 2.
class KerfCourse {
 public:
  static constexpr std::size_t kPoints = 33;

  /// @param table sound; used only now
  /// @param condition what is programmed
  /// @return why there is no kerf; then the course is level
  [[nodiscard]] std::optional<Refusal> begin(const TableView<float>& table,
                                             const Condition& condition);

  /// mm that the edge is farther out than programmed; 0 where the ratio is 1.
  /// @param heat ratio, finite
  [[nodiscard]] float aside_mm(float heat) const;
  /// The programmed speed, mm/s.
  [[nodiscard]] float speed_mm_s() const { return speed_mm_s_; }

 private:
  float coldest_ = 1.0F;
  float points_per_heat_ = 0.0F;  ///< 0: one speed only is permissible.
  float speed_mm_s_ = 1.0F;
  std::array<float, kPoints> aside_mm_{};
};

}  // namespace cnc::kerf
