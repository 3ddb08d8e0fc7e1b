#pragma once

#include <vector>

#include "host-sim/pocket/adaptive_path.hpp"
#include "host-sim/pocket/axis_course.hpp"
#include "host-sim/pocket/depth_writer.hpp"

namespace sim::pocket {

/// What a tool has done along a course.
struct CourseDrive {
  /// Cleared discs through whose centres the tool comes back to where the course began: the way
  /// from each centre to the next lies in the union of both discs.
  std::vector<cnc::pocket::ToolCircle> way_back;
  bool is_complete = false;  ///< It came to the end.
};

/// Clears along the axis: by crescents, and where that is too narrow for them, in slots.
class CrescentDriver {
 public:
  CrescentDriver(const OwnedArea& area, const AdaptiveOptions& options, AdaptivePath& out);

  /// Clears along a course. @param start the circle at its beginning, on or in which the tool is,
  /// and whose disc is cleared
  /// @param is_dead_end nothing goes on at the course's end
  CourseDrive drive(const AxisCourse& course,
                    const cnc::pocket::ToolCircle& start,
                    bool is_dead_end);

  /// Opens a disc in full stock: by an entry, and a spiral outwards within the engagement. Leaves
  /// the tool on the circle.
  /// @param way  from its centre on, for a ramp; see enter_stock()
  void open_disc(const cnc::pocket::ToolCircle& circle, const std::vector<cnc::WideVec2>& way);

  /// Takes a disc that meets no stock, beside which the tool comes down.
  void take_free_disc(const cnc::pocket::ToolCircle& circle);

  /// Returns whether the disc that a tool clears on a circle meets no stock.
  [[nodiscard]] bool is_free(const cnc::pocket::ToolCircle& circle) const;

  /// Returns whether the tool is up, and comes down beside the stock when it is needed.
  [[nodiscard]] bool is_up() const { return is_up_; }

  /// Brings the tool down at the centre of a cleared disc.
  void come_down(const cnc::pocket::ToolCircle& circle);

  /// All circles whose discs are cleared.
  [[nodiscard]] const std::vector<cnc::pocket::ToolCircle>& circles() const { return circles_; }
  [[nodiscard]] DepthWriter& writer() { return writer_; }

  /// Brings the tool back through cleared discs to the centre of the last one, without corners
  /// where the discs have room. @pre the tool is in the first disc
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
  bool is_up_ = false;  ///< Only where stock is given.
};

}  // namespace sim::pocket
