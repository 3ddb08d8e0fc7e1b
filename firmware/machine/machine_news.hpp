#pragma once

#include <optional>
#include <utility>

#include "planner/compensation/compensator.hpp"

namespace cnc {

/// An event that is reported once.
class OnceFlag {
 public:
  void raise() { is_raised_ = true; }
  void drop() { is_raised_ = false; }
  [[nodiscard]] bool is_raised() const { return is_raised_; }
  /// Returns whether the event was raised since the last call.
  [[nodiscard]] bool take() { return std::exchange(is_raised_, false); }

 private:
  bool is_raised_ = false;
};

/// Events of the machine. The protocol takes each once and reports it.
struct MachineNews {
  OnceFlag reset_pressed;  ///< The reset button was pressed, so waiting lines are dropped.
  OnceFlag probe_ended;    ///< A G38 has ended. Its report is sent before the answer to its line.
  /// M2 or M30 was done. Its message is sent before the answer to its line.
  OnceFlag program_ended;
  OnceFlag line_failed;  ///< A line of a tool change was stopped, or its probe failed.
  /// Fault of a compensated path that cannot be driven. The protocol refuses the present line,
  /// although the fault may be in an earlier line.
  std::optional<compensation::Fault> path_fault{};

  /// Returns the fault of the path, once.
  [[nodiscard]] std::optional<compensation::Fault> take_path_fault();
};

}  // namespace cnc
