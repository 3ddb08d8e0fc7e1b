#pragma once

#include <string_view>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim {

/// Computes where the tip of a five-axis machine is, from the settings that the machine has or that
/// a program gives it.
class FiveAxisQuestion {
 public:
  explicit FiveAxisQuestion(const cnc::Settings& settings) : settings_{settings} {}

  /// Takes a statement of a program. Only `$N=value` has an effect.
  void hear(std::string_view statement);

  /// Returns the program's position under G43.4 for positions of the axes; axes_for() is the
  /// inverse.
  /// @param tool_length_mm from the machine's gauge point to the tip
  [[nodiscard]] Point program_for(const Point& axes, double tool_length_mm) const;
  [[nodiscard]] Point axes_for(const Point& program, double tool_length_mm) const;

 private:
  cnc::Settings settings_;
};

}  // namespace sim
