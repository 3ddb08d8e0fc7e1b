#include "host-sim/serve/job_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "firmware/machine/travel.hpp"
#include "host-sim/measure/program_line.hpp"
#include "planner/geometry/arc_reach.hpp"

namespace sim {
namespace {

using cnc::Coordinate;
using cnc::Position;
using cnc::gcode::Action;
using cnc::gcode::ActionKind;

/// Far more than a controller takes, comments included.
constexpr std::size_t kLongestLine = 4096;

/// As much as a controller lets a rounded circle exceed its travel.
constexpr Coordinate kSlack{1000};

double in_mm(Coordinate length) {
  constexpr double kNanometre = 1.0e-6;
  return static_cast<double>(length.nanometres()) * kNanometre;
}

/// Where a program has been.
class Extent {
 public:
  explicit Extent(const Position& start) : here_{start}, box_{start, start} {}

  void follow(const Action& action) {
    switch (action.kind) {
      case ActionKind::kRapid:
      case ActionKind::kLine:
      case ActionKind::kProbe:
        add(action.end);
        break;
      case ActionKind::kArc: {
        const cnc::Box reach = cnc::reach_of({.start = here_,
                                              .end = action.end,
                                              .plane = action.plane,
                                              .centre = action.centre,
                                              .clockwise = action.clockwise,
                                              .turns = action.turns});
        add(reach.least);
        add(reach.most);
        break;
      }
      case ActionKind::kSpline:
        add(action.end);
        break;
      default:
        return;
    }
    here_ = action.end;
  }

  [[nodiscard]] const cnc::Box& box() const { return box_; }

 private:
  void add(const Position& place) {
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      box_.least[axis] = std::min(box_.least[axis], place[axis]);
      box_.most[axis] = std::max(box_.most[axis], place[axis]);
    }
  }

  Position here_;
  cnc::Box box_;
};

/// Judges the extent of a program axis by axis, each of them once.
class TravelJudge {
 public:
  TravelJudge(const cnc::Settings& settings, std::uint8_t homed)
      : settings_{settings}, homed_{homed} {}

  void judge(const cnc::Box& box, std::size_t line, std::vector<JobFault>& faults) {
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      if (told_[axis] || settings_.get(cnc::setting::kTravel, axis) <= 0.0F) continue;
      std::string words = (homed_ >> axis & 1U) != 0 ? beyond_ends(box, axis) : too_wide(box, axis);
      if (words.empty()) continue;
      told_[axis] = true;
      faults.push_back({.line = line, .message = std::move(words)});
    }
  }

 private:
  [[nodiscard]] std::string beyond_ends(const cnc::Box& box, std::size_t axis) const {
    const cnc::AxisTravel travel = cnc::travel_of(settings_, axis);
    const bool low = box.least[axis] < travel.least - kSlack;
    if (!low && box.most[axis] <= travel.most + kSlack) return {};
    return fmt::format("{} goes to {:.3f} in machine coordinates, the travel is {:.3f} to {:.3f}",
                       cnc::kAxisLetters[axis],
                       in_mm((low ? box.least : box.most)[axis]),
                       in_mm(travel.least),
                       in_mm(travel.most));
  }

  [[nodiscard]] std::string too_wide(const cnc::Box& box, std::size_t axis) const {
    const double extent = in_mm(box.most[axis] - box.least[axis]);
    const auto travel = static_cast<double>(settings_.get(cnc::setting::kTravel, axis));
    if (extent <= travel + in_mm(kSlack)) return {};
    return fmt::format("{} needs {:.3f} mm of travel, ${} allows {:g}",
                       cnc::kAxisLetters[axis],
                       extent,
                       cnc::setting::kTravel + axis,
                       travel);
  }

  const cnc::Settings& settings_;
  std::uint8_t homed_;
  std::array<bool, cnc::kAxisCount> told_{};
};

bool is_statement(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '$';
}

std::string reason_of(const cnc::gcode::Fault& fault) {
  constexpr std::size_t kLongestReason = 160;
  std::array<char, kLongestReason> words{};
  const std::size_t count = cnc::gcode::describe(fault, words);
  return {words.data(), count};
}

}  // namespace

std::string JobFault::text() const { return fmt::format("line {}: {}", line, message); }

std::vector<JobFault> job_faults(std::string_view program,
                                 cnc::gcode::Interpreter reader,
                                 const cnc::Settings& settings,
                                 std::uint8_t homed) {
  std::vector<JobFault> faults;
  Extent extent{reader.position()};
  TravelJudge travel{settings, homed};
  for (std::size_t number = 1; !program.empty() && faults.size() < kMostJobFaults; ++number) {
    const std::string_view line = take_line(program);
    if (is_statement(line)) continue;
    if (line.size() > kLongestLine) {
      faults.push_back({.line = number, .message = "the line is too long"});
      continue;
    }
    const auto actions = reader.interpret(line);
    if (!actions.ok()) {
      faults.push_back({.line = number, .message = reason_of(actions.error())});
      continue;
    }
    for (const Action& action : actions.value()) extent.follow(action);
    travel.judge(extent.box(), number, faults);
  }
  return faults;
}

}  // namespace sim
