#include "planner/gcode/modal_words.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "planner/gcode/modal_state.hpp"

namespace cnc::gcode {

namespace {

template <typename Meaning>
constexpr ModalWord word(std::uint16_t tenths, ModalGroup group, Meaning meaning) {
  return {tenths, group, static_cast<std::uint8_t>(meaning)};
}

using enum ModalGroup;

/// The known G words. The motion words are near the start, because they are searched for most
/// often.
constexpr std::array<ModalWord, 55> kGWords{{
    word(0, kMotion, MotionMode::kRapid),
    word(10, kMotion, MotionMode::kLine),
    word(20, kMotion, MotionMode::kArcClockwise),
    word(30, kMotion, MotionMode::kArcCounterClockwise),
    word(40, kNonModal, NonModal::kDwell),
    word(50, kMotion, MotionMode::kCubicSpline),
    word(51, kMotion, MotionMode::kQuadraticSpline),
    word(52, kMotion, MotionMode::kNurbs),
    word(53, kMotion, MotionMode::kNurbsEnd),
    word(100, kNonModal, NonModal::kSetSystem),
    word(170, kPlane, Plane::kXY),
    word(180, kPlane, Plane::kZX),
    word(190, kPlane, Plane::kYZ),
    word(200, kUnits, Units::kInches),
    word(210, kUnits, Units::kMillimetres),
    word(280, kNonModal, NonModal::kGoToG28),
    word(281, kNonModal, NonModal::kStoreG28),
    word(300, kNonModal, NonModal::kGoToG30),
    word(301, kNonModal, NonModal::kStoreG30),
    word(382, kMotion, MotionMode::kProbeContact),
    word(383, kMotion, MotionMode::kProbeContactOrNot),
    word(384, kMotion, MotionMode::kProbeRelease),
    word(385, kMotion, MotionMode::kProbeReleaseOrNot),
    word(400, kCutterRadius, CutterRadius::kOff),
    word(410, kCutterRadius, CutterRadius::kLeft),
    word(411, kCutterRadius, CutterRadius::kLeftByWidth),
    word(420, kCutterRadius, CutterRadius::kRight),
    word(421, kCutterRadius, CutterRadius::kRightByWidth),
    word(431, kToolLength, ToolLength::kSet),
    word(434, kToolLength, ToolLength::kCentre),
    word(490, kToolLength, ToolLength::kCancel),
    word(530, kNonModal, NonModal::kMachineCoordinates),
    word(540, kCoordinateSystem, 0),
    word(550, kCoordinateSystem, 1),
    word(560, kCoordinateSystem, 2),
    word(570, kCoordinateSystem, 3),
    word(580, kCoordinateSystem, 4),
    word(590, kCoordinateSystem, 5),
    word(591, kCoordinateSystem, 6),
    word(592, kCoordinateSystem, 7),
    word(593, kCoordinateSystem, 8),
    word(610, kPathControl, PathMode::kPath),
    word(611, kPathControl, PathMode::kStop),
    word(640, kPathControl, PathMode::kBlend),
    word(800, kMotion, MotionMode::kNone),
    word(900, kDistance, DistanceMode::kAbsolute),
    word(901, kArcDistance, DistanceMode::kAbsolute),
    word(910, kDistance, DistanceMode::kIncremental),
    word(911, kArcDistance, DistanceMode::kIncremental),
    word(920, kNonModal, NonModal::kSetG92),
    word(921, kNonModal, NonModal::kClearG92),
    word(922, kNonModal, NonModal::kSuspendG92),
    word(923, kNonModal, NonModal::kRestoreG92),
    word(930, kFeedMode, FeedMode::kInverseTime),
    word(940, kFeedMode, FeedMode::kUnitsPerMinute),
}};

constexpr std::array<ModalWord, 18> kMWords{{
    word(0, kStop, Stop::kPause),
    word(10, kStop, Stop::kOptionalPause),
    word(20, kStop, Stop::kEnd),
    word(30, kSpindle, SpindleMode::kConstant),
    word(40, kSpindle, SpindleMode::kDynamic),
    word(50, kSpindle, SpindleMode::kOff),
    word(60, kToolChange, 0),
    word(70, kCoolant, CoolantWord::kMist),
    word(80, kCoolant, CoolantWord::kFlood),
    word(90, kCoolant, CoolantWord::kOff),
    word(300, kStop, Stop::kEnd),
    word(620, kOutput, Output::kOnWithMotion),
    word(630, kOutput, Output::kOffWithMotion),
    word(640, kOutput, Output::kOn),
    word(650, kOutput, Output::kOff),
    word(670, kOutput, Output::kAnalogWithMotion),
    word(680, kOutput, Output::kAnalog),
    word(1900, kMaterial, 0),
}};

/// G numbers that have variants with decimals, here or on other controllers. So G49.1 is reported
/// as unsupported, but G1.5 as a number that should be whole.
constexpr std::array<std::uint32_t, 12> kKnownWithDecimals{
    5, 28, 30, 38, 41, 42, 43, 49, 61, 90, 91, 92};

const ModalWord* find(std::span<const ModalWord> words, std::uint32_t tenths) {
  for (const ModalWord& word : words) {
    if (word.tenths == tenths) return &word;
  }
  return nullptr;
}

/// Returns the word with exactly this number, or null if there is none.
const ModalWord* find_exactly(std::span<const ModalWord> words, const Decimal& number) {
  constexpr std::uint32_t kBillionthsPerTenth = 100'000'000;
  const bool has_hundredths = number.billionths % kBillionthsPerTenth != 0;
  if (number.is_negative() || number.whole > 999 || has_hundredths) return nullptr;
  return find(words, number.whole * 10 + number.billionths / kBillionthsPerTenth);
}

FaultDetail why_no_g_word(const Decimal& number) {
  if (number.is_integer() || number.is_negative()) return FaultDetail::kUnsupported;
  if (number.whole == 59) return FaultDetail::kNoSuchCoordinateSystem;
  if (std::ranges::find(kKnownWithDecimals, number.whole) != kKnownWithDecimals.end()) {
    return FaultDetail::kUnsupported;
  }
  const bool slip = find_exactly(kGWords, Decimal{.whole = number.whole}) != nullptr;
  return slip ? FaultDetail::kNotAnInteger : FaultDetail::kUnsupported;
}

}  // namespace

AxisUse ModalWord::axis_use() const {
  if (group == kMotion) {
    const bool moves = meaning != static_cast<std::uint8_t>(MotionMode::kNone);
    return moves ? AxisUse::kMotion : AxisUse::kNone;
  }
  // G49 only cancels an offset and does not use axis words. So it may be in one line with a motion,
  // as in LinuxCNC.
  if (group == kToolLength) {
    const bool cancels = meaning == static_cast<std::uint8_t>(ToolLength::kCancel);
    return cancels ? AxisUse::kNone : AxisUse::kToolLength;
  }
  if (group != kNonModal) return AxisUse::kNone;
  switch (static_cast<NonModal>(meaning)) {
    case NonModal::kSetSystem:
    case NonModal::kGoToG28:
    case NonModal::kGoToG30:
    case NonModal::kSetG92:
      return AxisUse::kPlaces;
    default:
      return AxisUse::kNone;
  }
}

Result<const ModalWord*, FaultDetail> find_g_word(const Decimal& number) {
  if (const ModalWord* const found = find_exactly(kGWords, number)) return found;
  return why_no_g_word(number);
}

Result<const ModalWord*, FaultDetail> find_m_word(const Decimal& number) {
  if (const ModalWord* const found = find_exactly(kMWords, number)) return found;
  return number.is_integer() ? FaultDetail::kUnsupported : FaultDetail::kNotAnInteger;
}

const ModalWord* combined(const ModalWord& a, const ModalWord& b) {
  static constexpr ModalWord kBoth = word(80, ModalGroup::kCoolant, CoolantWord::kBoth);
  const auto ends_cycles = [](const ModalWord& modal) {
    return modal.group == ModalGroup::kMotion &&
           modal.meaning == static_cast<std::uint8_t>(MotionMode::kNone);
  };
  if (ends_cycles(a) != ends_cycles(b)) return ends_cycles(a) ? &b : &a;
  const auto is = [](const ModalWord& modal, CoolantWord wanted) {
    return modal.group == ModalGroup::kCoolant &&
           modal.meaning == static_cast<std::uint8_t>(wanted);
  };
  const bool both = (is(a, CoolantWord::kMist) && is(b, CoolantWord::kFlood)) ||
                    (is(a, CoolantWord::kFlood) && is(b, CoolantWord::kMist));
  return both ? &kBoth : nullptr;
}

}  // namespace cnc::gcode
