#include "firmware/machine/machine.hpp"

namespace cnc {

bool Machine::can_home() const { return false; }

void Machine::home(std::uint8_t axes) { CNC_ASSERT(can_home() || axes == 0); }

}  // namespace cnc
