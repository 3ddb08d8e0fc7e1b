#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/cut_order_options.hpp"
#include "host-sim/cli/engrave_options.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cli/job_options.hpp"
#include "host-sim/cli/machine_option.hpp"
#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/fill_area.hpp"
#include "host-sim/engrave/burn_picture.hpp"
#include "host-sim/engrave/engrave_program.hpp"
#include "host-sim/job/job.hpp"
#include "host-sim/report/duration_text.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using engrave::BurnRaster;
using engrave::EngraveProgram;
using engrave::EngraveSettings;

/// Greatest time of a job that is simulated; the time of longer jobs is estimated.
constexpr double kMaxPreviewS = 1800.0;

/// Returns the settings of the machine in the order in which they apply: laser mode, the settings
/// of the profile, the settings of the call.
std::vector<SettingChange> machine_settings(const EngraveOptions& options,
                                            const std::optional<cut::MachineProfile>& machine) {
  std::vector<SettingChange> settings{parse_setting("$32=1", "laser mode")};
  if (machine) settings.insert(settings.end(), machine->settings.begin(), machine->settings.end());
  const auto more = settings_of({}, options.settings_file, options.set);
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

double greatest_s(const std::vector<SettingChange>& settings) {
  double greatest = 1000.0;
  for (const SettingChange& change : settings) {
    if (change.number == cnc::setting::kMaxSpindleSpeed) {
      greatest = static_cast<double>(change.value);
    }
  }
  return greatest;
}

/// Returns a text on the distance by which an engraving leaves the bed; empty if it stays within
/// the bed.
std::string beyond_bed(const engrave::EngraveFigures& figures, const cut::MachineProfile& machine) {
  constexpr double kSlackMm = 1.0e-3;
  const cut::BedBox bed = machine.bed();
  std::string text;
  const auto add = [&text](double beyond, const char* side) {
    if (beyond > kSlackMm) text += fmt::format(", by {:.3f} mm at its {}", beyond, side);
  };
  add(bed.low.x() - figures.low.x(), "left");
  add(figures.high.x() - bed.high.x(), "right");
  add(bed.low.y() - figures.low.y(), "front");
  add(figures.high.y() - bed.high.y(), "back");
  return text;
}

/// Returns the lower left corner of the picture on the machine.
drawing::Place place_of(const EngraveOptions& options,
                        const drawing::Place& size,
                        const std::optional<cut::MachineProfile>& machine) {
  const cut::PlaceWishes wishes = place_wishes_of(options.place);
  const drawing::Place offset = machine ? machine->beam_offset_mm : drawing::Place{0.0, 0.0};
  return lower_left(wishes, size, machine ? &*machine : nullptr) + wishes.move_mm - offset;
}

std::vector<std::string> heading_of(const EngraveOptions& options,
                                    const BurnRaster& raster,
                                    const EngraveSettings& settings,
                                    const InputFiles& inputs) {
  std::vector<std::string> lines;
  const auto add = [&lines](const std::string& text) { lines.push_back(cut::comment_line(text)); };
  add("kerfline engrave");
  add(fmt::format("X{:.3f} Y{:.3f}, {:.3f} x {:.3f} mm, {} x {} pixels",
                  settings.at_mm.x(),
                  settings.at_mm.y(),
                  raster.pixel_mm * static_cast<double>(raster.columns),
                  raster.interval_mm * static_cast<double>(raster.rows),
                  raster.columns,
                  raster.rows));
  add(fmt::format("{:g} mm/min, S{:g} to S{:g}, overscan {:.2f} mm",
                  settings.feed_mm_min,
                  options.tone.min_power * settings.full_power_s,
                  options.tone.max_power * settings.full_power_s,
                  settings.overscan_mm));
  for (const ProgramDigest& digest : inputs.digests()) add(text_of(digest));
  return lines;
}

/// Time of a job, and whether it is simulated.
struct EngraveTime {
  double seconds = 0.0;
  bool is_simulated = false;
};

/// Checks the program on the simulated machine and returns its time. Faults are printed and set
/// `status`.
EngraveTime time_of(const EngraveProgram& program,
                    const std::vector<SettingChange>& settings,
                    ExitStatus& status) {
  if (program.figures.estimated_s > kMaxPreviewS) return {program.figures.estimated_s, false};
  const Report report = check({.file = "the program", .text = program.text, .settings = settings});
  for (const Fault& fault : report.faults) terminal::print(stderr, "{}\n", to_string(fault));
  if (!report.faults.empty()) status = ExitStatus::kFaults;
  return {report.job_time_s, true};
}

void write_report(const EngraveOptions& options,
                  const BurnRaster& raster,
                  const EngraveProgram& program,
                  const EngraveTime& time) {
  if (options.report.empty()) return;
  nlohmann::ordered_json json;
  json["columns"] = raster.columns;
  json["rows"] = raster.rows;
  json["pixel_mm"] = raster.pixel_mm;
  json["interval_mm"] = raster.interval_mm;
  json["burnt_rows"] = program.figures.rows;
  json["burnt_mm"] = program.figures.burnt_mm;
  json["lines"] = program.figures.lines;
  json["job_time_s"] = time.seconds;
  json["job_time_is"] = time.is_simulated ? "simulated" : "estimated";
  write_file(options.report, dumped(std::move(json)) + "\n");
}

ExitStatus engrave_picture(const CLI::App& command, EngraveOptions& options) {
  const auto machine = machine_profile_of(options.place.machine);
  const std::vector<SettingChange> settings = machine_settings(options, machine);
  InputFiles inputs{options.output};
  unsigned decimals = cnc::gcode::PrintGrid::kMax;
  options.post.read(command, inputs, decimals);
  const std::string bytes = read_bytes(options.file);
  inputs.add("picture", options.file, bytes);
  const picture::GreyImage image = picture::read_image(bytes, name_of_input(options.file));
  EngraveSettings rows = engrave_settings_of(options, machine, greatest_s(settings));
  const BurnRaster raster = raster_of(options, image);
  const cut::OrderWish wish = order_wish_of({}, settings, {});
  if (!options.overscan_mm) {
    rows.overscan_mm = cut::overscan_for(options.feed_mm_min / 60.0, 0.0, wish.limits);
  }
  const drawing::Place size{raster.pixel_mm * static_cast<double>(raster.columns),
                            raster.interval_mm * static_cast<double>(raster.rows)};
  rows.at_mm = place_of(options, size, machine);
  const auto program =
      engrave_program(raster, rows, wish.limits, heading_of(options, raster, rows, inputs));
  if (!program) {
    terminal::print(stderr, "kerfline: the picture is white, so that no program is written\n");
    return ExitStatus::kFaults;
  }
  if (!options.picture.empty()) write_file(options.picture, engrave::burn_picture(raster));
  const std::string beyond = machine ? beyond_bed(program->figures, *machine) : "";
  if (!beyond.empty()) {
    terminal::print(stderr,
                    "kerfline: the picture with its overscan leaves the bed of {}{}; move it with "
                    "--place or --move\n",
                    machine->name,
                    beyond);
    return ExitStatus::kFaults;
  }
  ExitStatus status = ExitStatus::kFine;
  const EngraveTime time = time_of(*program, settings, status);
  if (machine && !machine->note.empty()) {
    terminal::print(stderr, "kerfline: warning: {}: {}\n", machine->name, machine->note);
  }
  std::FILE* const told = options.output.empty() ? stderr : stdout;
  terminal::print(told,
                  "{} x {} pixels, {:.2f} x {:.2f} mm; {} rows, {:.1f} mm burnt; {}{}\n",
                  raster.columns,
                  raster.rows,
                  size.x(),
                  size.y(),
                  program->figures.rows,
                  program->figures.burnt_mm,
                  duration_text(time.seconds),
                  time.is_simulated ? "" : ", estimated");
  write_report(options, raster, *program, time);
  const std::string text = options.post.applied_to(program->text);
  if (options.output.empty()) {
    terminal::write_data(text);
  } else {
    write_file(options.output, text);
  }
  return status;
}

}  // namespace

void add_engrave_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command =
      app.add_subcommand("engrave", "Make a program that burns a picture, row by row.");
  const auto options = std::make_shared<EngraveOptions>();
  add_engrave_options(*command, options);
  command->callback([command, options, &status] { status = engrave_picture(*command, *options); });
}

}  // namespace sim
