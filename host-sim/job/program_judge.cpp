#include "host-sim/job/program_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host-sim/measure/program_line.hpp"

namespace sim {
namespace {

/// Grbl's error number for a target that cannot be reached.
constexpr int kTargetNotDriven = 33;

/// Returns whether a fault depends on the kerf tables, which only the controller has.
bool depends_on_kerf_tables(cnc::gcode::FaultDetail detail) {
  using enum cnc::gcode::FaultDetail;
  constexpr std::array kOfTables{kNoSuchMaterial,
                                 kMaterialMissing,
                                 kKerfNeedsWatts,
                                 kNotThisThickness,
                                 kNotThisPower,
                                 kNotThisSpeed,
                                 kNoSpeedAtAll};
  return std::ranges::find(kOfTables, detail) != kOfTables.end();
}

std::string reason_in_words(const cnc::gcode::Fault& fault) {
  constexpr std::size_t kLongestReason = 160;
  std::array<char, kLongestReason> words{};
  return {words.data(), cnc::gcode::describe(fault, words)};
}

bool begins_statement(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '$';
}

cnc::Position position_of(const Point& point) {
  constexpr double kNanometresPerMillimetre = 1.0e6;
  cnc::Position position{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    position[axis] = cnc::Coordinate{std::llround(point[axis] * kNanometresPerMillimetre)};
  }
  return position;
}

}  // namespace

std::vector<std::string> Judgement::texts() const {
  std::vector<std::string> texts;
  for (const bool of_travel : {true, false}) {
    for (const Fault& fault : faults) {
      if ((fault.number == kTravelExceeded) != of_travel) continue;
      texts.push_back(fmt::format("line {}: {}", fault.line, fault.message));
    }
  }
  if (more > 0) {
    texts.push_back(
        fmt::format("and {} more line{} refused", more, more == 1 ? " that is" : "s that are"));
  }
  return texts;
}

ProgramJudge::ProgramJudge(const Standpoint& standpoint)
    : reader_{standpoint.reader}, path_{standpoint, [](const PathPiece&) {}} {}

void ProgramJudge::take(std::size_t line, std::string_view text) {
  if (begins_statement(text)) {
    path_.take(line, text);
    if (path_.homed_now()) reader_.set_position(position_of(path_.position()));
    return;
  }
  const auto actions = reader_.interpret(text);
  if (!actions.ok() && !depends_on_kerf_tables(actions.error().detail)) {
    return refuse(line, actions.error());
  }
  path_.take(line, text);
}

void ProgramJudge::refuse(std::size_t line, const cnc::gcode::Fault& fault) {
  if (judgement_.faults.size() == kMaxRefused) {
    ++judgement_.more;
    return;
  }
  judgement_.faults.push_back({.file = {},
                               .line = line,
                               .column = fault.column,
                               .number = static_cast<int>(fault.code()),
                               .message = reason_in_words(fault)});
}

Judgement ProgramJudge::end(const std::string& file, std::string_view program) {
  path_.end();
  for (Fault& overrun : path_.travel().faults(file, program)) {
    judgement_.faults.push_back(std::move(overrun));
  }
  if (const auto& beside = path_.refused(); beside && beside->line > 0) {
    std::string words = "the compensated path of this motion (G41, G42) cannot be driven";
    if (beside->other_line > 0) words += fmt::format(", because of line {}", beside->other_line);
    judgement_.faults.push_back({.file = {},
                                 .line = static_cast<std::size_t>(beside->line),
                                 .column = 0,
                                 .number = kTargetNotDriven,
                                 .message = std::move(words)});
  }
  for (Fault& fault : judgement_.faults) fault.file = file;
  std::ranges::stable_sort(judgement_.faults, {}, &Fault::line);
  return std::move(judgement_);
}

Judgement judge_program(const std::string& file,
                        std::string_view program,
                        const Standpoint& standpoint,
                        const std::atomic<bool>* cancelled) {
  ProgramJudge judge{standpoint};
  std::string_view rest = program;
  for (std::size_t line = 1; !rest.empty(); ++line) {
    if (cancelled != nullptr && *cancelled) break;
    judge.take(line, take_line(rest));
  }
  return judge.end(file, program);
}

}  // namespace sim
