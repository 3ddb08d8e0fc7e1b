#include "planner/kerf/kerf_course.hpp"

#include <algorithm>

namespace cnc::kerf {

std::optional<Refusal> KerfCourse::begin(const TableView<float>& table,
                                         const Condition& condition) {
  constexpr float kMmPerSecond = 1.0F / 60'000.0F;  // Factor from µm/min to mm/s.
  *this = {};
  const auto speed = static_cast<float>(condition.speed_um_min);
  speed_mm_s_ = speed * kMmPerSecond;
  const auto programmed = kerf_width(table, condition);
  if (!programmed.ok()) return programmed.error();
  const auto speeds = permissible_speeds(table, condition.thickness_um, condition.power_mw);
  if (!speeds.ok()) return speeds.error();
  const float coldest = speed / static_cast<float>(speeds.value().most);
  const float hottest = speed / static_cast<float>(speeds.value().least);
  if (!(hottest > coldest)) return std::nullopt;
  constexpr auto kStretches = static_cast<float>(kPoints - 1);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const float heat = coldest + (hottest - coldest) * (static_cast<float>(i) / kStretches);
    Condition there = condition;
    there.speed_um_min = std::clamp(
        static_cast<std::uint32_t>(speed / heat + 0.5F), speeds.value().least, speeds.value().most);
    const auto width = kerf_width(table, there);
    if (!width.ok()) return width.error();
    aside_mm_[i] = 0.5F * (width.value() - programmed.value());
  }
  coldest_ = coldest;
  points_per_heat_ = kStretches / (hottest - coldest);
  return std::nullopt;
}

float KerfCourse::aside_mm(float heat) const {
  constexpr auto kLast = static_cast<float>(kPoints - 1);
  const float place = std::clamp((heat - coldest_) * points_per_heat_, 0.0F, kLast);
  const auto low = std::min(static_cast<std::size_t>(place), kPoints - 2);
  const float share = place - static_cast<float>(low);
  return aside_mm_[low] + share * (aside_mm_[low + 1] - aside_mm_[low]);
}

}  // namespace cnc::kerf
