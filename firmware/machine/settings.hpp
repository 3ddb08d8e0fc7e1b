#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

#include "planner/base/axes.hpp"
#include "planner/base/result.hpp"

namespace cnc {

/// Group under which a sender shows a setting. The numbers are those of `$EG`.
enum class SettingGroup : std::uint8_t {
  kGeneral = 1,
  kControlSignals,
  kLimits,
  kHoming,
  kProbing,
  kJogging,
  kSpindle,
  kCoolant,
  kParking,
  kToolChange,
  kStepper,
  kArcs,
  kAxes,
  kX,
  kY,
  kZ,
  kA,
  kB,
  kC,
};
inline constexpr std::size_t kSettingGroupCount = 19;

struct SettingGroupInfo {
  std::uint8_t parent;  ///< Number of a group; 0 is the root.
  const char* name;
};

/// Kind of control with which a sender edits a value. The numbers are those of grblHAL.
enum class SettingType : std::uint8_t {
  kSwitch = 0,
  kBits = 1,    ///< The format names the bits, from bit 0 on.
  kChoice = 3,  ///< The format names the values, from 0 on.
  kAxisMask = 4,
  kInteger = 5,
  kDecimal = 6,
};

/// One or two sentences that explain a setting to the user. In images that are compiled for size,
/// all settings have the same text, to save flash.
template <bool kIsKept>
class SettingHelp {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): rows of the table have plain strings.
  constexpr SettingHelp(const char* sentences) : text_(sentences) {}

  [[nodiscard]] constexpr const char* text() const { return text_; }

 private:
  const char* text_;
};

template <>
class SettingHelp<false> {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor): rows of the table have plain strings.
  constexpr SettingHelp(const char* /*sentences*/) {}

  [[nodiscard]] static constexpr const char* text() {
    return "Images for 512 KiB have no descriptions; Kerfline's docs have them.";
  }
};

/// One user setting. The user writes its `number` and value, such as `$110=12000`.
struct SettingInfo {
  std::uint16_t number;
  SettingGroup group;
  SettingType type;
  const char* name;  ///< Name; if there is an axis_letter(), it is shown before the name.
  const char* unit;
  float least;
  float most;
  float standard;      ///< Default value.
  const char* format;  ///< Format of grblHAL's `$ES`; `type` determines its meaning.
  [[no_unique_address]] SettingHelp<KERFLINE_SETTING_HELP != 0> help;

  /// Returns whether the setting takes whole numbers only.
  [[nodiscard]] constexpr bool is_whole() const { return type != SettingType::kDecimal; }

  /// Returns the letter of the axis to which the setting belongs; 0 if it does not belong to one
  /// axis.
  [[nodiscard]] constexpr char axis_letter() const {
    if (group < SettingGroup::kX) return 0;
    return kAxisLetters[static_cast<std::size_t>(group) -
                        static_cast<std::size_t>(SettingGroup::kX)];
  }
};

enum class SettingError : std::uint8_t {
  kUnknown,     ///< No setting has this number.
  kBelowRange,  ///< The value is below the minimum of the table.
  kAboveRange,
  kNotWhole,
  kPlaceLost,  ///< With this resolution, the present position would be out of range.
  kInUse,      ///< The setting cannot change while G43.4 uses it.
};

/// Returns the reason in words, for a message.
[[nodiscard]] std::string_view describe(SettingError error);

/// All settings, in the order of their numbers. Names are those of the Grbl 1.1 and grblHAL
/// documents; numbers from 810 on are Kerfline's own. A SettingInfo is made on access, because
/// settings that exist for each axis share one row in flash.
class SettingTable {
 public:
  class Iterator {
   public:
    // NOLINTBEGIN(readability-identifier-naming): names that std::iterator_traits requires.
    using iterator_category = std::input_iterator_tag;
    using value_type = SettingInfo;
    using difference_type = std::ptrdiff_t;
    using pointer = const SettingInfo*;
    using reference = SettingInfo;
    // NOLINTEND(readability-identifier-naming)

    explicit Iterator(std::size_t index) : index_{index} {}
    [[nodiscard]] SettingInfo operator*() const { return SettingTable{}[index_]; }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    [[nodiscard]] bool operator==(const Iterator& other) const = default;

   private:
    std::size_t index_;
  };

  [[nodiscard]] static std::size_t size();
  /// Returns the setting.
  /// @param index below size()
  [[nodiscard]] SettingInfo operator[](std::size_t index) const;
  [[nodiscard]] static Iterator begin() { return Iterator{0}; }
  [[nodiscard]] static Iterator end() { return Iterator{size()}; }
};

[[nodiscard]] inline SettingTable setting_table() { return {}; }
/// Returns the index of a setting in the table. If no setting has this number, returns the size of
/// the table.
[[nodiscard]] std::size_t setting_index(std::uint16_t number);
/// Returns the setting; nothing if no setting has this number.
[[nodiscard]] std::optional<SettingInfo> find_setting(std::uint16_t number);
/// Returns the groups in the order of SettingGroup, from 1 on.
[[nodiscard]] std::span<const SettingGroupInfo> setting_groups();

/// The values of all settings.
class Settings {
 public:
  static constexpr std::size_t kMaxSettings = 128;

  Settings();

  /// Returns the stored value.
  /// @pre the number is in the table
  [[nodiscard]] float get(std::uint16_t number) const;
  /// Returns the value of a setting that exists for each axis, such as $100 + axis.
  [[nodiscard]] float get(std::uint16_t first_number, std::size_t axis) const {
    return get(static_cast<std::uint16_t>(first_number + axis));
  }
  /// Sets a value and returns the stored value. A refused value changes nothing.
  Result<float, SettingError> set(std::uint16_t number, float value);
  /// Returns a number that changes with each change of the settings. Code that keeps values derived
  /// from settings compares it to find out whether they are out of date.
  [[nodiscard]] std::uint32_t revision() const { return revision_; }
  /// Returns whether the values are still those that were set. Returns false once a bit of a value
  /// has flipped in memory, also if other values were set since.
  [[nodiscard]] bool sound() const;

 private:
  std::array<float, kMaxSettings> values_{};
  std::uint32_t sum_ = 0;  ///< Checksum of the values' bits, updated by each set().
  std::uint32_t revision_ = 1;
};

namespace setting {
inline constexpr std::uint16_t kStepPulse = 0;
inline constexpr std::uint16_t kIdleDelay = 1;
inline constexpr std::uint16_t kStepInvert = 2;
inline constexpr std::uint16_t kDirectionInvert = 3;
inline constexpr std::uint16_t kEnableInvert = 4;
inline constexpr std::uint16_t kLimitInvert = 5;
inline constexpr std::uint16_t kProbeInvert = 6;
inline constexpr std::uint16_t kStatusReport = 10;
inline constexpr std::uint16_t kJunctionDeviation = 11;
inline constexpr std::uint16_t kArcTolerance = 12;
inline constexpr std::uint16_t kReportInches = 13;
inline constexpr std::uint16_t kControlInvert = 14;
inline constexpr std::uint16_t kCoolantInvert = 15;
inline constexpr std::uint16_t kSpindleInvert = 16;
inline constexpr std::uint16_t kSoftLimits = 20;
inline constexpr std::uint16_t kHardLimits = 21;
inline constexpr std::uint16_t kHoming = 22;
inline constexpr std::uint16_t kHomingDirectionInvert = 23;
inline constexpr std::uint16_t kHomingLocateRate = 24;
inline constexpr std::uint16_t kHomingSeekRate = 25;
inline constexpr std::uint16_t kHomingDebounce = 26;
inline constexpr std::uint16_t kHomingPullOff = 27;
inline constexpr std::uint16_t kDirectionSetUp = 29;
inline constexpr std::uint16_t kMaxSpindleSpeed = 30;
inline constexpr std::uint16_t kMinSpindleSpeed = 31;
inline constexpr std::uint16_t kLaserMode = 32;
inline constexpr std::uint16_t kKeptMotors = 37;
inline constexpr std::uint16_t kJogLimited = 40;
inline constexpr std::uint16_t kParking = 41;
inline constexpr std::uint16_t kParkingAxis = 42;
inline constexpr std::uint16_t kHomingPasses = 43;
inline constexpr std::uint16_t kHomingPassAxes = 44;
inline constexpr std::uint16_t kParkingPullOut = 56;
inline constexpr std::uint16_t kParkingPullOutRate = 57;
inline constexpr std::uint16_t kParkingTarget = 58;
inline constexpr std::uint16_t kParkingRate = 59;
inline constexpr std::uint16_t kStepsPerMm = 100;
inline constexpr std::uint16_t kRate = 110;
inline constexpr std::uint16_t kAcceleration = 120;
inline constexpr std::uint16_t kTravel = 130;
inline constexpr std::uint16_t kBacklash = 160;
inline constexpr std::uint16_t kToolChange = 341;
inline constexpr std::uint16_t kSpindleRestoreDelay = 392;
inline constexpr std::uint16_t kCoolantRestoreDelay = 393;
inline constexpr std::uint16_t kSpindleOnDelay = 394;
inline constexpr std::uint16_t kReportInterval = 481;
inline constexpr std::uint16_t kJerk = 800;
inline constexpr std::uint16_t kShaper = 810;
inline constexpr std::uint16_t kShaperFrequency = 820;
inline constexpr std::uint16_t kShaperDamping = 830;
inline constexpr std::uint16_t kArcRepairMm = 850;
inline constexpr std::uint16_t kArcRepairPercent = 851;
inline constexpr std::uint16_t kSquaredAxes = 852;
inline constexpr std::uint16_t kReportedAxes = 853;
inline constexpr std::uint16_t kMinBeamPower = 854;
inline constexpr std::uint16_t kBeamOnDelay = 855;
inline constexpr std::uint16_t kBeamOffDelay = 856;
inline constexpr std::uint16_t kBeamLag = 857;
inline constexpr std::uint16_t kLinkWatchdog = 858;
inline constexpr std::uint16_t kCanNode = 859;
inline constexpr std::uint16_t kKerfControl = 860;
inline constexpr std::uint16_t kRestLightDuty = 870;
inline constexpr std::uint16_t kRestLightTime = 871;
inline constexpr std::uint16_t kEnableDelay = 884;
inline constexpr std::uint16_t kBlockDelete = 890;
inline constexpr std::uint16_t kRotaryAxes = 900;
inline constexpr std::uint16_t kRotaryReversed = 901;
inline constexpr std::uint16_t kTiltPoint = 910;
inline constexpr std::uint16_t kTurnPoint = 913;
inline constexpr std::uint16_t kMinTilt = 916;
inline constexpr std::uint16_t kMaxTilt = 917;
}  // namespace setting

}  // namespace cnc
