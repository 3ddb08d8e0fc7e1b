#include "host-sim/job/travel_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "firmware/machine/travel.hpp"
#include "host-sim/job/standpoint.hpp"
#include "host-sim/measure/program_line.hpp"

namespace sim {
namespace {

/// Excess over the travel that is allowed, mm. It allows for rounded decimals in a job that is as
/// large as the travel.
constexpr double kSlackMm = 1.0e-6;

/// Distance by which the controller lets a rounded circle exceed the ends of a homed axis.
constexpr double kSlackOfEndsMm = 1.0e-3;

const char* unit_of(std::size_t axis) { return axis < cnc::kLinearAxisCount ? "mm" : "degrees"; }

std::string_view line_of(std::string_view text, int number) {
  std::string_view line;
  for (; number > 0 && !text.empty(); --number) line = take_line(text);
  return line;
}

std::size_t column_of(std::string_view line, char letter) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (std::toupper(static_cast<unsigned char>(line[i])) == letter) return i + 1;
  }
  return 0;
}

}  // namespace

TravelCheck::TravelCheck(const cnc::Settings& settings, std::uint8_t homed, const Point& start)
    : bounds_{start, start} {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    axes_[axis].homed = (homed >> axis & 1U) != 0;
    axes_[axis].low = axes_[axis].high = start[axis];
  }
  configure(settings);
}

void TravelCheck::configure(const cnc::Settings& settings) {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const cnc::AxisTravel ends = cnc::travel_of(settings, axis);
    axes_[axis].travel = static_cast<double>(settings.get(cnc::setting::kTravel, axis));
    axes_[axis].least = in_double(ends.least);
    axes_[axis].most = in_double(ends.most);
  }
}

void TravelCheck::home(std::uint8_t axes, const Point& at) {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    if ((axes >> axis & 1U) == 0) continue;
    axes_[axis].homed = true;
    axes_[axis].low = axes_[axis].high = at[axis];
  }
}

void TravelCheck::put(const PathPiece& piece) {
  const Bounds one = piece.curve.bounds();
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    bounds_.low[axis] = std::min(bounds_.low[axis], one.low[axis]);
    bounds_.high[axis] = std::max(bounds_.high[axis], one.high[axis]);
    axes_[axis].low = std::min(axes_[axis].low, one.low[axis]);
    axes_[axis].high = std::max(axes_[axis].high, one.high[axis]);
    check(axis, piece.line);
  }
}

/// Checks one axis after a piece. An overrun is stored with the farthest position and the line at
/// which the axis first went too far.
void TravelCheck::check(std::size_t number, int line) {
  Axis& axis = axes_[number];
  if (axis.travel <= 0.0) return;
  const bool below = axis.low < axis.least - kSlackOfEndsMm;
  const bool above = axis.high > axis.most + kSlackOfEndsMm;
  const bool too_far = axis.homed ? below || above : axis.high - axis.low > axis.travel + kSlackMm;
  if (!too_far) return;
  if (axis.overrun.line == 0) axis.overrun.line = line;
  axis.overrun.of_ends = axis.homed;
  axis.overrun.value = !axis.homed ? axis.high - axis.low : below ? axis.low : axis.high;
  axis.overrun.least = axis.least;
  axis.overrun.most = axis.homed ? axis.most : axis.travel;
}

std::string TravelCheck::text_of(std::size_t axis) const {
  const Overrun& overrun = axes_[axis].overrun;
  if (overrun.of_ends) {
    return fmt::format(
        "{} goes to {:.3f} {} in machine coordinates, the travel is {:.3f} to {:.3f}",
        cnc::kAxisLetters[axis],
        overrun.value,
        unit_of(axis),
        overrun.least,
        overrun.most);
  }
  return fmt::format("{} needs {:.3f} {} of travel, ${} allows {:g}",
                     cnc::kAxisLetters[axis],
                     overrun.value,
                     unit_of(axis),
                     cnc::setting::kTravel + axis,
                     overrun.most);
}

std::vector<Fault> TravelCheck::faults(const std::string& file, std::string_view text) const {
  std::vector<Fault> faults;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const int number = axes_[axis].overrun.line;
    if (number == 0) continue;
    faults.push_back({.file = file,
                      .line = static_cast<std::size_t>(number),
                      .column = column_of(line_of(text, number), cnc::kAxisLetters[axis]),
                      .number = kTravelExceeded,
                      .message = text_of(axis)});
  }
  return faults;
}

std::uint8_t homed_by_cycle(const cnc::Settings& settings) {
  unsigned axes = 0;
  for (std::size_t pass = 0; pass < cnc::kAxisCount; ++pass) {
    axes |= static_cast<unsigned>(settings.get(cnc::setting::kHomingPassAxes, pass));
  }
  return static_cast<std::uint8_t>(axes);
}

double homed_position(const cnc::Settings& settings, std::size_t axis) {
  if (cnc::has_homing_option(settings, cnc::homing_option::kSetOrigin)) return 0.0;
  const auto mask = static_cast<unsigned>(settings.get(cnc::setting::kHomingDirectionInvert));
  const auto pull_off = static_cast<double>(settings.get(cnc::setting::kHomingPullOff));
  const cnc::AxisTravel ends = cnc::travel_of(settings, axis);
  return (mask >> axis & 1U) != 0 ? in_double(ends.least) + pull_off
                                  : in_double(ends.most) - pull_off;
}

}  // namespace sim
