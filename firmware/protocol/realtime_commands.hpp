#pragma once

#include "firmware/link/realtime_byte.hpp"
#include "firmware/machine/machine.hpp"

namespace cnc {

/// Does what a realtime byte asks of the machine, in any state. Bytes without
/// a meaning, and those that ask for a report or a reset, do nothing here.
void apply(RealtimeByte command, Machine& machine);

}  // namespace cnc
