#include "host-sim/job/travel_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace sim {
namespace {

/// Grbl's number for a target beyond the travel.
constexpr int kTravelExceeded = 15;

/// A job as large as the travel may exceed it by the rounding of its decimals.
constexpr double kSlackMm = 1.0e-6;

std::string line_of(const std::string& text, int number) {
  std::size_t start = 0;
  for (int line = 1; line < number; ++line) {
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) return {};
    start = end + 1;
  }
  return text.substr(start, text.find('\n', start) - start);
}

std::size_t column_of(const std::string& line, char letter) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (std::toupper(static_cast<unsigned char>(line[i])) == letter) return i + 1;
  }
  return 0;
}

struct Overrun {
  int line;
  double extent_mm;  ///< Of the whole program.
};

std::optional<Overrun> find_overrun(const ProgrammedPath& path, std::size_t axis, double travel) {
  double low = path.start[axis];
  double high = low;
  std::optional<Overrun> overrun;
  for (const PathPiece& piece : path.pieces) {
    const auto bounds = piece.curve.bounds();
    low = std::min(low, bounds.low[axis]);
    high = std::max(high, bounds.high[axis]);
    if (high - low <= travel + kSlackMm) continue;
    if (!overrun) overrun = Overrun{piece.line, 0.0};
    overrun->extent_mm = high - low;
  }
  return overrun;
}

}  // namespace

std::vector<Fault> check_travel(const ProgrammedPath& path,
                                const cnc::Settings& settings,
                                const std::string& file,
                                const std::string& text) {
  std::vector<Fault> faults;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const double travel = settings.get(cnc::setting::kTravel, axis);
    if (travel <= 0.0) continue;
    const auto overrun = find_overrun(path, axis, travel);
    if (!overrun) continue;
    const char letter = cnc::kAxisLetters[axis];
    faults.push_back({.file = file,
                      .line = static_cast<std::size_t>(overrun->line),
                      .column = column_of(line_of(text, overrun->line), letter),
                      .number = kTravelExceeded,
                      .message = fmt::format("{} needs {:.3f} {} of travel, ${} allows {:g}",
                                             letter,
                                             overrun->extent_mm,
                                             axis < cnc::kLinearAxisCount ? "mm" : "degrees",
                                             cnc::setting::kTravel + axis,
                                             travel)});
  }
  return faults;
}

}  // namespace sim
