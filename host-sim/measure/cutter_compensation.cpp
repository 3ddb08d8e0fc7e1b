#include "host-sim/measure/cutter_compensation.hpp"

#include <algorithm>

namespace sim {
namespace {

constexpr int kOff = 400;
constexpr int kLeft = 410;
constexpr int kLeftByWidth = 411;
constexpr int kRight = 420;
constexpr int kRightByWidth = 421;

}  // namespace

bool CutterCompensation::knows_g(int g) {
  return g == kLeft || g == kLeftByWidth || g == kRight || g == kRightByWidth;
}

double CutterCompensation::radius_of(double tool) const {
  const bool listed = tool >= 1.0 && tool <= static_cast<double>(kTools);
  return listed ? radii_[static_cast<std::size_t>(tool)] : 0.0;
}

std::optional<double> CutterCompensation::width_of(const ProgramLine& line,
                                                   bool by_word,
                                                   double scale) const {
  if (by_word) return line.value('D').value_or(0.0) * scale;
  if (by_kerf_) return width_ ? width_(condition_) : std::nullopt;
  const double tool = line.value('D').value_or(0.0);
  return 2.0 * radius_of(tool == 0.0 ? tool_ : tool);
}

std::string CutterCompensation::apply(const ProgramLine& line,
                                      double scale,
                                      double spindle_speed,
                                      double feed_mm_min) {
  const auto has_m = [&line](int m) { return std::ranges::find(line.m, m) != line.m.end(); };
  if (has_m(6)) tool_ = line.value('T').value_or(tool_);
  if (has_m(190)) {
    condition_.table = static_cast<int>(line.value('P').value_or(0.0));
    condition_.thickness_mm = line.value('Q').value_or(0.0) * scale;
  }
  if (line.has_g(kOff)) offset_mm_ = 0.0;
  const bool left = line.has_g(kLeft) || line.has_g(kLeftByWidth);
  if (!left && !line.has_g(kRight) && !line.has_g(kRightByWidth)) return {};
  const bool by_word = line.has_g(kLeftByWidth) || line.has_g(kRightByWidth);
  by_kerf_ = laser_ && !by_word && !line.value('D');
  condition_.spindle_speed = spindle_speed;
  condition_.feed_mm_min = feed_mm_min;
  const std::optional<double> width = width_of(line, by_word, scale);
  offset_mm_ = (left ? -0.5 : 0.5) * width.value_or(0.0);
  if (!width) return "the kerf is not known here; G41 and G42 are left out";
  return *width > 0.0 ? std::string{} : "D is 0: G41 and G42 do not offset the programmed path";
}

bool CutterCompensation::set_tool(const ProgramLine& line, double scale) {
  const double tool = line.value('P').value_or(0.0);
  if (line.value('L').value_or(0.0) != 1.0) return false;
  const bool listed = tool >= 1.0 && tool <= static_cast<double>(kTools);
  if (listed && line.value('R')) radii_[static_cast<std::size_t>(tool)] = *line.value('R') * scale;
  return true;
}

void CutterCompensation::end_program() { offset_mm_ = 0.0; }

}  // namespace sim
