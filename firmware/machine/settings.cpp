#include "firmware/machine/settings.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"

namespace cnc {
namespace {

constexpr float kLeastRate = 1.0F;           // mm/min
constexpr float kMostRate = 1.0e6F;          // mm/min
constexpr float kMostAcceleration = 1.0e6F;  // mm/s²
constexpr float kMostTravel = 1.0e6F;        // mm

// clang-format off
// The size is spelled out: deduced, GCC 12 puts the table into RAM.
constexpr std::array<SettingInfo, 77> kTable{{
    SettingInfo{0, "Step pulse time", "microseconds", 1.0F, 12.0F, 5.0F, false},
    SettingInfo{1, "Step idle delay", "milliseconds", 0.0F, 65535.0F, 25.0F, true},
    SettingInfo{2, "Step pulse invert", "mask", 0.0F, 63.0F, 0.0F, true},
    SettingInfo{3, "Step direction invert", "mask", 0.0F, 63.0F, 0.0F, true},
    SettingInfo{4, "Invert step enable pin", "mask", 0.0F, 63.0F, 0.0F, true},
    SettingInfo{5, "Invert limit pins", "mask", 0.0F, 63.0F, 0.0F, true},
    SettingInfo{6, "Invert probe pin", "0 or 1", 0.0F, 1.0F, 0.0F, true},
    SettingInfo{10, "Status report options", "mask", 0.0F, 511.0F, 3.0F, true},
    SettingInfo{11, "Junction deviation", "mm", 0.0F, 10.0F, 0.01F, false},
    SettingInfo{12, "Arc tolerance", "mm", 0.0F, 1.0F, 0.002F, false},
    SettingInfo{13, "Report in inches", "0 or 1", 0.0F, 1.0F, 0.0F, true},
    SettingInfo{14, "Invert control pins", "mask", 0.0F, 31.0F, 0.0F, true},
    SettingInfo{15, "Invert coolant pins", "mask", 0.0F, 3.0F, 0.0F, true},
    SettingInfo{16, "Invert spindle pins", "mask", 0.0F, 7.0F, 0.0F, true},
    SettingInfo{20, "Soft limits", "0 or 1", 0.0F, 1.0F, 0.0F, true},
    SettingInfo{21, "Hard limits", "0 or 1", 0.0F, 1.0F, 0.0F, true},
    SettingInfo{22, "Homing cycle", "mask", 0.0F, 255.0F, 0.0F, true},
    SettingInfo{23, "Homing direction invert", "mask", 0.0F, 63.0F, 0.0F, true},
    SettingInfo{24, "Homing locate feed rate", "mm/min", 1.0F, 100000.0F, 25.0F, false},
    SettingInfo{25, "Homing search seek rate", "mm/min", 1.0F, 100000.0F, 500.0F, false},
    SettingInfo{26, "Homing switch debounce delay", "milliseconds", 0.0F, 1000.0F, 250.0F, true},
    SettingInfo{27, "Homing switch pull-off distance", "mm", 0.0F, 1000.0F, 1.0F, false},
    SettingInfo{29, "Direction set-up time", "microseconds", 0.25F, 12.0F, 2.0F, false},
    SettingInfo{30, "Maximum spindle speed", "RPM", 1.0F, 1.0e6F, 1000.0F, false},
    SettingInfo{31, "Minimum spindle speed", "RPM", 0.0F, 1.0e6F, 0.0F, false},
    SettingInfo{32, "Laser mode", "0 or 1", 0.0F, 1.0F, 0.0F, true},
    SettingInfo{40, "Limit jogging to the travel", "0 or 1", 0.0F, 1.0F, 0.0F, true},
    SettingInfo{41, "Parking cycle", "0 or 1", 0.0F, 1.0F, 0.0F, true},
    SettingInfo{42, "Parking axis", "axis number", 0.0F, 5.0F, 2.0F, true},
    SettingInfo{43, "Homing locate passes", "passes", 1.0F, 128.0F, 1.0F, true},
    SettingInfo{44, "Axes of homing pass 1", "mask", 0.0F, 63.0F, 4.0F, true},
    SettingInfo{45, "Axes of homing pass 2", "mask", 0.0F, 63.0F, 3.0F, true},
    SettingInfo{46, "Axes of homing pass 3", "mask", 0.0F, 63.0F, 0.0F, true},
    SettingInfo{47, "Axes of homing pass 4", "mask", 0.0F, 63.0F, 0.0F, true},
    SettingInfo{48, "Axes of homing pass 5", "mask", 0.0F, 63.0F, 0.0F, true},
    SettingInfo{49, "Axes of homing pass 6", "mask", 0.0F, 63.0F, 0.0F, true},
    SettingInfo{56, "Parking pull-out distance", "mm", 0.0F, 1000.0F, 5.0F, false},
    SettingInfo{57, "Parking pull-out rate", "mm/min", 1.0F, 100000.0F, 100.0F, false},
    SettingInfo{58, "Parking target", "mm", -100000.0F, 100000.0F, -5.0F, false},
    SettingInfo{59, "Parking fast rate", "mm/min", 1.0F, 100000.0F, 500.0F, false},
    SettingInfo{100, "X steps", "step/mm", 0.01F, 1.0e5F, 250.0F, false},
    SettingInfo{101, "Y steps", "step/mm", 0.01F, 1.0e5F, 250.0F, false},
    SettingInfo{102, "Z steps", "step/mm", 0.01F, 1.0e5F, 250.0F, false},
    SettingInfo{103, "A steps", "step/deg", 0.01F, 1.0e5F, 100.0F, false},
    SettingInfo{104, "B steps", "step/deg", 0.01F, 1.0e5F, 100.0F, false},
    SettingInfo{105, "C steps", "step/deg", 0.01F, 1.0e5F, 100.0F, false},
    SettingInfo{110, "X maximum rate", "mm/min", kLeastRate, kMostRate, 12000.0F, false},
    SettingInfo{111, "Y maximum rate", "mm/min", kLeastRate, kMostRate, 12000.0F, false},
    SettingInfo{112, "Z maximum rate", "mm/min", kLeastRate, kMostRate, 12000.0F, false},
    SettingInfo{113, "A maximum rate", "deg/min", kLeastRate, kMostRate, 12000.0F, false},
    SettingInfo{114, "B maximum rate", "deg/min", kLeastRate, kMostRate, 12000.0F, false},
    SettingInfo{115, "C maximum rate", "deg/min", kLeastRate, kMostRate, 12000.0F, false},
    SettingInfo{120, "X acceleration", "mm/s^2", 0.1F, kMostAcceleration, 500.0F, false},
    SettingInfo{121, "Y acceleration", "mm/s^2", 0.1F, kMostAcceleration, 500.0F, false},
    SettingInfo{122, "Z acceleration", "mm/s^2", 0.1F, kMostAcceleration, 500.0F, false},
    SettingInfo{123, "A acceleration", "deg/s^2", 0.1F, kMostAcceleration, 500.0F, false},
    SettingInfo{124, "B acceleration", "deg/s^2", 0.1F, kMostAcceleration, 500.0F, false},
    SettingInfo{125, "C acceleration", "deg/s^2", 0.1F, kMostAcceleration, 500.0F, false},
    SettingInfo{130, "X maximum travel", "mm", 0.0F, kMostTravel, 300.0F, false},
    SettingInfo{131, "Y maximum travel", "mm", 0.0F, kMostTravel, 300.0F, false},
    SettingInfo{132, "Z maximum travel", "mm", 0.0F, kMostTravel, 100.0F, false},
    SettingInfo{133, "A maximum travel", "deg, 0 is endless", 0.0F, kMostTravel, 0.0F, false},
    SettingInfo{134, "B maximum travel", "deg, 0 is endless", 0.0F, kMostTravel, 0.0F, false},
    SettingInfo{135, "C maximum travel", "deg, 0 is endless", 0.0F, kMostTravel, 0.0F, false},
    SettingInfo{341, "Tool change mode", "0 pauses, 1 ignores", 0.0F, 1.0F, 0.0F, true},
    SettingInfo{392, "Spindle delay when restored", "seconds", 0.0F, 60.0F, 4.0F, false},
    SettingInfo{393, "Coolant delay when restored", "seconds", 0.0F, 60.0F, 1.0F, false},
    SettingInfo{394, "Spindle on delay", "seconds", 0.0F, 60.0F, 0.0F, false},
    SettingInfo{800, "X jerk", "mm/s^3", 1.0F, 1.0e9F, 10000.0F, false},
    SettingInfo{801, "Y jerk", "mm/s^3", 1.0F, 1.0e9F, 10000.0F, false},
    SettingInfo{802, "Z jerk", "mm/s^3", 1.0F, 1.0e9F, 10000.0F, false},
    SettingInfo{803, "A jerk", "deg/s^3", 1.0F, 1.0e9F, 10000.0F, false},
    SettingInfo{804, "B jerk", "deg/s^3", 1.0F, 1.0e9F, 10000.0F, false},
    SettingInfo{805, "C jerk", "deg/s^3", 1.0F, 1.0e9F, 10000.0F, false},
    SettingInfo{850, "Arc repair, distance", "mm", 0.0F, 0.5F, 0.05F, false},
    SettingInfo{851, "Arc repair, share of radius", "percent", 0.0F, 10.0F, 1.0F, false},
    SettingInfo{852, "Axes with two motors, squared when homing", "mask", 0.0F, 7.0F, 0.0F, true},
}};
// clang-format on
static_assert(kTable.size() <= Settings::kMostSettings);
static_assert(std::is_sorted(kTable.begin(),
                             kTable.end(),
                             [](const SettingInfo& a, const SettingInfo& b) {
                               return a.number < b.number;
                             }));

/// Index in the table, or its size.
std::size_t find(std::uint16_t number) {
  const auto* found = std::lower_bound(
      kTable.begin(), kTable.end(), number, [](const SettingInfo& info, std::uint16_t wanted) {
        return info.number < wanted;
      });
  if (found == kTable.end() || found->number != number) return kTable.size();
  return static_cast<std::size_t>(found - kTable.begin());
}

}  // namespace

std::span<const SettingInfo> setting_table() { return kTable; }

Settings::Settings() {
  for (std::size_t i = 0; i < kTable.size(); ++i) values_[i] = kTable[i].standard;
}

std::string_view describe(SettingError error) {
  switch (error) {
    case SettingError::kUnknown:
      return "no such setting";
    case SettingError::kBelowRange:
      return "value is below the range of this setting";
    case SettingError::kAboveRange:
      return "value is above the range of this setting";
    case SettingError::kNotWhole:
      return "this setting takes whole numbers";
    case SettingError::kPlaceLost:
      return "at this resolution the present place would be out of reach";
  }
  return {};
}

float Settings::get(std::uint16_t number) const {
  const std::size_t index = find(number);
  CNC_ASSERT(index < kTable.size());
  return values_[index];
}

Result<float, SettingError> Settings::set(std::uint16_t number, float value) {
  const std::size_t index = find(number);
  if (index == kTable.size()) return SettingError::kUnknown;
  const SettingInfo& info = kTable[index];
  if (!(value >= info.least)) return SettingError::kBelowRange;
  if (value > info.most) return SettingError::kAboveRange;
  if (info.whole && value != std::floor(value)) return SettingError::kNotWhole;
  values_[index] = value;
  return value;
}

}  // namespace cnc
