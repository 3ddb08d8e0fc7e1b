#include "host-sim/measure/modal_state.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/units.hpp"

namespace sim {
namespace {

/// Returns whether a G number sets units, feed mode or path control, which apply_modes() applies
/// before its loop, or is G40, which CutterCompensation applies.
bool is_applied_before(int g) {
  constexpr std::array kNumbers{200, 210, 930, 940, 400, 610, 611, 640};
  return std::ranges::find(kNumbers, g) != kNumbers.end();
}

bool is_motion(int g) {
  return g == 0 || g == 10 || g == 20 || g == 30 || (g >= 50 && g <= 53) || (g >= 382 && g <= 385);
}

}  // namespace

double ModalState::scaled(std::size_t axis, double value) const {
  return inches_ && axis < cnc::kLinearAxisCount ? value * kMillimetresPerInch : value;
}

double ModalState::offset(std::size_t axis) const {
  return systems_[system_][axis] + shift_[axis] + tool_[axis];
}

std::vector<int> ModalState::apply_modes(const ProgramLine& line) {
  // The units come first, because they apply to every other number of the line.
  if (line.has_g(200)) inches_ = true;
  if (line.has_g(210)) inches_ = false;
  if (line.has_g(930)) inverse_time_ = true;
  if (line.has_g(940)) inverse_time_ = false;
  apply_feed(line);
  apply_path_control(line);
  std::vector<int> left;
  for (const int g : line.g) {
    const bool done = is_applied_before(g) || apply_plane(g) || apply_distance(g) ||
                      apply_tool_offset(g, line) || apply_coordinate_system(g) ||
                      apply_motion(g, line);
    if (!done) left.push_back(g);
  }
  return left;
}

void ModalState::apply_feed(const ProgramLine& line) {
  if (const auto f = line.value('F')) {
    feed_word_ = *f;
    feed_in_inches_ = inches_;
  }
}

void ModalState::apply_path_control(const ProgramLine& line) {
  const bool blends = line.has_g(640);
  if (!blends && !line.has_g(610) && !line.has_g(611)) return;
  const auto length = [&](char letter) {
    const auto word = line.value(letter);
    return blends && word ? std::optional{scaled(0, *word)} : std::nullopt;
  };
  stops_at_corners_ = line.has_g(611);
  corner_word_ = length('P');
  weld_word_ = length('Q');
}

ProgramTolerance ModalState::tolerance(double usual, double arc) const {
  if (stops_at_corners_) return {};
  if (!corner_word_ && !weld_word_) {
    const double weld = std::min(arc, usual / 2.0);
    return {.corner = usual - weld, .weld = weld};
  }
  return {.corner = corner_word_.value_or(usual),
          .weld = weld_word_.value_or(corner_word_.value_or(0.0))};
}

double ModalState::spline_tolerance(double arc) const {
  const double naive = weld_word_.value_or(0.0);
  return naive > 0.0 ? naive : arc;
}

bool ModalState::apply_plane(int g) {
  constexpr std::array<cnc::Plane, 3> kPlanes{cnc::Plane::kXY, cnc::Plane::kZX, cnc::Plane::kYZ};
  if (g != 170 && g != 180 && g != 190) return false;
  plane_ = kPlanes[static_cast<std::size_t>(g / 10 - 17)];
  return true;
}

bool ModalState::apply_distance(int g) {
  if (g != 900 && g != 910 && g != 901 && g != 911) return false;
  if (g == 900 || g == 910) incremental_ = g == 910;
  if (g == 901 || g == 911) absolute_centre_ = g == 901;
  return true;
}

bool ModalState::apply_tool_offset(int g, const ProgramLine& line) {
  if (g != 431 && g != 434 && g != 490) return false;
  if (g == 490) tool_ = {};
  for (std::size_t i = 0; i < cnc::kAxisCount && g != 490; ++i) {
    if (const auto word = line.value(cnc::kAxisLetters[i])) tool_[i] = scaled(i, *word);
  }
  return true;
}

bool ModalState::apply_motion(int g, const ProgramLine& line) {
  constexpr std::array kStraight{
      Motion::kRapid, Motion::kLine, Motion::kClockwise, Motion::kCounterClockwise};
  if (g == 0 || g == 10 || g == 20 || g == 30) {
    motion_ = kStraight[static_cast<std::size_t>(g / 10)];
  } else if (g >= 50 && g <= 53) {
    constexpr std::array kSplines{
        Motion::kCubic, Motion::kQuadratic, Motion::kNurbs, Motion::kNurbsEnd};
    motion_ = kSplines[static_cast<std::size_t>(g - 50)];
  } else if (g >= 382 && g <= 385) {
    motion_ = Motion::kProbe;
  } else if (g == 800) {
    // On a line with a motion, G80 only ends canned cycles.
    const bool beside = std::ranges::any_of(line.g, is_motion);
    if (!beside) motion_ = Motion::kNone;
  } else {
    return false;
  }
  return true;
}

bool ModalState::apply_coordinate_system(int g) {
  if (g >= 540 && g <= 590 && g % 10 == 0) {
    system_ = static_cast<std::size_t>(g - 540) / 10;
  } else if (g >= 591 && g <= 593) {
    system_ = static_cast<std::size_t>(g - 591) + 6;
  } else {
    return false;
  }
  return true;
}

void ModalState::end_program() {
  motion_ = Motion::kLine;
  plane_ = cnc::Plane::kXY;
  incremental_ = false;
  inverse_time_ = false;
  system_ = 0;
}

Point ModalState::target(const ProgramLine& line, const Point& position) const {
  const bool machine = line.has_g(530);
  Point place = position;
  for (std::size_t i = 0; i < cnc::kAxisCount; ++i) {
    const auto word = line.value(cnc::kAxisLetters[i]);
    if (!word) continue;
    const double origin = machine ? 0.0 : incremental_ ? position[i] : offset(i);
    place[i] = origin + scaled(i, *word);
  }
  return place;
}

std::optional<std::array<double, 2>> ModalState::centre(const ProgramLine& line,
                                                        const Point& position) const {
  constexpr std::array<char, 3> kLetters{'I', 'J', 'K'};
  const auto axes = cnc::axes_of(plane_);
  const std::array<std::size_t, 2> round{axes.first, axes.second};
  std::array<double, 2> centre{};
  bool any = false;
  for (std::size_t i = 0; i < round.size(); ++i) {
    const auto word = line.value(kLetters[round[i]]);
    any = any || word;
    const double origin = absolute_centre_ ? offset(round[i]) : position[round[i]];
    centre[i] = origin + scaled(round[i], word.value_or(0.0));
  }
  return any ? std::optional{centre} : std::nullopt;
}

double ModalState::feed(double linear_length, double rotary_length) const {
  const bool linear = linear_length > 0.0;
  if (inverse_time_)
    return (linear ? linear_length : rotary_length) * feed_word_ / cnc::kSecondsPerMinute;
  const double unit = linear && feed_in_inches_ ? kMillimetresPerInch : 1.0;
  return feed_word_ * unit / cnc::kSecondsPerMinute;
}

bool ModalState::set_coordinate_system(const ProgramLine& line, const Point& position) {
  const long table = std::lround(line.value('L').value_or(0.0));
  const auto number = static_cast<std::size_t>(std::lround(line.value('P').value_or(0.0)));
  if ((table != 2 && table != 20) || number > kSystems) return false;
  Point& origin = systems_[number == 0 ? system_ : number - 1];
  for (std::size_t i = 0; i < cnc::kAxisCount; ++i) {
    const auto word = line.value(cnc::kAxisLetters[i]);
    if (!word) continue;
    origin[i] =
        table == 20 ? position[i] - shift_[i] - tool_[i] - scaled(i, *word) : scaled(i, *word);
  }
  return true;
}

void ModalState::set_shift(const ProgramLine& line, const Point& position) {
  for (std::size_t i = 0; i < cnc::kAxisCount; ++i) {
    const auto word = line.value(cnc::kAxisLetters[i]);
    if (word) shift_[i] = position[i] - systems_[system_][i] - tool_[i] - scaled(i, *word);
  }
  saved_shift_ = shift_;
}

}  // namespace sim
