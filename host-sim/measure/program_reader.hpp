#pragma once

#include <string_view>

#include "host-sim/measure/modal_state.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/measure/programmed_spline.hpp"

namespace sim {

/// Reads programs one after another, as a machine does: offsets, position and most modes remain
/// from one program to the next. For a single program, see read_program().
class ProgramReader {
 public:
  explicit ProgramReader(const ReadOptions& options = {});

  /// Reads one program, up to M2, M30 or the end of the text. Line numbers begin at 1.
  void read(std::string_view text);
  /// Reads one line of a program. The first line has the number 1.
  void read_line(std::string_view text, int number);
  /// Sets the position after a motion that the program did not command, such as homing.
  void set_position(const Point& position) { path_.end = position_ = position; }
  /// Returns whether the last line that was read had M2 or M30.
  [[nodiscard]] bool ended() const { return ended_; }

  /// Returns the path of all lines that were read.
  [[nodiscard]] const ProgrammedPath& path() const { return path_; }

 private:
  void apply_spindle(const ProgramLine& line);
  void apply_outputs(const ProgramLine& line);
  void apply_compensation(const ProgramLine& line);
  void apply_tool_centre(const ProgramLine& line);
  void switch_tool_centre(bool begins, double tool_length_mm);
  void stop_or_end(const ProgramLine& line);
  /// Applies the G numbers that are not modes. Returns whether one of them used the axis words.
  [[nodiscard]] bool apply_single(const ProgramLine& line, const std::vector<int>& numbers);
  [[nodiscard]] bool apply_home(const ProgramLine& line, int g);
  [[nodiscard]] bool apply_offset(const ProgramLine& line, int g);
  void go_by_way_to(const ProgramLine& line, const Point& home);
  void move(const ProgramLine& line);
  void move_in_parts(const ProgramLine& line, const Point& to);
  void move_straight(const Point& to, Travel travel);
  void move_round(const ProgramLine& line, const Point& to, bool clockwise);
  // The functions for splines are defined in program_reader_spline.cpp.
  void move_cubic(const ProgramLine& line, const Point& to);
  void move_quadratic(const ProgramLine& line, const Point& to);
  void take_control_point(const ProgramLine& line, const Point& to);
  void end_nurbs();
  void move_along(const ProgrammedSpline& spline);
  void note_third_offset(const ProgramLine& line);
  void add_piece(const Curve& curve, Travel travel, double feed);
  void note(std::string text);

  ReadOptions options_;
  ProgrammedPath path_;
  ModalState modes_;
  CutterCompensation compensation_;
  Point position_{};
  Point first_home_{};                ///< Position to which G28 moves.
  Point second_home_{};               ///< Position to which G30 moves.
  std::array<double, 2> last_arm_{};  ///< P and Q of the last G5, mm.
  std::optional<ProgrammedSpline> nurbs_{};
  double spline_tolerance_ = 0.0;  ///< Tolerance of the pieces of the present spline, mm.
  double spindle_speed_ = 0.0;
  SpindleState spindle_ = SpindleState::kOff;
  int line_number_ = 0;
  bool stop_pending_ = true;
  /// Length of the tool under G43.4, mm; none without G43.4.
  std::optional<double> centre_length_{};
  bool ended_ = false;
  /// Whether the tool is still offset from the path: after G40, until a motion in the plane.
  bool is_beside_ = false;
  /// Whether the next motion is the exit from an edge that was compensated by its kerf.
  bool leaves_edge_ = false;
};

}  // namespace sim
