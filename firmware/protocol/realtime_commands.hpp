#pragma once

#include "firmware/link/realtime_byte.hpp"
#include "firmware/machine/machine.hpp"

namespace cnc {

/// Applies a realtime byte to the machine, in any state. Ignores bytes without a meaning and bytes
/// that request a report or a reset.
void apply(RealtimeByte command, Machine& machine);

}  // namespace cnc
