#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace cnc::gcode {

/// Error numbers of Grbl 1.1. Senders have an explanation for each of them.
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

/// The exact fault. Several faults may share one error number of Grbl. The number and the sentence
/// of each fault are listed in fault.cpp in the order of this enum.
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

/// Reason for which a line was refused. A refused line has no effect.
struct Fault {
  FaultDetail detail = FaultDetail::kNotALetter;
  char letter = ' ';  ///< Letter of the word at fault; ' ' if there is no such word.
  /// Column of the word in bytes, from 1; 0 if no word is at fault.
  std::uint16_t column = 0;
  float value = 0.0F;  ///< Number of the word, or the value that is wrong.
  float limit = 0.0F;  ///< Limit with which `value` was compared.

  [[nodiscard]] ErrorCode code() const;
};

/// Result of a check: nothing if it was passed, or the fault that was found.
using Refusal = std::optional<Fault>;

/// Writes the explanation of a fault without its number and column, for example "arc end is 0.123
/// mm off its circle, limit 0.050 mm". The text is cut off at the end of `out` and has no
/// terminating zero. No explanation contains "ok" or "error" in upper or lower case, because
/// senders would read such a line as an acknowledgement.
/// @return number of bytes that were written
[[nodiscard]] std::size_t describe(const Fault& fault, std::span<char> out);

}  // namespace cnc::gcode
