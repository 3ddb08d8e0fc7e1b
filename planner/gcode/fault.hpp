#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace cnc::gcode {

/// Error numbers of Grbl 1.1, which senders translate for their users.
enum class ErrorCode : std::uint8_t {
  kExpectedLetter = 1,
  kBadNumber = 2,
  kNegativeValue = 4,
  kLineTooLong = 11,
  kNotAJog = 16,
  kUnsupportedWord = 20,
  kModalGroupTwice = 21,
  kFeedUndefined = 22,
  kNotAnInteger = 23,
  kAxisWordsClaimedTwice = 24,
  kWordRepeated = 25,
  kAxisWordsMissing = 26,
  kBadLineNumber = 27,
  kValueWordMissing = 28,
  kNoSuchCoordinateSystem = 29,
  kG53NeedsStraightMotion = 30,
  kAxisWordsUnused = 31,
  kNoAxisWordInPlane = 32,
  kInvalidTarget = 33,
  kInvalidRadius = 34,
  kNoOffsetInPlane = 35,
  kWordUnused = 36,
  kToolOffsetAxis = 37,
  kValueTooLarge = 38,
};

/// The exact fault, finer than Grbl's numbers: each detail has one number and one sentence, both in
/// fault.cpp, in this order.
enum class FaultDetail : std::uint8_t {
  kNotALetter,
  kForeignByte,
  kUnclosedComment,
  kNestedComment,
  kPercentNotAlone,
  kExpression,
  kNumberMissing,
  kExpressionForNumber,
  kNumberTooLong,
  kNegative,
  kBelowOne,
  kLineTooLong,
  kUnsupported,
  kOWord,
  kModalGroupTwice,
  kFeedMissing,
  kInverseTimeFeedMissing,
  kNotAnInteger,
  kAxisWordsClaimedTwice,
  kRepeated,
  kAxisWordsMissing,
  kLineNumberTooLarge,
  kWordMissing,
  kNoSuchCoordinateSystem,
  kG53NeedsStraightMotion,
  kAxisWordUnused,
  kNoAxisWordInPlane,
  kTargetOutOfRange,
  kOffsetOutOfRange,
  kCentreOutOfRange,
  kCentreIsStart,
  kEndOffCircle,
  kEndIsStart,
  kProbeGoesNowhere,
  kRadiusIsZero,
  kRadiusOutOfRange,
  kChordLongerThanDiameter,
  kNoOffsetInPlane,
  kCentreIncomplete,
  kUnused,
  kToolOffsetNeedsZAlone,
  kTooLarge,
  kMotionTooLong,
  kNotInAJog,
  kSplineNeedsG17,
  kAxisNotInSpline,
  kArmMissing,
  kControlPointOutOfRange,
  kNurbsNotOpen,
  kNotInANurbs,
  kMovedInANurbs,
  kTooFewControlPoints,
  kTooManyControlPoints,
  kNotAnOrder,
  kNotAWeight,
  kTooManyPowers,
  kPowersNeedLaser,
  kPowersNeedLine,
  kNotBesideThePath,
  kAlreadyBesideThePath,
  kNotInToolChange,
  kBeyondTravel,
  kNotACutWidth,
  kNoSuchMaterial,
  kMaterialMissing,
  kToolHasNoRadius,
  kKerfNeedsWatts,
  kNotThisThickness,
  kNotThisPower,
  kNotThisSpeed,
  kNoSpeedAtAll,
  kToolCentreTakesZAlone,
  kNotFiveAxes,
  kNotAtToolCentre,
  kToolCentreAlone,
};

inline constexpr std::size_t kFaultDetailCount =
    static_cast<std::size_t>(FaultDetail::kToolCentreAlone) + 1;

/// Why a line was refused. A refused line changes nothing and moves nothing.
struct Fault {
  FaultDetail detail = FaultDetail::kNotALetter;
  char letter = ' ';  ///< Letter of the word at fault; ' ' where there is none.
  /// Column of the word, 1-based, in bytes; 0 where no word is at fault.
  std::uint16_t column = 0;
  float value = 0.0F;  ///< Value of the word, or the deviation in mm.
  float limit = 0.0F;  ///< Limit with which `value` was compared.

  [[nodiscard]] ErrorCode code() const;
};

/// Result of a check: nothing, or the fault that was found.
using Refusal = std::optional<Fault>;

/// Writes the fault as words, without its number and column, for example "arc end is 0.123 mm off
/// its circle, limit 0.050 mm". The text is cut off at the end of `out`, and has no terminating
/// zero. No sentence contains "ok" or "error" in any case: senders take a line with either word for
/// an acknowledgement.
/// @return number of bytes written.
[[nodiscard]] std::size_t describe(const Fault& fault, std::span<char> out);

}  // namespace cnc::gcode
