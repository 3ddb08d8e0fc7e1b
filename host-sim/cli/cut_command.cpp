#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "firmware/protocol/identity.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cli/cut_runs.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/job_options.hpp"
#include "host-sim/cut/cut_report.hpp"
#include "host-sim/cut/kerf_notes.hpp"
#include "host-sim/plot/cut_picture.hpp"
#include "host-sim/report/nearest_name.hpp"
#include "host-sim/report/progress_bar.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using cut::CutFigures;
using cut::CutJob;
using cut::CutPlan;
using cut::LayerSettings;
using drawing::Drawing;

std::vector<cut::LayerRule> rules_of(const CutCommandOptions& options, const Drawing& drawn) {
  std::vector<cut::LayerRule> rules;
  if (!options.layers_file.empty()) {
    rules = cut::read_rules(read_text(options.layers_file), options.layers_file);
  }
  for (const std::string& text : options.layers) rules.push_back(cut::parse_rule(text, "--layer"));
  for (const cut::LayerRule& rule : rules) {
    std::string known;
    std::vector<std::string> names;
    bool found = false;
    for (const drawing::Layer& layer : drawn.layers) {
      found = found || rule.name == layer.name || rule.name == layer.colour;
      names.insert(names.end(), {layer.name, layer.colour});
      known += fmt::format(" \"{}\" {};", layer.name, layer.colour);
    }
    if (found) continue;
    throw std::invalid_argument(
        fmt::format("{}: the drawing has no layer or colour \"{}\"; it has{}{}",
                    rule.place,
                    rule.name,
                    known,
                    did_you_mean(rule.name, names)));
  }
  return rules;
}

/// Names the layer of what is not permissible.
cut::Condition condition_for(const drawing::Layer& layer,
                             const MaterialRecord& record,
                             std::uint32_t thickness,
                             std::optional<std::uint32_t> power,
                             std::optional<std::uint32_t> speed,
                             double full_power_w) {
  const std::uint32_t most = full_power_w > 0.0
                                 ? thousandths_of("--full-power", full_power_w, 4.0e6, "W")
                                 : cnc::kerf::kMostPowerMw;
  try {
    return cut::choose(record, thickness, power, speed, most);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("layer \"{}\" {}: {}", layer.name, layer.colour, error.what()));
  }
}

/// Power and feed of each layer; those that are skipped need none.
std::vector<cut::LayerPlan> layers_of(const CutCommandOptions& options,
                                      const Drawing& drawn,
                                      const MaterialRecord& record) {
  LayerSettings common;
  for (const auto& [key, value] : options.common) {
    try {
      set(common, key, value);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("--{}", error.what()));
    }
  }
  const std::vector<cut::LayerRule> rules = rules_of(options, drawn);
  const std::uint32_t thickness = thickness_option(options.thickness_mm);
  std::vector<cut::LayerPlan> layers;
  for (const drawing::Layer& layer : drawn.layers) {
    cut::LayerPlan plan{settings_for(layer, common, rules), {}};
    if (plan.settings.side != cut::Side::kSkip) {
      std::optional<std::uint32_t> power;
      std::optional<std::uint32_t> speed;
      if (plan.settings.power_w) power = power_option(*plan.settings.power_w);
      if (plan.settings.feed_mm_min) speed = speed_option(*plan.settings.feed_mm_min);
      plan.condition = condition_for(layer, record, thickness, power, speed, options.full_power_w);
    }
    layers.push_back(plan);
  }
  return layers;
}

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

/// A machine with a laser, and whatever else is said of it.
std::vector<SettingChange> machine_of(const CutCommandOptions& options) {
  std::vector<SettingChange> settings{parse_setting("$32=1", "laser mode")};
  const auto more = settings_of(options.settings_file, options.set);
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
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
  const Report report = check_program(job, run, lines_of(job, figures), name);
  figures.job_time_s = report.job_time_s;
  for (const Fault& fault : report.faults) terminal::print(stderr, "{}\n", to_string(fault));
  if (!report.faults.empty()) {
    terminal::print(
        stderr,
        "kerfline: the machine as it is set does not take the program; tell of yours with "
        "--settings, or move the drawing\n");
    status = ExitStatus::kFaults;
  }
  return program_of(job, run, lines_of(job, figures));
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
  return order_wish_of(options.order, machine_of(options), std::move(progress));
}

ExitStatus cut_drawing(const CutCommandOptions& options) {
  const Drawing drawn =
      drawing::read_drawing(options.file, read_text(options.file), options.import);
  const MaterialRecord record = options.record.record();
  const auto layers = layers_of(options, drawn, record);
  const std::vector<drawing::Fault> faults = faults_of(drawn, layers);
  const auto beside = options.kerf_table ? cut::WayBeside::kOnController : cut::WayBeside::kHere;
  const CutPlan plan = plan_cuts(drawn, layers, options.curves, beside, searched_order(options));
  print_faults(faults, drawn);
  print_faults(plan.faults, drawn);
  print_faults(plan.warnings, drawn);
  const bool sound = faults.empty() && plan.faults.empty();
  const CutRun run{static_cast<std::uint8_t>(options.decimals), machine_of(options)};
  const CutJob job{drawn,
                   plan,
                   record,
                   beam_of(options, run.settings, record),
                   options.laser,
                   kerf_notes(record, options.laser, options.record.records(), plan.layers)};
  for (const std::string& note : job.notes)
    terminal::print(stderr, "kerfline: warning: {}\n", note);
  CutFigures figures = figures_of(plan);
  const auto draw = [&](const cut::EdgeFigures* edges) {
    if (!options.svg.empty()) write_file(options.svg, draw_cuts(drawn, plan, drawn.file, edges));
  };
  draw(nullptr);
  if (plan.cuts.empty() || (!sound && !options.anyway)) {
    terminal::print(stderr,
                    "kerfline: {}{}\n",
                    plan.cuts.empty() ? "nothing is left to cut; no program is written"
                                      : "no program is written; --anyway cuts what is sound",
                    stale_note(options.output));
    return ExitStatus::kFaults;
  }
  ExitStatus status = sound ? ExitStatus::kFine : ExitStatus::kFaults;
  const std::string program = timed_program(options, job, run, figures, status);
  std::FILE* const told = options.output.empty() ? stderr : stdout;
  for (const std::string& line : lines_of(job, figures)) terminal::print(told, "{}\n", line);
  if (options.output.empty()) {
    terminal::write_data(program);
  } else {
    write_file(options.output, program);
  }
  nlohmann::ordered_json report = json_of(job, figures);
  report["version"] = cnc::identity::version();
  if (options.check) {
    EdgeChecks checks = check_edges(job, run, told);
    report["edges"] = std::move(checks.rows);
    draw(&checks.first);
  }
  if (!options.report.empty()) {
    write_file(options.report, dumped(std::move(report)) + "\n");
  }
  return status;
}

}  // namespace

void add_cut_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "cut", "Make a program that cuts the parts of a drawing to size, whatever the kerf.");
  const auto options = std::make_shared<CutCommandOptions>();
  add_cut_options(*command, options);
  command->callback([options, &status] { status = cut_drawing(*options); });
}

}  // namespace sim
