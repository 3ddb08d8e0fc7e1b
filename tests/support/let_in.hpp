#pragma once

#include "firmware/steps/turn_gate.hpp"

namespace cnc {

/// Runs cycles that take no time, until the step generator has accepted all handed-over segments
/// and reports its present state. Afterwards it requires its timer if segments wait.
template <typename Generator>
void let_in(Generator& generator) {
  generator.settle();
  for (std::uint32_t turn = 0; turn <= kTurnsToMotion + 1; ++turn) {
    generator.player().begin_turn();
    static_cast<void>(generator.take_turn());
    generator.end_turn();
  }
}

}  // namespace cnc
