#include "host-sim/cli/cut_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "firmware/store/kerf_tables.hpp"
#include "host-sim/contour/shared_work.hpp"
#include "host-sim/job/job.hpp"
#include "host-sim/job/program_judge.hpp"
#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/knowledge/flash_lines.hpp"
#include "host-sim/report/terminal.hpp"

namespace sim {
namespace {

using cut::CutJob;

/// A program for the simulated machine, and the statements that the machine must receive before it.
struct SimulatedProgram {
  std::string statements;  ///< Complete lines that begin with `$`.
  std::string program;
  [[nodiscard]] std::string text() const { return statements + program; }
  [[nodiscard]] std::size_t lines_before() const {
    return static_cast<std::size_t>(std::ranges::count(statements, '\n'));
  }
};

/// Returns the program for the simulated machine. If the controller offsets the path by the kerf,
/// it gets the kerf table of the material, and the full power of its beam in watts. The simulated
/// controller has no other kerf tables.
SimulatedProgram simulated(CutJob job, const CutRun& run, const std::vector<std::string>& heading) {
  SimulatedProgram simulated;
  if (job.beam.kerf_table) {
    job.beam.kerf_table = static_cast<unsigned>(cnc::KerfTables::built_in());
    simulated.statements = fmt::format("$PC=100:{:.3f}\n", job.beam.full_power_w) +
                           flash_lines(flash_image(job.record, "job"));
  }
  simulated.program = program_of(job, run, heading);
  return simulated;
}

struct EdgeVariant {
  const char* key;
  const char* name;
  bool follows_speed;
  const char* setting;
};

constexpr std::array kBesideHere{
    EdgeVariant{"m4", "power follows the speed, M4", true, "$860=0"},
    EdgeVariant{"m3", "constant power, M3", false, "$860=0"},
};
constexpr std::array kBesideOnController{
    EdgeVariant{"power_keeps_kerf", "power keeps the kerf, M4 and $860=0", true, "$860=0"},
    EdgeVariant{"path_follows_kerf", "path follows the kerf, M3 and $860=1", false, "$860=1"},
};

/// Greatest time of a job that is simulated, s; longer jobs are read line by line instead.
constexpr double kMaxSimulatedS = 3.0 * 3600.0;

ProgramCheck judge(const CutJob& job,
                   const CutRun& run,
                   const std::vector<std::string>& heading,
                   const std::string& name) {
  const std::string program = program_of(job, run, heading);
  Judgement judgement = judge_program(name, program, standpoint_of(settings_of(run)));
  return {std::move(judgement.faults), job.plan.order.predicted_s(), false};
}

cut::EdgeFigures drive(const CutJob& job, const CutRun& run, const char* setting) {
  const std::string text = simulated(job, run, {}).text();
  Simulator simulator{text, {.machine = {.has_switches = false}}};
  apply_settings(run.settings, simulator.machine());
  apply_settings({parse_setting(setting, "--check")}, simulator.machine());
  const cut::EdgeCheck check{job, text, simulator};
  static_cast<void>(simulator.run());
  return check.figures();
}

}  // namespace

std::string program_of(const CutJob& job,
                       const CutRun& run,
                       const std::vector<std::string>& heading) {
  return cut::program_of(
      job.plan, job.drawn, job.beam, cnc::gcode::PrintGrid{run.decimals}, heading);
}

ProgramCheck check_program(const CutJob& job,
                           const CutRun& run,
                           const std::vector<std::string>& heading,
                           const std::string& name) {
  const bool needs_tables = job.beam.kerf_table.has_value();
  if (!needs_tables && job.plan.order.predicted_s() > kMaxSimulatedS) {
    return judge(job, run, heading, name);
  }
  const SimulatedProgram program = simulated(job, run, heading);
  Report report = check({.file = name,
                         .text = program.text(),
                         .settings = run.settings,
                         .machine = {.has_switches = false}});
  for (Fault& fault : report.faults) {
    fault.line -= std::min(fault.line, program.lines_before());
  }
  return {std::move(report.faults), report.job_time_s, true};
}

cnc::Settings settings_of(const CutRun& run) {
  Simulator simulator{{}, {.machine = {.has_switches = false}}};
  apply_settings(run.settings, simulator.machine());
  return simulator.settings();
}

EdgeChecks check_edges(const CutJob& job, const CutRun& run, std::FILE* told) {
  EdgeChecks checks{.rows = nlohmann::ordered_json::object()};
  const auto& variants = job.beam.kerf_table ? kBesideOnController : kBesideHere;
  std::array<cut::EdgeFigures, kBesideHere.size()> figures{};
  share_work(variants.size(), [&] {
    return [&](std::size_t i) {
      CutJob changed = job;
      changed.beam.follows_speed = variants[i].follows_speed;
      figures[i] = drive(changed, run, variants[i].setting);
    };
  });
  for (std::size_t i = 0; i < variants.size(); ++i) {
    terminal::print(told, "{}:\n", variants[i].name);
    for (const std::string& line : lines_of(figures[i])) terminal::print(told, "  {}\n", line);
    checks.rows[variants[i].key] = json_of(figures[i]);
  }
  checks.first = std::move(figures.front());
  return checks;
}

}  // namespace sim
