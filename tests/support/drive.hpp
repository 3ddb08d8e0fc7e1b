#pragma once

#include <functional>

#include "tests/support/random_program.hpp"
#include "tests/support/recorded_plan.hpp"

namespace proof {

/// Called before each segment is cut; the number is that of the segments cut so far.
using Operator = std::function<void(cnc::motion::Segmenter&, std::size_t)>;

/// Drives a program through path, look-ahead and segmenter as the machine does, but without the
/// machine. Blocks arrive and segments are cut in bursts whose sizes the program contains.
[[nodiscard]] RecordedPlan drive(const Program& program,
                                 const TestMachine& machine,
                                 const Operator& operate = {});

}  // namespace proof
