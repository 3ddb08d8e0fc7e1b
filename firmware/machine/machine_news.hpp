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
  /// Returns whether it was raised since the last call.
  [[nodiscard]] bool take() { return std::exchange(is_raised_, false); }

 private:
  bool is_raised_ = false;
};

/// Events of the machine. The protocol takes each once and reports it.
struct MachineNews {
  OnceFlag reset_pressed;  ///< The reset button was pressed: waiting lines are dropped.
  OnceFlag probe_ended;    ///< A G38 has ended; its report goes before its answer.
  OnceFlag program_ended;  ///< M2 or M30 was done; its message goes before its answer.
  OnceFlag line_failed;    ///< A line of a tool change was stopped, or its probe failed.
  /// Fault of a compensated path that cannot be driven. The present line is refused; the fault may
  /// be in an earlier one.
  std::optional<compensation::Fault> path_fault{};

  /// Returns the fault, once.
  [[nodiscard]] std::optional<compensation::Fault> take_path_fault();
};

}  // namespace cnc
