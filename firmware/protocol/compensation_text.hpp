#pragma once

#include "firmware/protocol/reply.hpp"
#include "planner/compensation/fault.hpp"

namespace cnc {

/// Writes a fault of the compensated path in words, with the numbers of elements and lines, such as
/// "element 5 (N120) leads into element 2".
void put_compensation_fault(Reply& reply, const compensation::Fault& fault);

}  // namespace cnc
