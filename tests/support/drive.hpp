#pragma once

#include <functional>

#include "tests/support/random_program.hpp"
#include "tests/support/recorded_plan.hpp"

namespace proof {

/// Called before each segment is cut, with the number cut so far.
using Operator = std::function<void(cnc::motion::Segmenter&, std::size_t)>;

/// Drives a program through path, look-ahead and segmenter as the machine would, but
/// without the machine: blocks and segments in the bursts that the program says.
[[nodiscard]] RecordedPlan drive(const Program& program,
                                 const TestMachine& machine,
                                 const Operator& operate = {});

}  // namespace proof
