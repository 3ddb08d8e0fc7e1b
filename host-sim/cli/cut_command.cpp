#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "firmware/protocol/identity.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/cut_identity.hpp"
#include "host-sim/cli/cut_layers.hpp"
#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cli/cut_outputs.hpp"
#include "host-sim/cli/cut_runs.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/job_options.hpp"
#include "host-sim/cut/cut_report.hpp"
#include "host-sim/cut/kerf_notes.hpp"
#include "host-sim/cut/timeline.hpp"
#include "host-sim/report/progress_bar.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using cut::CutFigures;
using cut::CutJob;
using cut::CutPlan;
using drawing::Drawing;

/// What the importer found wrong, but what the settings of a layer make right.
std::vector<drawing::Fault> faults_of(const Drawing& drawn,
                                      const std::vector<cut::LayerPlan>& layers) {
  std::vector<drawing::Fault> faults;
  for (const drawing::Fault& fault : drawn.faults) {
    if (!fault.is_error()) continue;
    const bool has_layer = fault.entity.layer < layers.size();
    const cut::Side side = has_layer ? layers[fault.entity.layer].settings.side : cut::Side::kWaste;
    const bool of_sides = fault.kind == drawing::FaultKind::kOpen ||
                          fault.kind == drawing::FaultKind::kCrossing ||
                          fault.kind == drawing::FaultKind::kBranch;
    if (side != cut::Side::kWaste && of_sides && !fault.entity.name.empty()) continue;
    faults.push_back(fault);
  }
  return faults;
}

void print_faults(const std::vector<drawing::Fault>& faults, const Drawing& drawn) {
  for (const drawing::Fault& fault : faults) {
    terminal::print(stderr, "{}\n", to_string(fault, drawn.file));
  }
  if (drawn.more_faults != 0) terminal::print(stderr, "and {} more faults\n", drawn.more_faults);
}

/// Prints what the drawing's reader left out or read in another way, which is no fault.
void print_notes(const Drawing& drawn) {
  for (const drawing::Fault& fault : drawn.faults) {
    if (fault.is_error()) continue;
    terminal::print(stderr, "{}: {}\n", name_of(fault.kind), to_string(fault, drawn.file));
  }
}

void append(std::vector<drawing::Fault>& faults, const std::vector<drawing::Fault>& more) {
  faults.insert(faults.end(), more.begin(), more.end());
}

/// Faults for which no cut is planned.
ExitStatus refuse(const CutCommandOptions& options,
                  const std::vector<drawing::Fault>& faults,
                  const Drawing& drawn) {
  print_faults(faults, drawn);
  terminal::print(
      stderr, "kerfline: no program is written; mend the sheet{}\n", stale_note(options.output));
  return ExitStatus::kFaults;
}

/// A machine with a laser, and whatever else is said of it.
std::vector<SettingChange> machine_of(const CutCommandOptions& options) {
  std::vector<SettingChange> settings{parse_setting("$32=1", "laser mode")};
  const auto more = settings_of(options.settings_file, options.set);
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

bool names_settings(const CutCommandOptions& options) {
  return !options.settings_file.empty() || !options.set.empty();
}

cut::Beam beam_of(const CutCommandOptions& options,
                  const std::vector<SettingChange>& settings,
                  const MaterialRecord& record) {
  cut::Beam beam{.full_power_w = options.full_power_w,
                 .follows_speed = !options.constant_power,
                 .kerf_table = options.kerf_table};
  if (beam.full_power_w == 0.0) {
    beam.full_power_w =
        from_thousandths(cut::greatest_power(record, thickness_option(options.thickness_mm)));
  }
  for (const SettingChange& change : settings) {
    if (change.number == cnc::setting::kMostSpindleSpeed) {
      beam.full_power_s = static_cast<double>(change.value);
    }
  }
  return beam;
}

/// The program, with the time that it takes in its heading; with faults where the machine
/// refuses it.
std::string timed_program(const CutCommandOptions& options,
                          const CutJob& job,
                          const CutRun& run,
                          CutFigures& figures,
                          ExitStatus& status) {
  const std::string name = options.output.empty() ? "the program" : options.output;
  const ProgramCheck check = check_program(job, run, heading_of(job, figures), name);
  figures.job_time_s = check.job_time_s;
  figures.is_simulated = check.is_simulated;
  for (const Fault& fault : check.faults) terminal::print(stderr, "{}\n", to_string(fault));
  if (!check.faults.empty()) {
    terminal::print(
        stderr,
        "kerfline: the machine as it is set does not take the program; tell of yours with "
        "--settings, or move the drawing\n");
    status = ExitStatus::kFaults;
  }
  return options.post.applied_to(program_of(job, run, heading_of(job, figures)));
}

const char* refusal_of(const CutPlan& plan) {
  if (plan.cuts.empty()) return "nothing is left to cut; no program is written";
  if (plan.safety.no_way != 0) return "no program is written; its rapids would not be safe";
  return "no program is written; --anyway cuts what is sound";
}

/// The wishes of the call, with a progress line while the order is searched.
cut::OrderWish searched_order(const CutCommandOptions& options) {
  order::OrderProgress progress;
  if (is_terminal(stderr)) {
    using Clock = std::chrono::steady_clock;
    progress = [bar = std::make_shared<ProgressBar>(stderr, true, Clock::now())](double share,
                                                                                 double cost) {
      bar->update(share, fmt::format("order {:.0f} mm of rapids", cost), Clock::now());
      if (share >= 1.0) bar->clear();
    };
  }
  cut::OrderWish wish = order_wish_of(options.order, machine_of(options), std::move(progress));
  wish.decimals = static_cast<std::uint8_t>(options.decimals);
  return wish;
}

/// Writes pictures, program, frame and reports of a job; no program of a job with faults, unless
/// the call wants one of what is sound.
ExitStatus write_job(const CutCommandOptions& options,
                     const CutJob& job,
                     const CutRun& run,
                     const cut::Timeline& timeline,
                     bool sound) {
  CutFigures figures = figures_of(job.plan);
  write_pictures(options.outputs, job, timeline, nullptr);
  if (job.plan.cuts.empty() || job.plan.safety.no_way != 0 || (!sound && !options.anyway)) {
    terminal::print(stderr, "kerfline: {}{}\n", refusal_of(job.plan), stale_note(options.output));
    return ExitStatus::kFaults;
  }
  ExitStatus status = sound ? ExitStatus::kFine : ExitStatus::kFaults;
  ExitStatus taken = ExitStatus::kFine;
  const std::string program = timed_program(options, job, run, figures, taken);
  if (taken != ExitStatus::kFine) status = taken;
  const double job_time_s = taken == ExitStatus::kFine ? figures.job_time_s : 0.0;
  std::FILE* const told = options.output.empty() ? stderr : stdout;
  for (const std::string& line : lines_of(job, figures)) terminal::print(told, "{}\n", line);
  if (options.output.empty()) {
    terminal::write_data(program);
  } else {
    write_file(options.output, program);
  }
  write_frame(options.frame, job, run, options.post);
  nlohmann::ordered_json report = json_of(job, figures);
  account_for(options.outputs, job, timeline, job_time_s, told, report);
  report["version"] = cnc::identity::version();
  if (options.check) {
    EdgeChecks checks = check_edges(job, run, told);
    report["edges"] = std::move(checks.rows);
    write_pictures(options.outputs, job, timeline, &checks.first);
  }
  if (!options.report.empty()) {
    write_file(options.report, dumped(std::move(report)) + "\n");
  }
  return status;
}

ExitStatus cut_drawing(const CLI::App& command, CutCommandOptions& options) {
  InputFiles inputs{options.output};
  options.post.read(command, inputs, options.decimals);
  const CutInput input = read_cut_input(options.file, options.import, inputs);
  const Drawing& drawn = input.drawn;
  print_notes(drawn);
  if (input.is_broken_sheet() && !options.anyway) return refuse(options, drawn.faults, drawn);
  const MaterialRecord record = options.record.record();
  const auto layers = layers_of(options, drawn, record, inputs);
  cut::Recipes recipes = recipes_of(options, drawn, layers, record, inputs);
  std::vector<drawing::Fault> faults = place_faults(input, layers, recipes);
  if (!faults.empty() && !options.anyway) return refuse(options, faults, drawn);
  append(faults, faults_of(drawn, layers));
  const auto beside = options.kerf_table ? cut::WayBeside::kOnController : cut::WayBeside::kHere;
  const CutRun run{static_cast<std::uint8_t>(options.decimals), machine_of(options)};
  inputs.add(digest_of(record));
  inputs.add(settings_digest(settings_of(run), names_settings(options)));
  save_sheet(options.sheet, input);
  CutPlan plan =
      plan_cuts(drawn, layers, options.curves, beside, std::move(recipes), searched_order(options));
  make_safe(plan, drawn, options.safety);
  const cut::Timeline timeline = predict(plan);
  print_faults(faults, drawn);
  print_faults(plan.faults, drawn);
  print_faults(plan.warnings, drawn);
  const bool sound = faults.empty() && plan.faults.empty();
  const CutJob job{drawn,
                   plan,
                   record,
                   beam_of(options, run.settings, record),
                   options.laser,
                   kerf_notes(record, options.laser, options.record.records(), plan.layers),
                   inputs.digests()};
  for (const std::string& note : job.notes)
    terminal::print(stderr, "kerfline: warning: {}\n", note);
  return write_job(options, job, run, timeline, sound);
}

}  // namespace

void add_cut_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "cut", "Make a program that cuts the parts of a drawing to size, whatever the kerf.");
  const auto options = std::make_shared<CutCommandOptions>();
  add_cut_options(*command, options);
  command->callback([command, options, &status] { status = cut_drawing(*command, *options); });
}

}  // namespace sim
