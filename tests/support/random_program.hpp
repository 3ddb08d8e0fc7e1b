#pragma once

#include <cstddef>
#include <vector>

#include "planner/motion/block/block_builder.hpp"
#include "tests/support/random_machine.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

struct ProgramItem {
  cnc::motion::MotionRequest request{};
  bool stop_before = false;  ///< A dwell, M0 or tool change: everything is driven before it.
};

/// Path elements as the controller gets them, and how they arrive.
struct Program {
  std::vector<ProgramItem> items;
  std::size_t pushed_at_once = 64;  ///< Blocks that arrive before the next segments are cut…
  std::size_t cut_at_once = 20;     ///< … and so many segments before more blocks arrive.
  float weld_mm = 0.0F;             ///< G64 Q; the corners' tolerance is the machine's $11.
};

struct ProgramSize {
  double min_time_s = 0.02;  ///< Rough job time; every magnitude is as likely.
  double max_time_s = 3.0;
  double max_steps = 20'000.0;
  bool splines = false;  ///< Stretches of splines, as the arcs that stand for them, too.
};

/// Lines, arcs, helices and rapids on two to six axes in stretches of one
/// nasty kind each: micrometre steps, reversals, almost tangent joints, 10⁴ to
/// 1 slopes, polylines of smooth curves, chains of tangent arcs, full circles
/// and turns, motions of nothing; with changes of feed and beam and with stops.
[[nodiscard]] Program random_program(Random& random,
                                     const TestMachine& machine,
                                     const ProgramSize& size = {});

}  // namespace proof
