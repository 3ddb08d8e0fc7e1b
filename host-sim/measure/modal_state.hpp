#pragma once

#include <array>
#include <optional>

#include "host-sim/measure/program_line.hpp"
#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// What a program's words leave behind for the lines after them: the modal
/// groups, the offsets and the feed. Knows nothing of motion.
class ModalState {
 public:
  enum class Motion {
    kNone,
    kRapid,
    kLine,
    kClockwise,
    kCounterClockwise,
    kCubic,      ///< G5
    kQuadratic,  ///< G5.1
    kNurbs,      ///< G5.2
    kNurbsEnd,   ///< G5.3
    kProbe,
  };

  /// Units, feed, plane, offsets, coordinate system, distance and motion mode of
  /// the line, in RS274/NGC's order. Returns the G numbers that are left.
  [[nodiscard]] std::vector<int> apply_modes(const ProgramLine& line);

  /// Of G61, G61.1 and G64. @param usual mm, where the program gives no tolerance
  /// @param arc mm of it that short lines may have, of all of it half at most
  [[nodiscard]] ProgramTolerance tolerance(double usual, double arc) const;
  /// Returns the tolerance, mm, of arcs that replace a spline.
  /// @param arc mm, where the program gives no tolerance
  [[nodiscard]] double spline_tolerance(double arc) const;

  /// What M2 and M30 put back (RS274/NGC 3.6.1).
  void end_program();
  void end_nurbs() { motion_ = Motion::kNone; }

  /// Places of the axes that the line names; the other axes stay.
  [[nodiscard]] Point target(const ProgramLine& line, const Point& position) const;

  /// The arc's centre from I J K; nothing where the line has none of the plane's two.
  [[nodiscard]] std::optional<std::array<double, 2>> centre(const ProgramLine& line,
                                                            const Point& position) const;

  /// mm/s (degrees/s for a move of A B C alone) on a move of these lengths in mm
  /// or degrees; in inverse time mode from the line's own F.
  [[nodiscard]] double feed(double linear_length, double rotary_length) const;

  /// The word in mm, or in degrees for A B C.
  [[nodiscard]] double scaled(std::size_t axis, double value) const;

  /// G10 L2 and L20; false for any other G10.
  [[nodiscard]] bool set_coordinate_system(const ProgramLine& line, const Point& position);
  void set_shift(const ProgramLine& line, const Point& position);  ///< G92.
  void clear_shift() { shift_ = saved_shift_ = {}; }               ///< G92.1.
  void suspend_shift() { shift_ = {}; }                            ///< G92.2.
  void restore_shift() { shift_ = saved_shift_; }                  ///< G92.3.

  [[nodiscard]] Motion motion() const { return motion_; }
  /// Along Z, mm; G43.1, G43.4.
  [[nodiscard]] double tool_length() const { return tool_[2]; }
  [[nodiscard]] cnc::Plane plane() const { return plane_; }

 private:
  // Each is true when the number is one of its group.
  [[nodiscard]] bool apply_plane(int g);
  [[nodiscard]] bool apply_distance(int g);
  [[nodiscard]] bool apply_tool_offset(int g, const ProgramLine& line);
  [[nodiscard]] bool apply_motion(int g, const ProgramLine& line);
  [[nodiscard]] bool apply_coordinate_system(int g);
  void apply_feed(const ProgramLine& line);
  void apply_path_control(const ProgramLine& line);
  [[nodiscard]] double offset(std::size_t axis) const;

  static constexpr std::size_t kSystems = 9;  ///< G54…G59.3.

  Motion motion_ = Motion::kRapid;
  cnc::Plane plane_ = cnc::Plane::kXY;
  bool inches_ = false;
  bool incremental_ = false;
  bool absolute_centre_ = false;
  bool inverse_time_ = false;
  double feed_word_ = 0.0;
  bool feed_in_inches_ = false;
  bool stops_at_corners_ = false;        ///< G61.1
  std::optional<double> corner_word_{};  ///< mm; P of G64.
  std::optional<double> weld_word_{};    ///< mm; Q of G64.
  std::size_t system_ = 0;
  std::array<Point, kSystems> systems_{};
  Point shift_{};
  Point saved_shift_{};
  Point tool_{};
};

}  // namespace sim
