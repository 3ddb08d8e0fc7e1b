#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/kerf_commands.hpp"
#include "host-sim/cli/kerf_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/knowledge/coupon.hpp"
#include "host-sim/knowledge/flash_lines.hpp"
#include "host-sim/knowledge/kerf_figures.hpp"
#include "host-sim/plot/png.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

struct PlotOptions {
  RecordOptions record;
  int figure = 7;
  double thickness_mm = 1.6;
  std::string svg;
  std::string png;
};

struct CalibrateOptions {
  RecordOptions record;
  CouponPlan plan;
  double thickness_mm = 0.0;
  std::vector<double> powers_w;
  std::vector<double> speeds_mm_min;
  std::string program;
  std::string form;
  std::string measured;
  AcceptanceLimits limits;
  PersonOptions person;
};

struct ImageOptions {
  RecordOptions record;
  std::string name;
  std::string out;
  bool bytes = false;
};

void plot(const PlotOptions& options) {
  if (options.svg.empty() && options.png.empty()) {
    throw std::invalid_argument("--svg or --png is missing");
  }
  const KnowledgeBase base = options.record.open();
  const MaterialRecord record = base.record_of(options.record.material, options.record.heat_unit());
  if (!record.has_kerf()) {
    throw std::invalid_argument(fmt::format(
        "{}: no kerf is known, so that nothing can be drawn; `kerfline kerf show` has its settings",
        record.name));
  }
  const std::vector<Experiment> cuts = base.cuts_of(options.record.material);
  const std::string figure =
      options.figure == 8
          ? draw_kerf_over_heat(record, cuts)
          : draw_kerf_over_speed(record, thickness_option(options.thickness_mm), cuts);
  if (!options.svg.empty()) write_file(options.svg, figure);
  if (!options.png.empty()) write_png(options.png, figure);
}

void add_plot_command(CLI::App& kerf) {
  CLI::App* command =
      kerf.add_subcommand("plot",
                          "Draw a record as in the paper: kerf over speed and power "
                          "(figure 7), or over effective heat input (figure 8).");
  command->footer(
      "Examples:\n"
      "  kerfline kerf plot --material 'CSP 1N' --thickness 2 --svg kerf.svg\n"
      "  kerfline kerf plot --material 'CSP 1N' --figure 8 --unit J/mm --png kerf.png");
  const auto options = std::make_shared<PlotOptions>();
  options->record.add_to(*command);
  command->get_option("--material")->required();
  command->add_option("--figure", options->figure, "Number of the figure in Park and Ahn 2007")
      ->check(CLI::IsMember({7, 8}))
      ->capture_default_str();
  command
      ->add_option(
          "--thickness", options->thickness_mm, "Thickness of the material in figure 7, mm")
      ->check(thickness_range())
      ->capture_default_str();
  mark_file(command->add_option("--svg", options->svg, "Draw the figure as SVG")->type_name("FILE"),
            FileRole::kOutput);
  mark_file(command->add_option("--png", options->png, "Draw the figure as PNG")->type_name("FILE"),
            FileRole::kOutput);
  command->callback([options] { plot(*options); });
}

/// Returns a slot for every combination of the named powers and speeds.
std::vector<cnc::kerf::Condition> named_slots(const CalibrateOptions& options) {
  if (options.powers_w.empty() || options.speeds_mm_min.empty()) {
    throw std::invalid_argument("--powers and --speeds require each other; give both");
  }
  std::vector<cnc::kerf::Condition> slots;
  for (const double power : options.powers_w) {
    for (const double speed : options.speeds_mm_min) {
      slots.push_back(
          {thickness_option(options.thickness_mm), power_option(power), speed_option(speed)});
    }
  }
  return slots;
}

void write_coupon(const CalibrateOptions& options) {
  if (options.program.empty()) throw std::invalid_argument("--out or --measured is missing");
  if (options.plan.full_power_w <= 0.0) throw std::invalid_argument("--full-power is missing");
  CouponPlan plan = options.plan;
  plan.material = options.record.material;
  if (options.powers_w.empty() && options.speeds_mm_min.empty()) {
    const MaterialRecord record = options.record.record();
    plan.slots = default_slots(record, thickness_option(options.thickness_mm));
    // Only a calibrated record names this machine's laser, with which the slots are cut.
    if (plan.laser.empty() && record.calibrated) plan.laser = record.laser;
    if (plan.gas_pressure_mpa <= 0.0) plan.gas_pressure_mpa = record.gas_pressure_mpa;
  } else {
    plan.slots = named_slots(options);
  }
  write_file(options.program, coupon_program(plan));
  if (!options.form.empty()) {
    write_file(options.form, coupon_form(plan));
    if (plan.laser.empty()) {
      terminal::print(
          stderr,
          "kerfline: {} names no laser; write the name of the laser into the form, or give --laser "
          "NAME with this call or with --measured\n",
          options.form);
    }
  }
  terminal::print("{}: {} slots\n", options.program, plan.slots.size());
}

/// Returns the cuts of the data base that have the same material, laser and gas pressure as at
/// least one of the cuts `measured`.
std::vector<Experiment> cuts_like(const std::vector<Experiment>& measured,
                                  const KnowledgeBase& base,
                                  const std::string& material) {
  std::vector<Experiment> cuts = base.cuts_of(material);
  std::erase_if(cuts, [&](const Experiment& cut) {
    return std::ranges::none_of(measured, [&](const Experiment& one) {
      return one.material == material && one.laser == cut.laser &&
             one.gas_pressure_mpa == cut.gas_pressure_mpa;
    });
  });
  return cuts;
}

/// Adds measured slots to the data base. Then fits, for each measured material, all its cuts by
/// this laser.
void take_measurements(const CalibrateOptions& options) {
  if (options.record.data_base.empty()) throw std::invalid_argument("--db is missing");
  if (!options.program.empty() || !options.form.empty()) {
    throw std::invalid_argument(
        "--measured reads a form, but --out and --form write one; leave --measured or these out");
  }
  const CutOptions cuts{
      options.record.data_base, options.limits, options.plan.laser, options.person, true};
  const std::vector<Experiment> measured = add_cuts(options.measured, cuts);
  std::set<std::string> materials;
  for (const Experiment& cut : measured) materials.insert(cut.material);
  KnowledgeBase base{options.record.data_base, SqlFile::Mode::kWrite};
  FitOptions fitting;
  fitting.unit = options.record.heat_unit().value_or(fitting.unit);
  for (const std::string& material : materials) {
    const MaterialRecord record = fit_record(cuts_like(measured, base, material), fitting);
    base.save(record);
    print_record(record);
  }
}

void add_coupon_options(CLI::App& command, CalibrateOptions& options) {
  CouponPlan& plan = options.plan;
  command.add_option("--thickness", options.thickness_mm, "Thickness of the material, mm")
      ->check(thickness_range());
  command
      .add_option("--powers",
                  options.powers_w,
                  "Powers of the slots, W, such as 30,45,60; default: those of the record")
      ->delimiter(',')
      ->check(power_range());
  command
      .add_option("--speeds",
                  options.speeds_mm_min,
                  "Speeds of the slots, mm/min, such as 400,600,800; default: those of the record")
      ->delimiter(',')
      ->check(speed_range());
  command.add_option("--full-power", plan.full_power_w, "Power of the laser at --full-s, W")
      ->check(in_range(0.001, from_thousandths(cnc::kerf::kMaxPowerMw), "W"));
  command.add_option("--full-s", plan.full_power_s, "S word of full power, the machine's $30")
      ->check(in_range(1.0, 1.0e6, ""))
      ->capture_default_str();
  command.add_option("--laser",
                     plan.laser,
                     "Name of the laser in the form, and for cuts whose form does not name one");
  options.person.add_to(command);
  command.add_option("--gas", plan.gas_pressure_mpa, "Pressure of the gas in the form, MPa")
      ->check(in_range(0.0, 10.0, "MPa"));
  command.add_option("--length", plan.length_mm, "Length of a slot, mm")
      ->check(in_range(10.0, 1000.0, "mm"))
      ->capture_default_str();
  command.add_option("--pitch", plan.pitch_mm, "Distance between slots, mm")
      ->check(in_range(1.0, 100.0, "mm"))
      ->capture_default_str();
}

void add_calibrate_command(CLI::App& kerf) {
  CLI::App* command = kerf.add_subcommand(
      "calibrate",
      "Write the G-code of a test coupon, a slot for each condition, and a form to measure it by\n"
      "(--out, --form); or, with the form filled in, add its cuts and fit the record "
      "(--measured).");
  command->footer(
      "Examples:\n"
      "  kerfline kerf calibrate --material acrylic --thickness 3 --full-power 60 --laser mine "
      "--out coupon.nc --form slots.csv\n"
      "  kerfline kerf calibrate --measured slots.csv --db my.db --unit J/mm\n"
      "\n"
      "In the form, dross and straightness may stay empty; the cut is then judged without them. "
      "The\n"
      "line of a slot that was not measured may stay empty, too.");
  const auto options = std::make_shared<CalibrateOptions>();
  options->record.add_to(*command);
  add_coupon_options(*command, *options);
  const auto add_file = [&](FileRole role, const char* name, std::string& file, const char* help) {
    mark_file(command->add_option(name, file, help)->type_name("FILE"), role);
  };
  add_file(FileRole::kOutput, "--out", options->program, "Write the coupon's G-code");
  add_file(FileRole::kOutput, "--form", options->form, "Write the form as CSV");
  add_file(
      FileRole::kInput, "--measured", options->measured, "Read the form with the measured values");
  command->callback([options] {
    if (options->measured.empty()) {
      write_coupon(*options);
    } else {
      take_measurements(*options);
    }
  });
}

void write_image_file(const ImageOptions& options) {
  const MaterialRecord record = options.record.record();
  const auto image = flash_image(record, options.name.empty() ? record.name : options.name);
  if (options.bytes) {
    write_file(options.out, {reinterpret_cast<const char*>(image.data()), image.size()});
  } else {
    write_file(options.out, flash_lines(image));
  }
  terminal::print("{}: {} bytes of flash\n", options.out, image.size());
}

void add_image_command(CLI::App& kerf) {
  CLI::App* command = kerf.add_subcommand(
      "image",
      "Write a record as the lines that put it into a controller's flash: send the file by any\n"
      "sender while the machine rests.");
  command->footer(
      "Example:\n"
      "  kerfline kerf image --material acrylic --db my.db --as acrylic --out acrylic.kerf");
  const auto options = std::make_shared<ImageOptions>();
  options->record.add_to(*command);
  command->get_option("--material")->required();
  command
      ->add_option("--as",
                   options->name,
                   "Name of the table on the controller; default: that of the material")
      ->type_name("NAME");
  mark_file(command->add_option("--out", options->out, "File of the lines")
                ->required()
                ->type_name("FILE"),
            FileRole::kOutput);
  command->add_flag("--bytes", options->bytes, "Write the bytes of the image instead of lines");
  command->callback([options] { write_image_file(*options); });
}

}  // namespace

void add_kerf_output_commands(CLI::App& kerf) {
  add_plot_command(kerf);
  add_calibrate_command(kerf);
  add_image_command(kerf);
}

}  // namespace sim
