#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/cutter_compensation.hpp"

namespace sim {

/// Asks a controller how wide its G41 cuts: one of its own, with the same power table and kerf
/// tables, so that nobody else has to know them.
class KerfQuestion {
 public:
  /// @param settings $30 is what is asked of them
  explicit KerfQuestion(const cnc::Settings& settings);

  /// A statement of a program: `$PC` and those on kerf tables count, the others do not.
  void hear(std::string_view statement);

  /// mm; nothing where the controller refuses.
  [[nodiscard]] std::optional<double> width(const CutCondition& condition) const;

 private:
  std::string statements_;
};

}  // namespace sim
