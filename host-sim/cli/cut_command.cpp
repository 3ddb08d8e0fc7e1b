#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "firmware/protocol/identity.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/cut_beam.hpp"
#include "host-sim/cli/cut_identity.hpp"
#include "host-sim/cli/cut_layers.hpp"
#include "host-sim/cli/cut_offered.hpp"
#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cli/cut_outputs.hpp"
#include "host-sim/cli/cut_pictures.hpp"
#include "host-sim/cli/cut_recipe.hpp"
#include "host-sim/cli/cut_runs.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/job_options.hpp"
#include "host-sim/cli/machine_option.hpp"
#include "host-sim/cut/cut_report.hpp"
#include "host-sim/cut/layers_alike.hpp"
#include "host-sim/cut/repeat_passes.hpp"
#include "host-sim/cut/timeline.hpp"
#include "host-sim/import/fill_across.hpp"
#include "host-sim/job/travel_check.hpp"
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

/// Returns the faults that the importer found, except faults that the settings of a layer make
/// harmless.
std::vector<drawing::Fault> faults_of(const Drawing& drawn,
                                      const std::vector<cut::LayerPlan>& layers) {
  std::vector<drawing::Fault> faults = picture_faults(drawn, layers);
  for (const drawing::Fault& fault : drawn.faults) {
    if (!fault.is_error()) continue;
    const bool has_layer = fault.entity.layer < layers.size();
    const cut::Side side = has_layer ? layers[fault.entity.layer].settings.side : cut::Side::kWaste;
    if (side == cut::Side::kSkip && fault.kind == drawing::FaultKind::kText) continue;
    const bool of_sides = fault.kind == drawing::FaultKind::kOpen ||
                          fault.kind == drawing::FaultKind::kCrossing ||
                          fault.kind == drawing::FaultKind::kBranch;
    const bool is_line = side == cut::Side::kWaste ? fault.is_of_line : side != cut::Side::kFill;
    if (of_sides && is_line && !fault.entity.name.empty()) continue;
    faults.push_back(fault);
  }
  return faults;
}

void print_faults(const std::vector<drawing::Fault>& faults, const Drawing& drawn) {
  for (const drawing::Fault& fault : faults) {
    terminal::print(stderr, "{}\n", to_string(fault, drawn.file));
  }
}

void print_warnings(const std::vector<drawing::Fault>& warnings, const Drawing& drawn) {
  for (const drawing::Fault& warning : warnings) {
    terminal::print(stderr, "warning: {}\n", to_string(warning, drawn.file));
  }
}

/// Prints the faults of a drawing, and the number of faults that the importer did not list.
void print_all_faults(const std::vector<drawing::Fault>& faults, const Drawing& drawn) {
  print_faults(faults, drawn);
  if (drawn.more_faults != 0) terminal::print(stderr, "and {} more faults\n", drawn.more_faults);
}

/// Prints notes about entities that were left out without a fault, except in skipped layers.
void print_notes(const Drawing& drawn,
                 const std::vector<cut::LayerPlan>& layers,
                 const std::vector<cut::LayerRule>& rules) {
  for (const drawing::Fault& fault : drawn.faults) {
    if (fault.is_error() || is_known_picture(fault, drawn, layers, rules)) continue;
    const bool skipped = fault.kind == drawing::FaultKind::kText &&
                         fault.entity.layer < layers.size() &&
                         layers[fault.entity.layer].settings.side == cut::Side::kSkip;
    if (!skipped) terminal::print(stderr, "note: {}\n", to_string(fault, drawn.file));
  }
}

/// Prints warnings and faults of a plan, and faults of its drawing. Returns whether there are no
/// faults.
bool print_findings(const CutPlan& plan,
                    const std::vector<drawing::Fault>& faults,
                    const Drawing& drawn) {
  print_warnings(plan.warnings, drawn);
  print_all_faults(faults, drawn);
  print_faults(plan.faults, drawn);
  return faults.empty() && plan.faults.empty() && drawn.more_faults == 0;
}

void append(std::vector<drawing::Fault>& faults, const std::vector<drawing::Fault>& more) {
  faults.insert(faults.end(), more.begin(), more.end());
}

/// Prints faults that prevent the planning of cuts, and returns the exit status.
ExitStatus refuse(const CutCommandOptions& options,
                  const std::vector<drawing::Fault>& faults,
                  const Drawing& drawn) {
  print_all_faults(faults, drawn);
  terminal::print(stderr,
                  "kerfline: no program is written; mend the sheet{}\n",
                  stale_note(options.outputs.program));
  return ExitStatus::kFaults;
}

/// Returns the settings of a machine with a laser in the order in which they apply: laser mode, the
/// settings of the profile, the settings of the call.
std::vector<SettingChange> machine_of(const CutCommandOptions& options) {
  std::vector<SettingChange> settings{parse_setting("$32=1", "laser mode")};
  settings.insert(settings.end(), options.machine_settings.begin(), options.machine_settings.end());
  const auto more = settings_of({}, options.settings_file, options.set);
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

bool names_settings(const CutCommandOptions& options) {
  return !options.settings_file.empty() || !options.set.empty() ||
         !options.machine_settings.empty();
}

/// Returns the program, with its time in the heading. Prints the machine's faults of the program
/// and sets `status` accordingly.
std::string timed_program(const CutCommandOptions& options,
                          const CutJob& job,
                          const CutRun& run,
                          CutFigures& figures,
                          ExitStatus& status) {
  const std::string name =
      options.outputs.program.empty() ? "the program" : options.outputs.program;
  const ProgramCheck check = check_program(job, run, heading_of(job, figures), name);
  figures.job_time_s = check.job_time_s;
  figures.is_simulated = check.is_simulated;
  const bool is_of_travel =
      !check.faults.empty() && std::ranges::all_of(check.faults, [](const Fault& fault) {
        return fault.number == kTravelExceeded;
      });
  // If the call names no machine, the travel is that of a new controller.
  const bool is_unknown = is_of_travel && !names_settings(options);
  for (const Fault& fault : check.faults) {
    terminal::print(stderr, "{}{}\n", is_unknown ? "warning: " : "", to_string(fault));
  }
  if (is_unknown) {
    terminal::print(stderr,
                    "kerfline: warning: the job is larger than a new controller's travel; give "
                    "that of your machine with --machine or --settings\n");
  } else if (!check.faults.empty()) {
    terminal::print(
        stderr,
        "kerfline: the machine with its present settings refuses the program; give those of your "
        "machine with --settings, or move the drawing\n");
    status = ExitStatus::kFaults;
  }
  return options.post.applied_to(program_of(job, run, heading_of(job, figures)));
}

const char* refusal_of(const CutPlan& plan) {
  if (plan.cuts.empty()) return "nothing is left to cut; no program is written";
  if (plan.safety.no_way != 0) return "no program is written, as its rapids would not be safe";
  return "no program is written; --anyway cuts the contours without faults";
}

/// Returns the requirements of the call for the order of cuts. A progress line is shown during the
/// search for this order.
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

/// Writes pictures, program, frame and reports of a job. If the job has faults, the program is
/// written only if the call requires a program of the contours that have no faults.
ExitStatus write_job(const CutCommandOptions& options,
                     const CutJob& job,
                     const CutRun& run,
                     const cut::Timeline& timeline,
                     bool sound) {
  CutFigures figures = figures_of(job.plan);
  write_pictures(options.outputs, job, timeline, nullptr);
  if (job.plan.cuts.empty() || job.plan.safety.no_way != 0 || (!sound && !options.anyway)) {
    terminal::print(
        stderr, "kerfline: {}{}\n", refusal_of(job.plan), stale_note(options.outputs.program));
    return ExitStatus::kFaults;
  }
  ExitStatus status = sound ? ExitStatus::kFine : ExitStatus::kFaults;
  ExitStatus taken = ExitStatus::kFine;
  const std::string program = timed_program(options, job, run, figures, taken);
  if (taken != ExitStatus::kFine) status = taken;
  const double job_time_s = taken == ExitStatus::kFine ? figures.job_time_s : 0.0;
  std::FILE* const told = options.outputs.program.empty() ? stderr : stdout;
  for (const std::string& line : lines_of(job, figures)) terminal::print(told, "{}\n", line);
  if (options.outputs.program.empty()) {
    terminal::write_data(program);
  } else {
    write_file(options.outputs.program, program);
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
  if (!options.outputs.report.empty()) {
    write_file(options.outputs.report, dumped(std::move(report)) + "\n");
  }
  return status;
}

/// Refuses a job that leaves the bed. No option of the call overrides this refusal, because the
/// head would run into the machine's frame.
ExitStatus refuse_off_the_bed(const CutCommandOptions& options) {
  terminal::print(stderr,
                  "kerfline: no program is written; the job leaves the bed{}\n",
                  stale_note(options.outputs.program));
  return ExitStatus::kFaults;
}

/// Completes the options by values of the machine's profile where the call gives none.
void take_machine(CutCommandOptions& options, const cut::MachineProfile& machine) {
  if (options.full_power_w == 0.0) options.full_power_w = machine.full_power_w;
  options.machine_settings = machine.settings;
}

/// Moves a drawing to its position on the machine. Returns the text in which place_drawing()
/// describes this move.
std::string put_to_place(const CutCommandOptions& options,
                         CutInput& input,
                         const std::optional<cut::MachineProfile>& machine) {
  const cut::PlaceWishes wishes = place_wishes_of(options.place);
  if (wishes.is_asked() && (input.sheet || !options.sheet.save.empty())) {
    throw std::invalid_argument(
        "--place, --move, --turn, --mirror, --scale and --copies: a sheet contains the positions "
        "of its parts; change them there");
  }
  if (input.sheet) return {};
  return place_drawing(input.drawn, wishes, machine ? &*machine : nullptr, options.import.effort);
}

/// Returns the plan of all pictures and cuts of a call, in the order in which they are driven, with
/// all passes.
CutPlan planned(const CutSource& source,
                const Drawing& drawn,
                const std::vector<cut::LayerPlan>& layers,
                cut::Recipes recipes) {
  const CutCommandOptions& options = source.options;
  const auto beside = options.kerf_table ? cut::WayBeside::kOnController : cut::WayBeside::kHere;
  const cut::OrderWish wish = searched_order(options);
  std::vector<drawing::Fault> white;
  std::vector<cut::Cut> pictures =
      picture_cuts_of(options, drawn, layers, source.beam, wish, white);
  CutPlan plan = plan_cuts(
      drawn, layers, options.curves, beside, std::move(recipes), order_behind(wish, pictures));
  append(plan.warnings, white);
  make_safe(plan, drawn, options.safety);
  put_first(std::move(pictures), wish.from, plan);
  repeat_passes(plan, options.safety);
  return plan;
}

ExitStatus cut_drawing(CLI::App& command, CutCommandOptions& options) {
  apply_recipe(command, options);
  InputFiles inputs{options.outputs.program};
  options.post.read(command, inputs, options.decimals);
  const auto machine = machine_profile_of(options.place.machine);
  if (machine) take_machine(options, *machine);
  CutInput input = read_cut_input(options.file, options.import, inputs);
  const Drawing& drawn = input.drawn;
  const std::vector<cut::LayerRule> rules = layer_rules_of(options, drawn, inputs);
  keep_burnt_pictures(options, rules, input.drawn, inputs);
  const std::string placing = put_to_place(options, input, machine);
  if (input.is_broken_sheet() && !options.anyway) return refuse(options, drawn.faults, drawn);
  const CutRun run{static_cast<std::uint8_t>(options.decimals), machine_of(options)};
  const CutKerf kerf = kerf_of(options);
  options.known = values_of_entry(kerf);
  std::vector<std::string> notes;
  if (machine && !machine->note.empty()) notes.push_back(machine->name + ": " + machine->note);
  const cut::Beam beam =
      beam_of(options, run.settings, kerf, power_wishes(options, drawn, rules), notes);
  const CutSource source{options, kerf, beam};
  const auto layers = layers_of(source, drawn, rules);
  drawing::fill_across(input.drawn, cut::layers_alike(layers), options.import);
  cut::Recipes recipes = recipes_of(source, drawn, layers, inputs);
  std::vector<drawing::Fault> faults = place_faults(input, layers, recipes);
  if (!faults.empty() && !options.anyway) return refuse(options, faults, drawn);
  append(faults, faults_of(drawn, layers));
  inputs.add(kerf.digest());
  inputs.add(settings_digest(settings_of(run), names_settings(options)));
  save_sheet(options.sheet, input);
  CutPlan plan = planned(source, drawn, layers, std::move(recipes));
  const cut::Timeline timeline = predict(plan);
  print_notes(drawn, layers, rules);
  const bool sound = print_findings(plan, faults, drawn);
  std::vector<std::string> origins;
  tell_origin(options, kerf, plan.layers, origins, notes);
  const CutJob job{drawn,
                   plan,
                   kerf.record,
                   beam,
                   options.laser,
                   std::move(notes),
                   inputs.digests(),
                   options.kerf_mm.has_value(),
                   placing,
                   offered_lines(options, drawn, rules),
                   std::move(origins)};
  for (const std::string& note : job.notes)
    terminal::print(stderr, "kerfline: warning: {}\n", note);
  if (machine) {
    const auto off = off_the_bed(plan, drawn, *machine);
    print_faults(off, drawn);
    if (!off.empty()) return refuse_off_the_bed(options);
  }
  save_recipe(command, options);
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
