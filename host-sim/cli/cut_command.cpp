#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "firmware/protocol/identity.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/cut_runs.hpp"
#include "host-sim/cli/job_options.hpp"
#include "host-sim/cli/kerf_options.hpp"
#include "host-sim/cli/outline_options.hpp"
#include "host-sim/cut/cut_report.hpp"
#include "host-sim/plot/cut_picture.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using cut::CutFigures;
using cut::CutJob;
using cut::CutPlan;
using cut::LayerSettings;
using drawing::Drawing;

constexpr const char* kCutFooter =
    "Parts get the drawn size: the beam goes half a kerf beside the line, on the side of the\n"
    "waste. Power and feed that are not given are chosen: the fastest permissible cut.\n"
    "Lines and arcs stay what they are, other curves become smooth arcs within the tolerance.\n"
    "--layer 'holes: feed=3000, lead-in=line:1' is for the layer, or colour, of that name; keys\n"
    "are power, feed, side (waste, on: on the line, skip), lead-in, lead-out (none, line:MM,\n"
    "arc:MM), overcut, tabs, tab-width, pierce, corner-loop, corner-dwell and corner-angle.\n"
    "With --kerf-table the program has the drawn outlines and M190, and the controller goes by\n"
    "its own table, its $PC and $860; tabs, corner loops and dwells keep a contour from it.\n"
    "--layers FILE has one such text to a line.\n"
    "\n"
    "Example:\n"
    "  kerfline cut part.dxf --material 'CSP 1N' --thickness 2 --lead-in arc:3 -o part.nc "
    "--svg part.svg\n"
    "\n"
    "Exit status: 0 fine, 1 the drawing has faults, 2 the call is wrong.";

struct CutCommandOptions {
  std::string file;
  drawing::ImportOptions import;
  OutlineOptions curves;
  RecordOptions record;
  double thickness_mm = 0.0;
  std::vector<std::pair<std::string, std::string>> common;  ///< Keys of LayerSettings.
  std::vector<std::string> layers;
  std::string layers_file;
  double full_power_w = 0.0;  ///< 0: the greatest of the record.
  bool constant_power = false;
  std::optional<unsigned> kerf_table{};  ///< The controller finds the way beside parts.
  bool anyway = false;
  bool check = false;
  unsigned decimals = 4;
  std::string settings_file;
  std::vector<std::string> set;
  std::string output;
  std::string svg;
  std::string report;
};

std::vector<cut::LayerRule> rules_of(const CutCommandOptions& options, const Drawing& drawn) {
  std::vector<cut::LayerRule> rules;
  if (!options.layers_file.empty()) {
    rules = cut::read_rules(read_text(options.layers_file), options.layers_file);
  }
  for (const std::string& text : options.layers) rules.push_back(cut::parse_rule(text, "--layer"));
  for (const cut::LayerRule& rule : rules) {
    std::string known;
    bool found = false;
    for (const drawing::Layer& layer : drawn.layers) {
      found = found || rule.name == layer.name || rule.name == layer.colour;
      known += fmt::format(" \"{}\" {};", layer.name, layer.colour);
    }
    if (found) continue;
    throw std::invalid_argument(fmt::format(
        "{}: the drawing has no layer or colour \"{}\"; it has{}", rule.place, rule.name, known));
  }
  return rules;
}

/// Names the layer of what is not permissible.
cut::Condition condition_for(const drawing::Layer& layer,
                             const MaterialRecord& record,
                             std::uint32_t thickness,
                             std::optional<std::uint32_t> power,
                             std::optional<std::uint32_t> speed) {
  try {
    return cut::choose(record, thickness, power, speed);
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
  for (const auto& [key, value] : options.common) set(common, key, value);
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
      plan.condition = condition_for(layer, record, thickness, power, speed);
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
    fmt::print(stderr, "{}\n", to_string(fault, drawn.file));
  }
  if (drawn.more_faults != 0) fmt::print(stderr, "and {} more faults\n", drawn.more_faults);
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
  const Report report = check_program(job, run, name);
  figures.job_time_s = report.job_time_s;
  for (const Fault& fault : report.faults) fmt::print(stderr, "{}\n", to_string(fault));
  if (!report.faults.empty()) {
    fmt::print(stderr,
               "kerfline: the machine as it is set does not take the program; tell of yours with "
               "--settings, or move the drawing\n");
    status = ExitStatus::kFaults;
  }
  return program_of(job, run, lines_of(job, figures));
}

ExitStatus cut_drawing(const CutCommandOptions& options) {
  const Drawing drawn =
      drawing::read_drawing(options.file, read_text(options.file), options.import);
  const MaterialRecord record = options.record.record();
  const auto layers = layers_of(options, drawn, record);
  const std::vector<drawing::Fault> faults = faults_of(drawn, layers);
  const auto beside = options.kerf_table ? cut::WayBeside::kOnController : cut::WayBeside::kHere;
  const CutPlan plan = plan_cuts(drawn, layers, options.curves, beside);
  print_faults(faults, drawn);
  print_faults(plan.faults, drawn);
  print_faults(plan.warnings, drawn);
  const bool sound = faults.empty() && plan.faults.empty();
  const CutRun run{static_cast<std::uint8_t>(options.decimals), machine_of(options)};
  const CutJob job{drawn, plan, record, beam_of(options, run.settings, record)};
  CutFigures figures = figures_of(plan);
  const auto draw = [&](const cut::EdgeFigures* edges) {
    if (!options.svg.empty()) write_file(options.svg, draw_cuts(drawn, plan, drawn.file, edges));
  };
  draw(nullptr);
  if (plan.cuts.empty() || (!sound && !options.anyway)) {
    fmt::print(stderr,
               "kerfline: {}\n",
               plan.cuts.empty() ? "nothing is left to cut; no program is written"
                                 : "no program is written; --anyway cuts what is sound");
    return ExitStatus::kFaults;
  }
  ExitStatus status = sound ? ExitStatus::kFine : ExitStatus::kFaults;
  const std::string program = timed_program(options, job, run, figures, status);
  std::FILE* const told = options.output.empty() ? stderr : stdout;
  for (const std::string& line : lines_of(job, figures)) fmt::print(told, "{}\n", line);
  if (options.output.empty()) {
    fmt::print("{}", program);
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
    constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
    write_file(options.report, report.dump(2, ' ', false, kReplace) + "\n");
  }
  return status;
}

void add_common_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options) {
  const auto add = [&](const std::string& key, const std::string& type, const std::string& help) {
    command
        .add_option_function<std::string>(
            "--" + key,
            [options, key](const std::string& value) { options->common.emplace_back(key, value); },
            help)
        ->type_name(type);
  };
  add("power", "W", "Else chosen");
  add("feed", "MM/MIN", "Else chosen");
  add("lead-in", "KIND:MM", "none, line:MM or arc:MM; arc:2");
  add("lead-out", "KIND:MM", "The same; none");
  add("overcut", "MM", "How far to go on where the contour began; 0");
  add("tabs", "COUNT", "Places at which parts stay in the sheet; 0");
  add("tab-width", "MM", "What is left standing at each; 0.5");
  add("pierce", "S", "Time to get through before a cut; 0");
  add("corner-loop", "MM", "Radius of loops in the waste past outer corners; 0, none");
  add("corner-dwell", "S", "Dark rest at corners without a loop; 0, none");
  add("corner-angle", "DEG", "Corners that turn by less are none; 45");
}

}  // namespace

void add_cut_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "cut", "Make a program that cuts the parts of a drawing to size, whatever the kerf.");
  command->footer(kCutFooter);
  const auto options = std::make_shared<CutCommandOptions>();
  command->add_option("DRAWING", options->file, "SVG, DXF or JSON; - is standard input")
      ->required();
  options->record.add_to(*command);
  command->get_option("--material")->required();
  command->add_option("--thickness", options->thickness_mm, "mm")->required()->type_name("T");
  add_common_options(*command, options);
  command->add_option("--layer", options->layers, "What is other for a layer; may be repeated")
      ->type_name("TEXT")
      ->allow_extra_args(false);
  command->add_option("--layers", options->layers_file, "File of them")->type_name("FILE");
  command
      ->add_option(
          "--full-power", options->full_power_w, "What the laser gives at $30; the record's most")
      ->check(CLI::PositiveNumber)
      ->type_name("W");
  command
      ->add_option("--kerf-table",
                   options->kerf_table,
                   "Leave the way beside parts to the controller (G42), which has the material as "
                   "table P of $K")
      ->check(CLI::Range(0U, 99U))
      ->type_name("P");
  command->add_flag("--constant-power", options->constant_power, "M3 instead of M4");
  command->add_option("--gap", options->import.gap_mm, "Ends no farther apart are joined, mm")
      ->check(CLI::Range(drawing::kLeastGapMm, drawing::kGreatestGapMm))
      ->capture_default_str();
  add_outline_options(*command, options->curves);
  command->add_flag("--anyway", options->anyway, "Cut what is sound of a drawing with faults");
  command->add_flag("--check", options->check, "Drive it and measure how well the parts fit");
  command->add_option("--decimals", options->decimals, "Of places, mm")
      ->check(CLI::Range(unsigned{cnc::gcode::PrintGrid::kFewest},
                         unsigned{cnc::gcode::PrintGrid::kMost}))
      ->capture_default_str();
  command->add_option("--settings", options->settings_file, "The machine's $N=value lines")
      ->type_name("FILE");
  command->add_option("--set", options->set, "One setting of the machine; may be repeated")
      ->type_name("$N=V")
      ->allow_extra_args(false);
  command->add_option("-o,--output", options->output, "The program; else standard output")
      ->type_name("FILE");
  command->add_option("--svg", options->svg, "Draw parts, path and kerf")->type_name("FILE");
  command->add_option("--report", options->report, "Write the report as JSON")->type_name("FILE");
  command->callback([options, &status] { status = cut_drawing(*options); });
}

}  // namespace sim
