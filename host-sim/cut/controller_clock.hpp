#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/cut/written_path.hpp"
#include "planner/motion/lookahead/block_queue.hpp"
#include "planner/motion/plan/plan_cursor.hpp"
#include "planner/path/path_stage.hpp"

namespace sim::cut {

/// Predicts how long a controller takes for each motion of a program, by the controller's own
/// planner: welds and corners, look-ahead, and the window of a limit of jerk.
///
/// No pulses are made, so a motion costs microseconds however long it lasts. Motors that follow
/// later (input shaping, backlash) and the cycles of the main loop are not counted.
///
/// Motions are added in the order of the program. Some are held back until the ones after them are
/// known, as on the controller, so times are known at the end only.
class ControllerClock {
 public:
  explicit ControllerClock(const OrderWish& machine);

  /// Adds a motion, which begins where the one before ended.
  /// @param path not beyond a kilometre from zero; a path without length takes no time
  /// @param feed_mm_s > 0, or 0 for a rapid
  /// @param is_lit the beam is on
  void move(const Stroke& path, double feed_mm_s, bool is_lit);
  /// Lets the machine stand, as a dwell does: nothing of what follows is known before.
  void rest();
  /// Lets the machine stand and returns the time of each motion since the last call, s, in the
  /// order in which they were added. The window of a limit of jerk counts for the last motion
  /// before a stop.
  [[nodiscard]] std::vector<double> finish();

 private:
  void put(const cnc::path::PathItem& item);
  void make_blocks();
  bool drive();
  void pass(std::size_t motion, double seconds);
  void begin_chain(std::size_t motion);
  void end_chain();
  [[nodiscard]] cnc::motion::TimeWindow longest_window();

  cnc::motion::Limits limits_;
  cnc::path::Tolerance tolerance_;
  cnc::path::PathStage path_;
  cnc::motion::BlockQueueOf<cnc::motion::kLookAheadBlocks> queue_{};
  cnc::motion::PlanCursor plan_;
  cnc::motion::TimeWindow window_{};
  WrittenPath written_;
  std::vector<double> times_{};  ///< By motion, s.
  std::size_t last_ = 0;         ///< Number of the motion that was driven last.
  bool in_chain_ = false;        ///< The window of the last chain is not counted yet.

  // State by which the controller chooses a window. Times are seconds since the program's start.
  double now_s_ = 0.0;    ///< The plan has been driven up to here.
  double read_s_ = 0.0;   ///< The newest line was read.
  double ready_s_ = 0.0;  ///< The first block of the chain that is next was known.
  /// When the plan left the blocks before, in a ring: as many as the queue holds.
  std::array<double, cnc::motion::kLookAheadBlocks> left_s_{};
  std::size_t pushed_ = 0;  ///< Blocks so far…
  std::size_t left_ = 0;    ///< …and those of them that the plan has left.
};

}  // namespace sim::cut
