#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/cutter_compensation.hpp"

namespace sim {

/// Computes how wide a controller's G41 cuts. It queries a controller of its own with the same
/// power table and kerf tables, so that no other code has to know the tables.
class KerfQuestion {
 public:
  /// Starts the controller that is queried.
  /// @param settings only $30 is used
  explicit KerfQuestion(const cnc::Settings& settings);

  /// Takes a statement of a program. Only `$PC` and the statements on kerf tables have an effect.
  void hear(std::string_view statement);

  /// Returns the width of the cut in mm; empty where the controller refuses the condition.
  [[nodiscard]] std::optional<double> width(const CutCondition& condition) const;

 private:
  std::string statements_;
};

}  // namespace sim
