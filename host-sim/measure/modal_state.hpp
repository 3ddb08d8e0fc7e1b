#pragma once

#include <array>
#include <optional>

#include "host-sim/measure/program_line.hpp"
#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// Modal state that the words of a program leave for later lines: the modal groups, the offsets and
/// the feed. It does not contain the motions.
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

  /// Applies units, feed, plane, offsets, coordinate system, distance mode and motion mode of a
  /// line, in the order of RS274/NGC. Returns the remaining G numbers.
  [[nodiscard]] std::vector<int> apply_modes(const ProgramLine& line);

  /// Returns the tolerance that G61, G61.1 or G64 sets.
  /// @param usual tolerance if the program sets none, mm
  /// @param arc share of `usual` for joining short lines, mm; at most half of `usual` counts
  [[nodiscard]] ProgramTolerance tolerance(double usual, double arc) const;
  /// Returns the tolerance for arcs that replace a spline, mm.
  /// @param arc tolerance if the program sets none, mm
  [[nodiscard]] double spline_tolerance(double arc) const;

  /// Resets the modes that M2 and M30 reset (RS274/NGC 3.6.1).
  void end_program();
  void end_nurbs() { motion_ = Motion::kNone; }

  /// Returns the target of a line: the line's positions for the axes in it, and the present
  /// positions for all other axes.
  [[nodiscard]] Point target(const ProgramLine& line, const Point& position) const;

  /// Returns the arc's centre from I J K; none if the line has neither of the plane's two words.
  [[nodiscard]] std::optional<std::array<double, 2>> centre(const ProgramLine& line,
                                                            const Point& position) const;

  /// Returns the feed for a move with these lengths in mm or degrees. The unit is mm/s, or
  /// degrees/s if only A B C move. In inverse time mode, the line's own F counts.
  [[nodiscard]] double feed(double linear_length, double rotary_length) const;

  /// Returns the value of a word in mm, or in degrees for A B C.
  [[nodiscard]] double scaled(std::size_t axis, double value) const;

  /// Applies G10 L2 and L20. Returns false for any other G10.
  [[nodiscard]] bool set_coordinate_system(const ProgramLine& line, const Point& position);
  void set_shift(const ProgramLine& line, const Point& position);  ///< Applies G92.
  void clear_shift() { shift_ = saved_shift_ = {}; }               ///< Applies G92.1.
  void suspend_shift() { shift_ = {}; }                            ///< Applies G92.2.
  void restore_shift() { shift_ = saved_shift_; }                  ///< Applies G92.3.

  [[nodiscard]] Motion motion() const { return motion_; }
  /// Returns the tool length along Z from G43.1 or G43.4, mm.
  [[nodiscard]] double tool_length() const { return tool_[2]; }
  [[nodiscard]] cnc::Plane plane() const { return plane_; }

 private:
  // Each apply_ function returns whether `g` belongs to its group.
  [[nodiscard]] bool apply_plane(int g);
  [[nodiscard]] bool apply_distance(int g);
  [[nodiscard]] bool apply_tool_offset(int g, const ProgramLine& line);
  [[nodiscard]] bool apply_motion(int g, const ProgramLine& line);
  [[nodiscard]] bool apply_coordinate_system(int g);
  void apply_feed(const ProgramLine& line);
  void apply_path_control(const ProgramLine& line);
  [[nodiscard]] double offset(std::size_t axis) const;

  static constexpr std::size_t kSystems = 9;  ///< Number of coordinate systems, G54…G59.3.

  Motion motion_ = Motion::kRapid;
  cnc::Plane plane_ = cnc::Plane::kXY;
  bool inches_ = false;
  bool incremental_ = false;
  bool absolute_centre_ = false;
  bool inverse_time_ = false;
  double feed_word_ = 0.0;
  bool feed_in_inches_ = false;
  bool stops_at_corners_ = false;        ///< Whether G61.1 is active.
  std::optional<double> corner_word_{};  ///< Tolerance for corners, P of G64, mm.
  std::optional<double> weld_word_{};    ///< Tolerance for joining short lines, Q of G64, mm.
  std::size_t system_ = 0;
  std::array<Point, kSystems> systems_{};
  Point shift_{};
  Point saved_shift_{};
  Point tool_{};
};

}  // namespace sim
