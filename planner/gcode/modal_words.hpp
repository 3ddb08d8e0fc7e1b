#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/base/result.hpp"
#include "planner/gcode/decimal.hpp"
#include "planner/gcode/fault.hpp"

namespace cnc::gcode {

/// The modal groups of RS274/NGC table 4, and LinuxCNC's M group 5 for outputs. A line has at most
/// one word of each group. Each comment gives the group number, and the type of ModalWord::meaning.
enum class ModalGroup : std::uint8_t {
  kNonModal,          ///< G group 0, NonModal
  kMotion,            ///< G group 1, MotionMode
  kPlane,             ///< G group 2, Plane
  kDistance,          ///< G group 3, DistanceMode
  kArcDistance,       ///< G group 4, DistanceMode
  kFeedMode,          ///< G group 5, FeedMode
  kUnits,             ///< G group 6, Units
  kCutterRadius,      ///< G group 7, CutterRadius
  kToolLength,        ///< G group 8, ToolLength
  kCoordinateSystem,  ///< G group 12, index of the coordinate system
  kPathControl,       ///< G group 13, PathMode
  kStop,              ///< M group 4, Stop
  kOutput,            ///< M group 5, Output
  kToolChange,        ///< M group 6, only M6: meaning 0
  kSpindle,           ///< M group 7, SpindleMode
  kCoolant,           ///< M group 8, CoolantWord
  kMaterial,          ///< No standard group, only M190: meaning 0
};

inline constexpr std::size_t kModalGroupCount = 17;

enum class NonModal : std::uint8_t {
  kNothing,
  kDwell,               ///< G4
  kSetSystem,           ///< G10
  kGoToG28,             ///< G28
  kStoreG28,            ///< G28.1
  kGoToG30,             ///< G30
  kStoreG30,            ///< G30.1
  kMachineCoordinates,  ///< G53
  kSetG92,              ///< G92
  kClearG92,            ///< G92.1
  kSuspendG92,          ///< G92.2
  kRestoreG92,          ///< G92.3
};

enum class CutterRadius : std::uint8_t {
  kOff,           ///< G40
  kLeft,          ///< G41: by the kerf of the material or by the radius of a tool
  kRight,         ///< G42: as G41
  kLeftByWidth,   ///< G41.1
  kRightByWidth,  ///< G42.1
};
/// Words G43.1, G49 and G43.4.
enum class ToolLength : std::uint8_t { kSet, kCancel, kCentre };
/// Words M0 and M1, and M2 or M30.
enum class Stop : std::uint8_t { kPause, kOptionalPause, kEnd };
/// Words M7, M8 and M9, and M7 with M8.
enum class CoolantWord : std::uint8_t { kMist, kFlood, kOff, kBoth };

enum class Output : std::uint8_t {
  kOnWithMotion,      ///< M62
  kOffWithMotion,     ///< M63
  kOn,                ///< M64
  kOff,               ///< M65
  kAnalogWithMotion,  ///< M67
  kAnalog,            ///< M68
};

/// The purpose for which a G word uses the X Y Z A B C words of its line. They have only one
/// purpose in a line, so a line has at most one G word that uses them.
enum class AxisUse : std::uint8_t { kNone, kMotion, kPlaces, kToolLength };

/// A G or M word that the interpreter knows.
struct ModalWord {
  std::uint16_t tenths;  ///< Number after G or M in tenths, such as 382 for G38.2.
  ModalGroup group;
  std::uint8_t meaning;  ///< Value of the enum that belongs to `group`.

  [[nodiscard]] AxisUse axis_use() const;
};

/// Return the known G or M word with this number, or a fault. The pointer refers to a constant.
[[nodiscard]] Result<const ModalWord*, FaultDetail> find_g_word(const Decimal& number);
[[nodiscard]] Result<const ModalWord*, FaultDetail> find_m_word(const Decimal& number);

/// Returns the word that has the effect of two words of one group, or null if they exclude each
/// other. Only two pairs do not exclude each other: M7 with M8 (RS274/NGC 3.6.4), and G80 with a
/// motion, as in the first lines of many programs. In the second pair only the motion has an
/// effect.
[[nodiscard]] const ModalWord* combined(const ModalWord& a, const ModalWord& b);

}  // namespace cnc::gcode
