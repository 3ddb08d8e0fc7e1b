#include "firmware/machine/settings.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "planner/base/contract.hpp"

namespace cnc {
namespace {

std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }

}  // namespace

std::optional<SettingInfo> find_setting(std::uint16_t number) {
  const std::size_t index = setting_index(number);
  if (index == setting_table().size()) return std::nullopt;
  return setting_table()[index];
}

Settings::Settings() {
  std::size_t index = 0;
  for (const SettingInfo& info : setting_table()) {
    values_[index++] = info.standard;
    sum_ += bits_of(info.standard);
  }
}

bool Settings::sound() const {
  const auto add = [](std::uint32_t sum, float value) { return sum + bits_of(value); };
  return std::accumulate(values_.begin(), values_.end(), std::uint32_t{0}, add) == sum_;
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
      return "at this resolution the present position would be out of range";
    case SettingError::kInUse:
      return "G43.4 uses this setting: end it by G49";
  }
  return {};
}

float Settings::get(std::uint16_t number) const {
  const std::size_t index = setting_index(number);
  CNC_ASSERT(index < setting_table().size());
  return values_[index];
}

Result<float, SettingError> Settings::set(std::uint16_t number, float value) {
  const std::size_t index = setting_index(number);
  if (index == setting_table().size()) return SettingError::kUnknown;
  const SettingInfo& info = setting_table()[index];
  if (!(value >= info.least)) return SettingError::kBelowRange;
  if (value > info.most) return SettingError::kAboveRange;
  if (info.is_whole() && value != std::floor(value)) return SettingError::kNotWhole;
  sum_ += bits_of(value) - bits_of(values_[index]);
  values_[index] = value;
  ++revision_;
  return value;
}

}  // namespace cnc
