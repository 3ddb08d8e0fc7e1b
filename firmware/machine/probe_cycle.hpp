#pragma once

#include <cstdint>

#include "firmware/machine/machine_types.hpp"

namespace cnc {

/// Phase of a probing cycle (G38), and the result of the last completed cycle.
class ProbeCycle {
 public:
  enum class Phase : std::uint8_t {
    kNone,
    kMoving,
    kStopping,  ///< The probe input has changed. The motors brake along the path.
  };

  [[nodiscard]] Phase phase() const { return phase_; }
  void go_to(Phase phase) { phase_ = phase; }
  /// Cancels a cycle. The result of the last completed cycle stays.
  void cancel() { phase_ = Phase::kNone; }
  /// Ends the cycle and stores its result.
  void end(const Probe& result) {
    cancel();
    last_ = result;
  }

  /// Returns the result of the last completed cycle. Before the first cycle, the result has the
  /// position 0 and is no success.
  [[nodiscard]] const Probe& last() const { return last_; }

 private:
  Phase phase_ = Phase::kNone;
  Probe last_{};
};

}  // namespace cnc
