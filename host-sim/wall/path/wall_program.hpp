#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/wall/path/rotary_words.hpp"
#include "host-sim/wall/path/stroke_tracer.hpp"

namespace sim::wall {

/// Settings for a program that burns the runs of a beam.
struct BurnSettings {
  RotaryAxes axes = RotaryAxes::kAC;
  double feed_mm_min = 0.0;  ///< Speed of the tip over the part, above 0.
  double power_s = 0.0;      ///< S word of the beam.
  /// Whether the power follows the actual speed (M4); otherwise it is constant (M3).
  bool follows_speed = true;
  /// Turn of the axis per mm above which the tip is slowed down, > 0.
  double turn_rate_rad_per_mm = 0.0;
  double safe_mm = 0.0;  ///< Z at the start and at the end of the program, above the stock.
  int decimals = 4;      ///< Digits after the decimal point of X, Y and Z.
};

/// Counts, lengths and angles of a program.
struct BurnFigures {
  std::size_t runs = 0;
  std::size_t beams = 0;
  std::size_t lost = 0;      ///< Number of tips out of reach.
  std::size_t overlaps = 0;  ///< Number of beams whose side is inside the part.
  double burnt_mm = 0.0;
  double dark_mm = 0.0;  ///< Total distance between runs, driven with the beam off.
  double max_tilt_rad = 0.0;
  double tilt_mm = 0.0;  ///< Sum of tilt times burnt length, rad mm.
  double max_overlap_rad = 0.0;
  double max_turn_rad_per_mm = 0.0;
  /// Length on which the tip is slowed down, because the axis turns by more than the permitted
  /// angle per mm.
  double slowed_mm = 0.0;
};

/// Writes runs of a beam as G-code with tool centre point control (G43.4), and measures them. X, Y
/// and Z are the position of the tip; A or B, and C, are the direction of the axis. Between runs,
/// the beam is off.
class WallProgram {
 public:
  /// @param heading comment lines at the top
  WallProgram(const BurnSettings& settings, const std::vector<std::string>& heading);

  void add(const std::vector<BeamRun>& runs);

  /// Ends the program and returns its text. Call this function only once, because it moves the text
  /// out of the object.
  [[nodiscard]] std::string take_text();

  [[nodiscard]] const BurnFigures& figures() const { return figures_; }

 private:
  [[nodiscard]] std::vector<RotaryWords> words_of_run(const std::vector<TipBeam>& beams) const;
  void write_swing(const Eigen::Vector3d& tip, const RotaryWords& from, const RotaryWords& to);
  [[nodiscard]] double feed_of(const TipBeam& from, const TipBeam& to) const;
  void write_run(const std::vector<TipBeam>& beams);
  void write_move(const char* motion, const Eigen::Vector3d& tip, const RotaryWords& words);
  void measure(const std::vector<TipBeam>& beams);

  BurnSettings settings_;
  std::string text_;
  BurnFigures figures_;
  RotaryWords last_;
  Eigen::Vector3d here_ = Eigen::Vector3d::Zero();
  std::vector<std::string> shown_;  ///< Last written word of each axis.
  std::string feed_;                ///< Last written F word.
};

/// Appends the runs to a text, in order: `x y z i j k` with 17 digits for each beam, and `# x y z
/// is out of reach` for each lost tip.
void append_beam_lines(const std::vector<BeamRun>& runs, std::string& text);

}  // namespace sim::wall
