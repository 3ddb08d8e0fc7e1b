#pragma once

#include <array>
#include <optional>

#include "host-sim/measure/program_line.hpp"
#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// Modal state that the words of a program leave for later lines: the modal groups, the offsets and
/// the feed. It does not know the motions.
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

  /// Applies units, feed, plane, offsets, coordinate system, distance and motion mode of the line,
  /// in RS274/NGC's order. Returns the remaining G numbers.
  [[nodiscard]] std::vector<int> apply_modes(const ProgramLine& line);

  /// Returns the tolerance by G61, G61.1 and G64.
  /// @param usual tolerance in mm, where the program gives none
  /// @param arc share of it in mm that short lines may have, at most half of it
  [[nodiscard]] ProgramTolerance tolerance(double usual, double arc) const;
  /// Returns the tolerance in mm of arcs that replace a spline.
  /// @param arc tolerance in mm, where the program gives none
  [[nodiscard]] double spline_tolerance(double arc) const;

  /// Resets the modes that M2 and M30 reset (RS274/NGC 3.6.1).
  void end_program();
  void end_nurbs() { motion_ = Motion::kNone; }

  /// Returns the target of a line: the positions of the axes that it names, and the present
  /// positions of the other axes.
  [[nodiscard]] Point target(const ProgramLine& line, const Point& position) const;

  /// Returns the arc's centre from I J K; empty where the line has neither of the plane's two
  /// words.
  [[nodiscard]] std::optional<std::array<double, 2>> centre(const ProgramLine& line,
                                                            const Point& position) const;

  /// Returns the feed in mm/s (degrees/s for a move of A B C alone) for a move of these lengths in
  /// mm or degrees. In inverse time mode the line's own F counts.
  [[nodiscard]] double feed(double linear_length, double rotary_length) const;

  /// Returns the word in mm, or in degrees for A B C.
  [[nodiscard]] double scaled(std::size_t axis, double value) const;

  /// Applies G10 L2 and L20. Returns false for any other G10.
  [[nodiscard]] bool set_coordinate_system(const ProgramLine& line, const Point& position);
  void set_shift(const ProgramLine& line, const Point& position);  ///< Applies G92.
  void clear_shift() { shift_ = saved_shift_ = {}; }               ///< Applies G92.1.
  void suspend_shift() { shift_ = {}; }                            ///< Applies G92.2.
  void restore_shift() { shift_ = saved_shift_; }                  ///< Applies G92.3.

  [[nodiscard]] Motion motion() const { return motion_; }
  /// Returns the tool length along Z of G43.1 or G43.4, mm.
  [[nodiscard]] double tool_length() const { return tool_[2]; }
  [[nodiscard]] cnc::Plane plane() const { return plane_; }

 private:
  // Each apply_ function returns whether the number is one of its group.
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
  bool stops_at_corners_ = false;        ///< G61.1
  std::optional<double> corner_word_{};  ///< P of G64, mm.
  std::optional<double> weld_word_{};    ///< Q of G64, mm.
  std::size_t system_ = 0;
  std::array<Point, kSystems> systems_{};
  Point shift_{};
  Point saved_shift_{};
  Point tool_{};
};

}  // namespace sim
