#pragma once

#include <vector>

#include "host-sim/pocket/adaptive_path.hpp"
#include "host-sim/pocket/axis_course.hpp"
#include "host-sim/pocket/depth_writer.hpp"

namespace sim::pocket {

/// Result of drive().
struct CourseDrive {
  /// Cleared discs that lead back to the beginning of the course. The tool returns along the lines
  /// from centre to centre. Each line lies in the union of the two discs.
  std::vector<cnc::pocket::ToolCircle> way_back;
  bool is_complete = false;  ///< Whether the tool reached the end of the course.
};

/// Clears an area along its medial axis: by crescents, or by slots where the area is too narrow for
/// crescents.
class CrescentDriver {
 public:
  CrescentDriver(const OwnedArea& area, const AdaptiveOptions& options, AdaptivePath& out);

  /// Clears the area along a course.
  /// @param start circle at the beginning of the course; the tool's centre is on it or in it, and
  /// the disc around it is cleared
  /// @param is_dead_end whether no other piece continues at the end of the course
  CourseDrive drive(const AxisCourse& course,
                    const cnc::pocket::ToolCircle& start,
                    bool is_dead_end);

  /// Opens a disc in full stock: by an entry, then by a spiral outwards within the engagement.
  /// Leaves the tool on `circle`.
  /// @param way  points from the centre of the circle on, for a ramp; see enter_stock()
  void open_disc(const cnc::pocket::ToolCircle& circle, const std::vector<cnc::WideVec2>& way);

  /// Records a disc that touches no stock as cleared. The tool stays up until a cut at the disc
  /// begins.
  void take_free_disc(const cnc::pocket::ToolCircle& circle);

  /// Returns whether the disc that a tool clears on `circle` touches no stock.
  [[nodiscard]] bool is_free(const cnc::pocket::ToolCircle& circle) const;

  /// Returns whether the tool is up. It descends next to the stock before the next cut.
  [[nodiscard]] bool is_up() const { return is_up_; }

  /// Lowers the tool at the centre of a cleared disc.
  void come_down(const cnc::pocket::ToolCircle& circle);

  /// Returns the circles of all cleared discs.
  [[nodiscard]] const std::vector<cnc::pocket::ToolCircle>& circles() const { return circles_; }
  [[nodiscard]] DepthWriter& writer() { return writer_; }

  /// Moves the tool back through cleared discs to the centre of the last disc. The path has no
  /// corners where the discs are large enough.
  /// @pre the tool is in the first disc
  void drive_back(const std::vector<cnc::pocket::ToolCircle>& way);

 private:
  [[nodiscard]] bool is_left_to_wall(const AxisCourse& course,
                                     double from,
                                     const cnc::pocket::ToolCircle& circle) const;
  void list_tip(const AxisCourse& course, double from);
  [[nodiscard]] double end_of_free(const AxisCourse& course, double from, CourseDrive& done);
  [[nodiscard]] double end_of_slot(const AxisCourse& course,
                                   double from,
                                   const cnc::pocket::ToolCircle& circle,
                                   bool is_dead_end) const;
  [[nodiscard]] bool drive_slot(const AxisCourse& course,
                                double from,
                                double to,
                                CourseDrive& done);
  void drive_crescent(const cnc::pocket::ToolCircle& from,
                      const cnc::pocket::ToolCircle& to,
                      CourseDrive& done);

  const OwnedArea& area_;
  AdaptiveOptions options_;
  StepLimits limits_;
  AdaptivePath& out_;
  DepthWriter writer_;
  std::vector<cnc::pocket::ToolCircle> circles_;
  bool is_up_ = false;  ///< Whether the tool is up; true only if a stock is given.
};

}  // namespace sim::pocket
