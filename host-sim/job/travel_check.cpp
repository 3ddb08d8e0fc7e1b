#include "host-sim/job/travel_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "host-sim/measure/program_line.hpp"

namespace sim {
namespace {

/// Grbl's number for a target beyond the travel.
constexpr int kTravelExceeded = 15;

/// A job as large as the travel may exceed it by the rounding of its decimals.
constexpr double kSlackMm = 1.0e-6;

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

TravelCheck::TravelCheck(const cnc::Settings& settings) {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    travel_[axis] = static_cast<double>(settings.get(cnc::setting::kTravel, axis));
  }
}

void TravelCheck::put(const PathPiece& piece) {
  const Bounds one = piece.curve.bounds();
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    bounds_.low[axis] = std::min(bounds_.low[axis], one.low[axis]);
    bounds_.high[axis] = std::max(bounds_.high[axis], one.high[axis]);
    const double extent = bounds_.high[axis] - bounds_.low[axis];
    const bool beyond = travel_[axis] > 0.0 && extent > travel_[axis] + kSlackMm;
    if (beyond && first_overrun_[axis] == 0) first_overrun_[axis] = piece.line;
  }
}

std::vector<Fault> TravelCheck::faults(const std::string& file, std::string_view text) const {
  std::vector<Fault> faults;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const int line = first_overrun_[axis];
    if (line == 0) continue;
    const char letter = cnc::kAxisLetters[axis];
    faults.push_back({.file = file,
                      .line = static_cast<std::size_t>(line),
                      .column = column_of(line_of(text, line), letter),
                      .number = kTravelExceeded,
                      .message = fmt::format("{} needs {:.3f} {} of travel, ${} allows {:g}",
                                             letter,
                                             bounds_.high[axis] - bounds_.low[axis],
                                             axis < cnc::kLinearAxisCount ? "mm" : "degrees",
                                             cnc::setting::kTravel + axis,
                                             travel_[axis])});
  }
  return faults;
}

}  // namespace sim
