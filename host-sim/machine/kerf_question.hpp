#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/cutter_compensation.hpp"

namespace sim {

/// Computes the width of a controller's cut under G41. It runs a second, separate controller with
/// the same power table and kerf tables, so that the simulator requires no other code for these
/// tables.
class KerfQuestion {
 public:
  /// Prepares the separate controller.
  /// @param settings only $30 is used
  explicit KerfQuestion(const cnc::Settings& settings);

  /// Records a statement of a program for the controller. Only `$PC` and the statements about kerf
  /// tables have an effect.
  void hear(std::string_view statement);

  /// Returns the width of the cut, mm; none if the controller refuses the condition.
  [[nodiscard]] std::optional<double> width(const CutCondition& condition) const;

 private:
  std::string statements_;
};

}  // namespace sim
