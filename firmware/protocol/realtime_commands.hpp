#pragma once

#include "firmware/link/realtime_byte.hpp"
#include "firmware/machine/machine.hpp"

namespace cnc {

/// Applies a realtime byte to the machine, in any state. Bytes without a meaning, and those that
/// request a report or a reset, have no effect here.
void apply(RealtimeByte command, Machine& machine);

}  // namespace cnc
