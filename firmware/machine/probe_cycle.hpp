#pragma once

#include <cstdint>

#include "firmware/machine/machine_types.hpp"

namespace cnc {

/// The phase of a probing cycle (G38), and the result of the last one.
class ProbeCycle {
 public:
  enum class Phase : std::uint8_t {
    kNone,
    kMoving,
    kStopping,  ///< The contact has changed; the motors brake along the rest of the motion.
  };

  [[nodiscard]] Phase phase() const { return phase_; }
  void go_to(Phase phase) { phase_ = phase; }
  /// Forgets a cycle that does not come to its end. The result of the one before stays.
  void cancel() { phase_ = Phase::kNone; }
  /// Ends the cycle with its result.
  void end(const Probe& result) {
    cancel();
    last_ = result;
  }

  /// Returns the result of the last probe; position 0 and no success before the first.
  [[nodiscard]] const Probe& last() const { return last_; }

 private:
  Phase phase_ = Phase::kNone;
  Probe last_{};
};

}  // namespace cnc
