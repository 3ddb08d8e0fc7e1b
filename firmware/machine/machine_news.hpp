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

/// Events of the machine that the protocol reports once, each when it takes it.
struct MachineNews {
  OnceFlag reset_pressed;  ///< The reset button: lines that wait for the machine are dropped.
  OnceFlag probe_ended;    ///< A G38 came to its end; its report goes before its answer.
  OnceFlag program_ended;  ///< M2 or M30; its message goes before its answer.
  OnceFlag line_failed;    ///< A line of a tool change was stopped, or probed in vain.
  /// A path that cannot be driven beside the programmed one; its line, or one before it, is
  /// refused.
  std::optional<compensation::Fault> path_fault{};

  /// Returns the fault, once.
  [[nodiscard]] std::optional<compensation::Fault> take_path_fault();
};

}  // namespace cnc
