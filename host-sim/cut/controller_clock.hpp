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

/// Predicts the time that a controller takes for each motion of a program. It runs the planner of
/// the controller: welds and corners, look-ahead, and the window that a limit of jerk requires.
///
/// No pulses are made, so the prediction of a motion takes microseconds, however long the motion
/// lasts. Two delays are not counted: that of the motors after the plan (input shaping, backlash),
/// and that of the cycles of the main loop.
///
/// Motions are added in the order of the program. As on the controller, some motions are held back
/// until the following motions are known. The times are therefore known only at the end.
class ControllerClock {
 public:
  explicit ControllerClock(const OrderWish& machine);

  /// Adds a motion, which begins where the previous one ended.
  /// @param path at most a kilometre from zero; a path without length takes no time
  /// @param feed_mm_s above 0, or 0 for a rapid
  /// @param is_lit whether the beam is on
  void move(const Stroke& path, double feed_mm_s, bool is_lit);
  /// Stops the machine, as a dwell does. Until the stop, the planner does not know the motions
  /// after it.
  void rest();
  /// Stops the machine and returns the time of each motion since the last call, s, in the order in
  /// which the motions were added. The time that the window adds at a stop belongs to the last
  /// motion before the stop.
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
  std::vector<double> times_{};  ///< Time of each motion, s.
  std::size_t last_ = 0;         ///< Number of the last motion that was driven.
  /// Whether a chain has begun whose window is not yet added to the times.
  bool in_chain_ = false;

  // State from which the controller chooses a window. These times are seconds since the start of
  // the program.
  double now_s_ = 0.0;    ///< Time up to which the plan has been followed.
  double read_s_ = 0.0;   ///< Time at which the newest line was read.
  double ready_s_ = 0.0;  ///< Time at which the first block of the next chain was known.
  /// Times at which the plan left the latest blocks. The array is a ring with the capacity of the
  /// queue.
  std::array<double, cnc::motion::kLookAheadBlocks> left_s_{};
  std::size_t pushed_ = 0;  ///< Number of blocks that were put into the queue so far.
  std::size_t left_ = 0;    ///< Number of blocks whose ends the plan has passed so far.
};

}  // namespace sim::cut
