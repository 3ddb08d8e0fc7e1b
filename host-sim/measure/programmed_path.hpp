#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/measure/curve.hpp"
#include "host-sim/measure/cutter_compensation.hpp"

namespace sim {

enum class Travel : std::uint8_t { kFeed, kRapid, kProbe };
/// State of the spindle: after M5, after M3 and after M4.
enum class SpindleState : std::uint8_t { kOff, kConstant, kDynamic };

/// Greatest distances by which the machine may leave the programmed path, mm.
struct ProgramTolerance {
  double corner = 0.0;  ///< Tolerance for rounding a corner: P of G64, or $11.
  double weld = 0.0;    ///< Tolerance for joining short lines: Q of G64, or $12.
  double spline = 0.0;  ///< Tolerance for replacing a spline by arcs: Q of G64, or $12.
  double motors = 0.0;  ///< Deviation by input shaping, and by backlash until it is taken up.
};

/// Offset of a piece from its programmed path (G41, G42).
struct BesidePath {
  double offset_mm = 0.0;  ///< Offset, mm; positive to the right of the path.
  cnc::Plane plane = cnc::Plane::kXY;
};

/// One line, or one arc of at most half a turn, with its process values.
struct PathPiece {
  Curve curve;
  Travel travel = Travel::kRapid;
  /// Feed in mm/s along X Y Z, or in degrees/s if only A B C move. Meaningless for rapids.
  double feed = 0.0;
  double spindle_speed = 0.0;  ///< Value of S in the program, unchanged.
  SpindleState spindle = SpindleState::kOff;
  int line = 0;              ///< Line of the program; the first is 1.
  bool stop_before = false;  ///< Whether the machine is at rest before this piece.
  ProgramTolerance tolerance{};
  std::optional<BesidePath> beside{};  ///< Offset from the programmed path; see beside_path().
  bool continues = false;  ///< Whether the piece and the previous piece are parts of one curve.

  /// Returns the programmed speed along the six-axis length of the curve; infinite for rapids.
  [[nodiscard]] double path_feed() const;
};

using PieceSink = std::function<void(const PathPiece&)>;

/// A note about a part of the program that the reader ignored.
struct ReadNote {
  int line = 0;
  std::string text;
};

/// The lines of two motions that G41 or G42 cannot drive offset from the programmed path.
struct RefusedBeside {
  int line = 0;
  int other_line = 0;  ///< Line of the second motion of the conflict; 0 if there is none.
};

/// The path that a program describes, in machine coordinates and double precision.
struct ProgrammedPath {
  Point start{};
  Point end{};
  /// Pieces of the path. Each piece begins at the end of the previous one.
  std::vector<PathPiece> pieces;
  std::vector<ReadNote> notes;
  std::optional<RefusedBeside> refused{};  ///< First refusal of G41 or G42; see beside_path().

  [[nodiscard]] double length() const;  ///< Returns the six-axis length, mm.
  [[nodiscard]] Bounds bounds() const;
};

struct ReadOptions {
  /// Whether the machine stays in motion at a change of S. It always stops at M3, M4 and M5.
  bool laser_mode = false;
  bool stop_at_coolant = false;  ///< Whether the machine stops at M7, M8 and M9.
  bool stop_at_output = false;   ///< Whether the machine stops at M62…M65, M67 and M68.
  bool optional_stop = false;    ///< Whether the machine stops at M1.
  double path_tolerance = 0.0;   ///< Tolerance if the program sets none, mm ($11).
  double arc_tolerance = 0.0;    ///< Part of path_tolerance for joining short lines, mm ($12).
  Point start{};                 ///< Position of the machine at the start, in machine coordinates.
  /// Returns the kerf of a material. If it is empty, G41 and G42 by the kerf are ignored.
  CutWidth kerf_width{};
  /// Whether M3 acts as M4 along an edge that is offset by its kerf ($860=0).
  bool power_keeps_kerf = true;
  bool block_delete = true;  ///< Whether lines with / are ignored ($890).
  /// Converts a position. If `begins` (G43.4), returns the position of the tip for a position of
  /// the axes. Otherwise (G49), returns the position of the axes for a position of the tip. If the
  /// function is empty, G43.4 is ignored.
  std::function<Point(const Point& place, double tool_length_mm, bool begins)> tool_centre{};
  /// Called for every line that begins with $; such a line is not G-code.
  std::function<void(std::string_view)> on_statement{};
  /// Receives the pieces one by one. If it is set, the path stays empty.
  PieceSink on_piece{};
};

/// Returns the path of a program, read by the simulator's own reader. The reader shares no code
/// with the product's parser and geometry, so that each can check the other.
///
/// It reads valid programs, up to M2, M30 or the end of the text. It ignores words that it does not
/// support, and adds notes about them. Its limits are the controller's limits: nine digits before a
/// decimal point, 65,535 turns. For positions that only the machine can know (the contact of a
/// probe), it uses the programmed position.
[[nodiscard]] ProgrammedPath read_program(std::string_view text, const ReadOptions& options = {});
[[nodiscard]] ProgrammedPath read_program(std::istream& text, const ReadOptions& options = {});

}  // namespace sim
