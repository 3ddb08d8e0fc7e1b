#pragma once

#include <array>
#include <cstdint>

#include "planner/motion/lookahead/time_window.hpp"
#include "planner/motion/plan/phase_course.hpp"

namespace cnc::motion {

/// Makes the motion from the plan. The position of the motion is the mean of the plan's position
/// over the window of time that ends now.
///
/// Time is divided into cells. The plan is added stretch by stretch until a cell is full; then the
/// motion in the time of that cell can be taken. Means are exact integers, so the motion ends where
/// the plan does, to the unit. Speeds and accelerations are those of the exact mean at the ends of
/// cells.
class MotionFilter {
 public:
  /// Restarts with another window. @pre window.filters()
  void begin(const TimeWindow& window);

  /// Returns the time in ns until the present cell is full.
  [[nodiscard]] std::uint32_t room_ns() const { return window_.cell_ns - used_ns_; }
  /// Adds a stretch of the plan. @pre the stretch is at most room_ns() long
  void add(const Stretch& stretch);
  /// Fills the rest of the cell with a plan at rest.
  void rest();

  /// Returns the motion within the cell just filled. It is shorter than a cell if the motion comes
  /// to rest within the cell. @pre room_ns() == 0
  [[nodiscard]] Stretch take();

  /// Returns whether the motion is at rest, and stays so until the plan moves.
  [[nodiscard]] bool at_rest() const { return window_way_ == 0 && used_ns_ == 0; }

 private:
  /// A cell of the plan. Positions wrap; only their differences are used.
  struct Cell {
    PathUnits mean = 0;          ///< Mean of the plan's position in the cell.
    PathUnits end = 0;           ///< The plan's position at the end of the cell.
    std::uint32_t moved_ns = 0;  ///< Time from the start of the cell for which the plan moved.
  };

  [[nodiscard]] PathUnits next_way(const Cell& newest, const Cell& oldest);

  TimeWindow window_{};
  std::array<Cell, TimeWindow::kMaxCells> cells_{};
  std::uint32_t oldest_ = 0;

  // The plan in the cell being filled.
  PathUnits from_ = 0;  ///< Position at the start of the cell.
  PathUnits place_ = 0;
  float mean_way_ = 0.0F;  ///< Mean distance from from_ in mm, weighted by the filled part.
  std::uint32_t used_ns_ = 0;
  std::uint32_t moved_ns_ = 0;

  // The motion.
  PathUnits remainder_ = 0;   ///< Remainder of the division by the number of cells.
  PathUnits window_way_ = 0;  ///< Distance that the plan drives within the window.
  float speed_ = 0.0F;        ///< mm/s.
};

}  // namespace cnc::motion
