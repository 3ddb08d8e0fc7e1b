#pragma once

#include "firmware/protocol/reply.hpp"
#include "planner/compensation/fault.hpp"

namespace cnc {

/// Writes the fault in words, with elements and line numbers: "element 5 (N120) would come too near
/// to element 2".
void put_compensation_fault(Reply& reply, const compensation::Fault& fault);

}  // namespace cnc
