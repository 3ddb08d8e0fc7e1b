#pragma once

#include "firmware/steps/turn_gate.hpp"

namespace cnc {

/// Turns that take no time: what was handed to the step generator is let in, and
/// what it tells is up to date. Its timer is wanted when something waits.
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
