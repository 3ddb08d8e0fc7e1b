#pragma once

#include <array>
#include <cstdint>

#include "planner/motion/lookahead/time_window.hpp"
#include "planner/motion/plan/phase_course.hpp"

namespace cnc::motion {

/// From the plan to the motion: the place of the motion is the mean of the
/// plan's over the window of time that ends now.
///
/// Time goes on in cells. The plan is laid down stretch by stretch until a cell
/// is full; then the motion in the time of that cell can be taken. Means are
/// exact integers, so that the motion ends where the plan does, to the unit;
/// speeds and accelerations are those of the exact mean at the ends of cells.
class MotionFilter {
 public:
  /// Begins anew with another window. @pre window.filters()
  void begin(const TimeWindow& window);

  /// ns until the present cell is full.
  [[nodiscard]] std::uint32_t room_ns() const { return window_.cell_ns - used_ns_; }
  /// The plan goes on. @pre the stretch is at most room_ns() long
  void add(const Stretch& stretch);
  /// The plan stands still for the rest of the cell.
  void rest();

  /// The motion within the cell just filled; shorter than a cell when it comes
  /// to rest within. @pre room_ns() == 0
  [[nodiscard]] Stretch take();

  /// The motion stands still, and will until the plan moves.
  [[nodiscard]] bool at_rest() const { return window_way_ == 0 && used_ns_ == 0; }

 private:
  /// Places wrap round; only differences are looked at.
  struct Cell {
    PathUnits mean = 0;          ///< Of the plan's place.
    PathUnits end = 0;           ///< The plan's place at its end.
    std::uint32_t moved_ns = 0;  ///< How long into the cell the plan moved.
  };

  [[nodiscard]] PathUnits next_way(const Cell& newest, const Cell& oldest);

  TimeWindow window_{};
  std::array<Cell, TimeWindow::kMostCells> cells_{};
  std::uint32_t oldest_ = 0;

  // Of the plan, in the cell being filled.
  PathUnits from_ = 0;  ///< Its place at the start.
  PathUnits place_ = 0;
  float mean_way_ = 0.0F;  ///< mm from there in the mean, as far as the cell is full.
  std::uint32_t used_ns_ = 0;
  std::uint32_t moved_ns_ = 0;

  // Of the motion.
  PathUnits remainder_ = 0;   ///< Of the division by the number of cells.
  PathUnits window_way_ = 0;  ///< What the plan drives within the window.
  float speed_ = 0.0F;        ///< mm/s.
};

}  // namespace cnc::motion
