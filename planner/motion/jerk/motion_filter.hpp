#pragma once

#include <array>
#include <cstdint>

#include "planner/motion/lookahead/time_window.hpp"
#include "planner/motion/plan/phase_course.hpp"

namespace cnc::motion {

/// Makes the motion from the plan. The position of the motion is the mean of the plan's position
/// over the window of time that ends now.
///
/// Time is divided into cells of equal duration, see TimeWindow. The plan is added stretch by
/// stretch until a cell is full. Then the motion in the time of that cell can be taken. Means are
/// exact integers, so the motion ends exactly where the plan ends. At the boundaries of cells, the
/// motion has the speed and the acceleration of the exact mean.
class MotionFilter {
 public:
  /// Begins a motion from rest with the given window. @pre window.filters()
  void begin(const TimeWindow& window);

  /// Returns the time in ns that is missing until the present cell is full.
  [[nodiscard]] std::uint32_t room_ns() const { return window_.cell_ns - used_ns_; }
  /// Adds a stretch of the plan. @pre the duration of the stretch is at most room_ns()
  void add(const Stretch& stretch);
  /// Fills the rest of the present cell as if the plan were at rest.
  void rest();

  /// Returns the motion within the cell that was just filled. It is shorter than the cell if the
  /// motion comes to rest within the cell. @pre room_ns() == 0
  [[nodiscard]] Stretch take();

  /// Returns whether the motion is at rest and stays at rest until the plan moves.
  [[nodiscard]] bool at_rest() const { return window_way_ == 0 && used_ns_ == 0; }

 private:
  /// The plan within one cell. Positions wrap around; only their differences are used.
  struct Cell {
    PathUnits mean = 0;  ///< Mean of the plan's position in the cell.
    PathUnits end = 0;   ///< The plan's position at the end of the cell.
    /// Time from the start of the cell to the end of the plan's last motion in the cell, ns.
    std::uint32_t moved_ns = 0;
  };

  [[nodiscard]] PathUnits next_way(const Cell& newest, const Cell& oldest);

  TimeWindow window_{};
  std::array<Cell, TimeWindow::kMaxCells> cells_{};
  std::uint32_t oldest_ = 0;

  // Values of the plan in the cell that is being filled.
  PathUnits from_ = 0;  ///< Position of the plan at the start of the cell.
  PathUnits place_ = 0;
  /// Mean distance of the plan from from_ over the filled part of the cell, in mm, multiplied by
  /// the share of the cell that is filled.
  float mean_way_ = 0.0F;
  std::uint32_t used_ns_ = 0;
  std::uint32_t moved_ns_ = 0;

  // Values of the motion.
  PathUnits remainder_ = 0;   ///< Remainder of the division by the number of cells in next_way().
  PathUnits window_way_ = 0;  ///< Distance that the plan drives within the window.
  float speed_ = 0.0F;        ///< Speed of the motion, mm/s.
};

}  // namespace cnc::motion
