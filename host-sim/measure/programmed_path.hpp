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
enum class SpindleState : std::uint8_t { kOff, kConstant, kDynamic };  ///< M5, M3, M4.

/// How far from the programmed path the machine may go, mm.
struct ProgramTolerance {
  double corner = 0.0;  ///< To round a corner: P of G64, or of $11.
  double weld = 0.0;    ///< To join short lines: Q of G64, or $12.
  double spline = 0.0;  ///< To replace a spline by arcs: Q of G64, or $12.
  double motors = 0.0;  ///< By input shaping and until backlash is taken up.
};

/// Where a piece is driven that is not driven where it is programmed (G41, G42).
struct BesidePath {
  double offset_mm = 0.0;  ///< Positive to the right of the path.
  cnc::Plane plane = cnc::Plane::kXY;
};

/// One line or one arc of at most half a turn, with what rides along.
struct PathPiece {
  Curve curve;
  Travel travel = Travel::kRapid;
  /// mm/s along X Y Z; degrees/s where only A B C move. Meaningless for rapids.
  double feed = 0.0;
  double spindle_speed = 0.0;  ///< S as programmed.
  SpindleState spindle = SpindleState::kOff;
  int line = 0;              ///< Of the program, the first is 1.
  bool stop_before = false;  ///< The machine stands still before this piece.
  ProgramTolerance tolerance{};
  std::optional<BesidePath> beside{};  ///< See beside_path().
  bool continues = false;              ///< Part of one curve with the piece before it.

  /// The wanted speed in the six-axis length of the curve; infinite for rapids.
  [[nodiscard]] double path_feed() const;
};

using PieceSink = std::function<void(const PathPiece&)>;

/// Something in the program that the reader left out.
struct ReadNote {
  int line = 0;
  std::string text;
};

/// Lines of the program whose motions G41 and G42 cannot drive beside what is programmed.
struct RefusedBeside {
  int line = 0;
  int other_line = 0;  ///< Of the motion that is in the way; 0 for none.
};

/// What a program asks for, in machine coordinates and double precision.
struct ProgrammedPath {
  Point start{};
  Point end{};
  std::vector<PathPiece> pieces;  ///< Each begins where the former ends.
  std::vector<ReadNote> notes;
  std::optional<RefusedBeside> refused{};  ///< See beside_path().

  [[nodiscard]] double length() const;  ///< Six-axis length, mm.
  [[nodiscard]] Bounds bounds() const;
};

struct ReadOptions {
  /// A change of S needs no stop; one of M3, M4 and M5 always does.
  bool laser_mode = false;
  bool stop_at_coolant = false;  ///< M7, M8, M9.
  bool stop_at_output = false;   ///< M62…M65, M67, M68.
  bool optional_stop = false;    ///< M1 stops.
  double path_tolerance = 0.0;   ///< mm, $11: where the program says no other.
  double arc_tolerance = 0.0;    ///< mm, $12: of it for short lines.
  Point start{};                 ///< Where the machine stands, machine coordinates.
  CutWidth kerf_width{};         ///< Of a material; without it G41 by the kerf is left out.
  bool power_keeps_kerf = true;  ///< $860=0: beside an edge by its kerf M3 follows the speed.
  bool block_delete = true;      ///< $890: lines with / are left out.
  /// Returns the place of the tip for one of the axes, as G43.4 takes it, or of the axes for one of
  /// the tip, as G49 does; the tool's length in mm. Without it G43.4 is left out.
  std::function<Point(const Point& place, double tool_length_mm, bool begins)> tool_centre{};
  /// Told every line that begins with $, which is no G-code.
  std::function<void(std::string_view)> on_statement{};
  /// Gets the pieces one by one instead of the path, which stays empty.
  PieceSink on_piece{};
};

/// The simulator's own reading of a program. It shares no code with the
/// product's parser and geometry, so that one checks the other.
///
/// Reads valid programs, up to M2, M30 or the end of the text. What it does not
/// understand it leaves out and notes. Its limits are the controller's: nine digits before a point,
/// 65,535 turns. Places that the machine alone can know
/// (the contact of a probe) are taken as programmed.
[[nodiscard]] ProgrammedPath read_program(std::string_view text, const ReadOptions& options = {});
[[nodiscard]] ProgrammedPath read_program(std::istream& text, const ReadOptions& options = {});

}  // namespace sim
