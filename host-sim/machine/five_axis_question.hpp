#pragma once

#include <string_view>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim {

/// Computes the position of a five-axis machine's tip. It uses the machine's settings and the
/// changes that a program makes to them.
class FiveAxisQuestion {
 public:
  explicit FiveAxisQuestion(const cnc::Settings& settings) : settings_{settings} {}

  /// Applies a statement of a program. Only `$N=value` has an effect.
  void hear(std::string_view statement);

  /// Returns the program's position under G43.4 for positions of the axes. axes_for() is the
  /// inverse.
  /// @param tool_length_mm distance from the machine's gauge point to the tip, mm
  [[nodiscard]] Point program_for(const Point& axes, double tool_length_mm) const;
  [[nodiscard]] Point axes_for(const Point& program, double tool_length_mm) const;

 private:
  cnc::Settings settings_;
};

}  // namespace sim
