#pragma once

#include <cstddef>
#include <vector>

#include "planner/motion/block/block_builder.hpp"
#include "tests/support/random_machine.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

struct ProgramItem {
  cnc::motion::MotionRequest request{};
  /// Whether the motion must come to rest before this item, as for a dwell, M0 or tool change.
  bool stop_before = false;
};

/// Path elements as the controller receives them, with the sizes of the bursts.
struct Program {
  std::vector<ProgramItem> items;
  /// Number of blocks that arrive before the next segments are cut.
  std::size_t pushed_at_once = 64;
  std::size_t cut_at_once = 20;  ///< Number of segments that are cut before more blocks arrive.
  float weld_mm = 0.0F;          ///< Tolerance of G64 Q, mm; that of corners is the machine's $11.
};

struct ProgramSize {
  /// Shortest rough job time, s. The time is random on a logarithmic scale.
  double min_time_s = 0.02;
  double max_time_s = 3.0;
  double max_steps = 20'000.0;
  bool splines = false;  ///< Includes stretches of splines, as the arcs that approximate them.
};

/// Returns lines, arcs, helices and rapids on two to six axes, in stretches of one difficult kind
/// each. Kinds are micrometre steps, reversals, almost tangent joints, slopes of 10⁴ to 1,
/// polylines of smooth curves, chains of tangent arcs, full circles and turns, and motions without
/// length. Feed and beam change, and some stretches begin after a stop.
[[nodiscard]] Program random_program(Random& random,
                                     const TestMachine& machine,
                                     const ProgramSize& size = {});

}  // namespace proof
