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
/// State after M5, M3 and M4.
enum class SpindleState : std::uint8_t { kOff, kConstant, kDynamic };

/// Distances by which the machine may leave the programmed path, mm.
struct ProgramTolerance {
  double corner = 0.0;  ///< Tolerance for rounding a corner: P of G64, or $11.
  double weld = 0.0;    ///< Tolerance for joining short lines: Q of G64, or $12.
  double spline = 0.0;  ///< Tolerance for replacing a spline by arcs: Q of G64, or $12.
  double motors = 0.0;  ///< Deviation by input shaping and until backlash is taken up.
};

/// How a piece is offset from its programmed path (G41, G42).
struct BesidePath {
  double offset_mm = 0.0;  ///< Offset in mm, positive to the right of the path.
  cnc::Plane plane = cnc::Plane::kXY;
};

/// One line, or one arc of at most half a turn, with its process values.
struct PathPiece {
  Curve curve;
  Travel travel = Travel::kRapid;
  /// Feed in mm/s along X Y Z, or degrees/s where only A B C move. Meaningless for rapids.
  double feed = 0.0;
  double spindle_speed = 0.0;  ///< S of the program, unchanged.
  SpindleState spindle = SpindleState::kOff;
  int line = 0;              ///< Line of the program; the first is 1.
  bool stop_before = false;  ///< Whether the machine is at rest before this piece.
  ProgramTolerance tolerance{};
  std::optional<BesidePath> beside{};  ///< The offset from the programmed path; see beside_path().
  bool continues = false;  ///< Whether the piece is part of one curve with the piece before it.

  /// Returns the programmed speed along the six-axis length of the curve; infinite for rapids.
  [[nodiscard]] double path_feed() const;
};

using PieceSink = std::function<void(const PathPiece&)>;

/// A part of the program that the reader left out.
struct ReadNote {
  int line = 0;
  std::string text;
};

/// Lines of the program whose motions G41 and G42 cannot drive offset from the programmed path.
struct RefusedBeside {
  int line = 0;
  int other_line = 0;  ///< Line of the motion that is in conflict; 0 for none.
};

/// The path that a program describes, in machine coordinates and double precision.
struct ProgrammedPath {
  Point start{};
  Point end{};
  std::vector<PathPiece> pieces;  ///< Each piece begins where the one before ends.
  std::vector<ReadNote> notes;
  std::optional<RefusedBeside> refused{};  ///< The first refusal of G41 and G42; see beside_path().

  [[nodiscard]] double length() const;  ///< Six-axis length, mm.
  [[nodiscard]] Bounds bounds() const;
};

struct ReadOptions {
  /// Whether a change of S needs no stop; a change of M3, M4 and M5 always needs one.
  bool laser_mode = false;
  bool stop_at_coolant = false;  ///< Whether M7, M8 and M9 stop.
  bool stop_at_output = false;   ///< Whether M62…M65, M67 and M68 stop.
  bool optional_stop = false;    ///< Whether M1 stops.
  double path_tolerance = 0.0;   ///< $11 in mm: the tolerance where the program gives none.
  double arc_tolerance = 0.0;    ///< $12 in mm: the part of the tolerance for short lines.
  Point start{};                 ///< Position of the machine at the start, machine coordinates.
  /// Returns the kerf of a material. If empty, G41 by the kerf is left out.
  CutWidth kerf_width{};
  /// $860=0: along an edge offset by its kerf, M3 follows the speed.
  bool power_keeps_kerf = true;
  bool block_delete = true;  ///< Whether lines with / are left out ($890).
  /// Converts a position. When G43.4 `begins`, returns the position of the tip for a position of
  /// the axes; when it ends (G49), returns the position of the axes for one of the tip. If the
  /// function is empty, G43.4 is left out.
  std::function<Point(const Point& place, double tool_length_mm, bool begins)> tool_centre{};
  /// Called for every line that begins with $, which is no G-code.
  std::function<void(std::string_view)> on_statement{};
  /// Takes the pieces one by one. The path then stays empty.
  PieceSink on_piece{};
};

/// Returns the path of a program by the simulator's own reading. It shares no code with the
/// product's parser and geometry, so that one checks the other.
///
/// Reads valid programs, up to M2, M30 or the end of the text. It leaves out words that it does not
/// understand, and notes them. Its limits are the controller's: nine digits before a point, 65,535
/// turns. Positions that only the machine can know (the contact of a probe) are taken as
/// programmed.
[[nodiscard]] ProgrammedPath read_program(std::string_view text, const ReadOptions& options = {});
[[nodiscard]] ProgrammedPath read_program(std::istream& text, const ReadOptions& options = {});

}  // namespace sim
