#include "planner/motion/segment/power_course.hpp"

#include <algorithm>

namespace cnc::motion {
namespace {

constexpr float kToQ8 = 256.0F;

}  // namespace

PowerCourse power_course(float from, float to, std::uint32_t ticks) {
  PowerCourse course;
  course.first = static_cast<std::uint16_t>(from * kFullOutput + 0.5F);
  if (from == to) return course;
  const std::uint32_t longest = PowerCourse::kLongestInterval;
  const std::uint32_t stairs = std::max<std::uint32_t>(1, (ticks + longest - 1) / longest);
  const float growth = (to - from) * kFullOutput / static_cast<float>(stairs);
  course.first = static_cast<std::uint16_t>(from * kFullOutput + 0.5F * growth + 0.5F);
  if (stairs == 1) return course;
  course.interval = static_cast<std::uint16_t>((ticks + stairs - 1) / stairs);
  course.growth_q8 = static_cast<std::int32_t>(growth * kToQ8);
  return course;
}

}  // namespace cnc::motion
