#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/base/axes.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/gcode/action.hpp"

namespace cnc::gcode {

enum class MotionMode : std::uint8_t {
  kRapid,                ///< G0
  kLine,                 ///< G1
  kArcClockwise,         ///< G2
  kArcCounterClockwise,  ///< G3
  kCubicSpline,          ///< G5
  kQuadraticSpline,      ///< G5.1
  kNurbs,                ///< G5.2: a NURBS is open and takes control points.
  kNurbsEnd,             ///< G5.3: exists only as a word. The mode after it is kNone.
  kProbeContact,         ///< G38.2: towards contact; no contact is a fault.
  kProbeContactOrNot,    ///< G38.3: towards contact; no contact is permitted.
  kProbeRelease,         ///< G38.4: away from contact; no release is a fault.
  kProbeReleaseOrNot,    ///< G38.5: away from contact; no release is permitted.
  kNone,                 ///< G80
};

/// Modes of G90 and G91, or of G90.1 and G91.1.
enum class DistanceMode : std::uint8_t { kAbsolute, kIncremental };
enum class FeedMode : std::uint8_t { kUnitsPerMinute, kInverseTime };  ///< Modes of G94 and G93.
enum class Units : std::uint8_t { kMillimetres, kInches };             ///< Units of G21 and G20.

/// Accuracy with which the programmed path is followed (RS274/NGC 3.5.14).
enum class PathMode : std::uint8_t {
  kPath,   ///< G61: the whole path is followed within $11.
  kStop,   ///< G61.1: an exact stop at every corner.
  kBlend,  ///< G64: corners are rounded within P, and short lines are welded within Q.
};

/// Path control (G group 13). If G64 has P but not Q, P holds for both, as in LinuxCNC. Unlike in
/// LinuxCNC, G64 without P and Q does not permit unlimited deviations: it has the effect of G61.
struct PathControl {
  PathMode mode = PathMode::kPath;
  std::optional<float> tolerance_mm{};  ///< P of G64, ≥ 0.
  /// Q of G64, ≥ 0. If it is not given, P holds.
  std::optional<float> naive_tolerance_mm{};
  constexpr bool operator==(const PathControl&) const = default;
};

/// The material to be cut, as selected by M190.
struct Material {
  std::uint32_t table = 0;         ///< P: index of the kerf table in the list of `$K`.
  std::uint32_t thickness_um = 0;  ///< Q; 0 if no material is selected.
  constexpr bool operator==(const Material&) const = default;
};

/// Number of coordinate systems: G54…G59 and G59.1…G59.3.
inline constexpr std::size_t kCoordinateSystemCount = 9;

/// The modal state: everything that a line sets for later lines, except offsets and position. The
/// defaults are those of Grbl 1.1 at start-up.
struct ModalState {
  MotionMode motion = MotionMode::kRapid;
  Plane plane = Plane::kXY;
  DistanceMode distance = DistanceMode::kAbsolute;
  DistanceMode arc_distance = DistanceMode::kIncremental;
  FeedMode feed_mode = FeedMode::kUnitsPerMinute;
  Units units = Units::kMillimetres;
  std::uint8_t coordinate_system = 0;  ///< Index; 0 is G54.
  PathControl path{};
  CutterCompensation compensation{};
  Material material{};
  bool tool_length_in_use = false;  ///< True after G43.1 or G43.4, false after G49.
  /// G43.4 is active: programmed positions are those of the tip, also while rotary axes turn.
  bool tool_centre = false;
  SpindleMode spindle = SpindleMode::kOff;
  Coolant coolant{};

  std::uint32_t tool = 0;
  std::uint32_t line_number = 0;  ///< N of the last line; 0 if the line has no N.
  float spindle_speed = 0.0F;     ///< S as it is written in the program.
  /// F in mm/s. It is converted when it is read, so G20 and G21 do not change it later. 0 if no
  /// feed is set, which is always so in G93.
  float feed = 0.0F;
  float rotary_feed = 0.0F;  ///< F in degrees/s, for lines in which only A B C move.

  constexpr bool operator==(const ModalState&) const = default;
};

/// Offsets of G92 and of the tool, which are added to the origin of the coordinate system in use.
struct Shift {
  Position g92{};            ///< Offset of G92; kept while G92.2 suspends it.
  bool g92_in_use = false;   ///< True from G92 or G92.3 until G92.1 or G92.2.
  Coordinate tool_length{};  ///< Tool length along Z (G43.1).

  constexpr bool operator==(const Shift&) const = default;
};

/// Number of rows of tool radii. Radii are stored for the tools 1…12, six in each row.
inline constexpr std::size_t kToolRows = 2;
inline constexpr std::uint32_t kToolCount = kToolRows * kAxisCount;

/// Positions and radii that stay after the end of a program. The firmware stores them in flash.
struct StoredPlaces {
  /// Origins of the coordinate systems, in machine coordinates.
  std::array<Position, kCoordinateSystemCount> systems{};
  Position g28{};
  Position g30{};
  /// Radii of tools (G10 L1), in rows that are stored like positions. 0 means an unknown radius.
  std::array<AxisArray<Coordinate>, kToolRows> tool_radii{};

  static constexpr std::size_t kCount = kCoordinateSystemCount + 2 + kToolRows;

  constexpr bool operator==(const StoredPlaces&) const = default;
};

/// Returns the stored position or row of radii at an index. @pre index < kCount
template <typename Places>
[[nodiscard]] constexpr auto& place_at(Places& places, std::size_t index) {
  constexpr std::size_t kHomes = kCoordinateSystemCount;
  if (index < kHomes) return places.systems[index];
  if (index < kHomes + 2) return index == kHomes ? places.g28 : places.g30;
  return places.tool_radii[index - kHomes - 2];
}

}  // namespace cnc::gcode
