#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <stdexcept>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/kerf_commands.hpp"
#include "host-sim/cli/kerf_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/knowledge/experiment_csv.hpp"
#include "host-sim/knowledge/shipped_records.hpp"
#include "host-sim/report/terminal.hpp"

namespace sim {
namespace {

struct AddOptions {
  std::vector<std::string> files;
  CutOptions cuts;
};

struct FitCommandOptions {
  RecordOptions record;
  FitOptions fit;
  std::string laser;
  double gas_pressure_mpa = -1.0;  ///< Gas pressure of the cuts, MPa; negative for any pressure.
};

struct AdviseOptions {
  RecordOptions record;
  double thickness_mm = 0.0;
  std::optional<double> power_w;
  std::optional<double> speed_mm_min;
};

void add_add_command(CLI::App& kerf, ExitStatus&) {
  CLI::App* command = kerf.add_subcommand(
      "add",
      fmt::format(
          "Judge test cuts and keep all of them, rejected ones too.\nThe header of a file: {}",
          kExperimentHeader));
  command->footer(
      "Example:\n"
      "  kerfline kerf add cuts.csv --db my.db --laser 'K40 tube'");
  const auto options = std::make_shared<AddOptions>();
  mark_file(command->add_option("CUTS.csv", options->files, "Files of test cuts")->required(),
            FileRole::kInput);
  options->cuts.add_to(*command);
  command->callback([options] {
    for (const std::string& file : options->files) {
      static_cast<void>(add_cuts(file, options->cuts));
    }
  });
}

void fit(const FitCommandOptions& options) {
  KnowledgeBase base = options.record.open(SqlFile::Mode::kWrite);
  std::vector<Experiment> cuts = base.cuts_of(options.record.material);
  std::erase_if(cuts, [&options](const Experiment& cut) {
    const bool other_laser = !options.laser.empty() && cut.laser != options.laser;
    const bool other_gas =
        options.gas_pressure_mpa >= 0.0 && cut.gas_pressure_mpa != options.gas_pressure_mpa;
    return other_laser || other_gas;
  });
  if (cuts.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: no test cuts of `{}`; `kerfline kerf add` adds them",
                    options.record.data_base,
                    options.record.material));
  }
  FitOptions fitting = options.fit;
  fitting.unit = options.record.heat_unit().value_or(fitting.unit);
  const MaterialRecord record = fit_record(cuts, fitting);
  base.save(record);
  print_record(record);
}

void add_fit_command(CLI::App& kerf, ExitStatus&) {
  CLI::App* command =
      kerf.add_subcommand("fit",
                          "Fit kerf = l1 Q + l2 per thickness to the accepted cuts of a material, "
                          "with its permissible\n"
                          "region. It replaces the record with the same name and unit.");
  command->footer(
      "Example:\n"
      "  kerfline kerf fit --db my.db --material acrylic --unit J/mm");
  const auto options = std::make_shared<FitCommandOptions>();
  options->record.add_to(*command);
  command->get_option("--db")->required();
  command->get_option("--material")->required();
  command->add_option("--laser", options->laser, "Laser whose cuts are fitted")->type_name("NAME");
  command
      ->add_option(
          "--gas", options->gas_pressure_mpa, "Gas pressure of the cuts that are fitted, MPa")
      ->check(in_range(0.0, 10.0, "MPa"));
  LawCriterion& criterion = options->fit.criterion;
  command
      ->add_option(
          "--law-close",
          criterion.close_mm,
          "Greatest distance of a mean of cuts from the law for the law to be accepted, mm")
      ->check(in_range(0.0, 10.0, "mm"))
      ->capture_default_str();
  command
      ->add_option("--law-correlation",
                   criterion.min_correlation,
                   "Least correlation with which a law is also accepted, if no mean is farther "
                   "from it than --law-far")
      ->check(in_range(0.0, 1.0, ""))
      ->capture_default_str();
  command
      ->add_option(
          "--law-far",
          criterion.far_mm,
          "Greatest distance of a mean of cuts from a law that is accepted by its correlation, mm")
      ->check(in_range(0.0, 10.0, "mm"))
      ->capture_default_str();
  command->callback([options] { fit(*options); });
}

void show(const RecordOptions& options, bool with_cuts) {
  const KnowledgeBase base = options.open();
  if (options.material.empty()) {
    for (const MaterialRecord& record : base.records()) {
      terminal::print("{}, Q in {}: {}\n", record.name, name_of(record.unit), record.provenance);
    }
    return;
  }
  const std::vector<Experiment> cuts = base.cuts_of(options.material);
  for (const Experiment& cut : with_cuts ? cuts : std::vector<Experiment>{}) {
    terminal::print("{}:{}: {:g} mm {:g} W {:g} mm/min: kerf {:.4f} mm{}\n",
                    cut.file,
                    cut.line,
                    from_thousandths(cut.condition.thickness_um),
                    from_thousandths(cut.condition.power_mw),
                    from_thousandths(cut.condition.speed_um_min),
                    cut.kerf_mm(),
                    cut.accepted() ? "" : ", rejected: " + cut.rejection);
  }
  if (with_cuts) return;
  print_record(base.record_of(options.material, options.heat_unit()));
}

void add_show_command(CLI::App& kerf, ExitStatus&) {
  CLI::App* command = kerf.add_subcommand(
      "show",
      "Print a record: laws, residuals, permissible region; without --material, the names of all.");
  command->footer(
      "Examples:\n"
      "  kerfline kerf show\n"
      "  kerfline kerf show --material 'CSP 1N'\n"
      "  kerfline kerf show --db my.db --material acrylic --cuts");
  const auto options = std::make_shared<RecordOptions>();
  const auto with_cuts = std::make_shared<bool>(false);
  options->add_to(*command);
  command->add_flag(
      "--cuts", *with_cuts, "Print the test cuts instead, with the reasons of rejections");
  command->callback([options, with_cuts] { show(*options, *with_cuts); });
}

/// Prints the speeds that each power permits at a thickness. If a speed is given, prints only the
/// powers that permit this speed, with the kerf. Returns false if there are none.
bool print_region(const MaterialRecord& record,
                  std::uint32_t thickness_um,
                  std::optional<std::uint32_t> speed_um_min) {
  const OwnedKerfTable<double> table = table_of<double>(record);
  bool any = false;
  std::vector<std::uint32_t> powers;
  for (const cnc::kerf::Band& band : table.bands) powers.push_back(band.power_mw);
  std::sort(powers.begin(), powers.end());
  powers.erase(std::unique(powers.begin(), powers.end()), powers.end());
  for (const std::uint32_t power : powers) {
    const auto speeds = cnc::kerf::permissible_speeds(table.view(), thickness_um, power);
    if (!speeds.ok() || (speed_um_min && !speeds.value().holds(*speed_um_min))) continue;
    any = true;
    terminal::print("  permissible: {:g} W, {:g} to {:g} mm/min",
                    from_thousandths(power),
                    from_thousandths(speeds.value().least),
                    from_thousandths(speeds.value().most));
    if (speed_um_min) {
      const auto found = predict(record, {thickness_um, power, *speed_um_min});
      terminal::print(
          ": kerf {:.6f} mm +/- {:.3f} mm", found.value().kerf_mm, found.value().half_interval_mm);
    }
    terminal::print("\n");
  }
  return any;
}

ExitStatus refuse(const std::string& reason) {
  terminal::print(stderr, "kerfline: {}\n", reason);
  return ExitStatus::kFaults;
}

ExitStatus advise_on_cut(const MaterialRecord& record, const cnc::kerf::Condition& condition) {
  const auto found = predict(record, condition);
  if (!found.ok()) return refuse(describe(found.error(), condition));
  terminal::print(
      "  Q = {:.6g} {}\n  kerf {:.6f} mm, 95 % of cuts within +/- {:.3f} mm; offset {:.6f} mm\n",
      found.value().heat,
      name_of(record.unit),
      found.value().kerf_mm,
      found.value().half_interval_mm,
      0.5 * found.value().kerf_mm);
  return ExitStatus::kFine;
}

ExitStatus advise(const AdviseOptions& options) {
  const MaterialRecord record = options.record.record();
  if (!record.has_kerf()) {
    return refuse(fmt::format("{}: no kerf is known; `kerfline kerf show` has its settings, {}",
                              record.name,
                              record.provenance));
  }
  cnc::kerf::Condition condition{thickness_option(options.thickness_mm), 0, 0};
  if (options.power_w) condition.power_mw = power_option(*options.power_w);
  if (options.speed_mm_min) condition.speed_um_min = speed_option(*options.speed_mm_min);
  terminal::print("{}, {:g} mm; {}; {}{}\n",
                  record.name,
                  from_thousandths(condition.thickness_um),
                  record.laser.empty() ? "no laser named" : record.laser,
                  record.calibrated ? "" : "not calibrated on this machine; ",
                  record.provenance);
  const OwnedKerfTable<double> table = table_of<double>(record);
  const auto powers = cnc::kerf::permissible_powers(table.view(), condition.thickness_um);
  if (!powers.ok()) return refuse(describe(powers.error(), condition));
  if (!options.power_w) {
    std::optional<std::uint32_t> speed;
    if (options.speed_mm_min) speed = condition.speed_um_min;
    if (print_region(record, condition.thickness_um, speed)) return ExitStatus::kFine;
    print_region(record, condition.thickness_um, std::nullopt);
    return refuse("no power is permissible at this speed");
  }
  const auto speeds =
      cnc::kerf::permissible_speeds(table.view(), condition.thickness_um, condition.power_mw);
  if (!speeds.ok()) return refuse(describe(speeds.error(), condition));
  terminal::print("  permissible at {:g} W: {:g} to {:g} mm/min\n",
                  from_thousandths(condition.power_mw),
                  from_thousandths(speeds.value().least),
                  from_thousandths(speeds.value().most));
  return options.speed_mm_min ? advise_on_cut(record, condition) : ExitStatus::kFine;
}

void add_advise_command(CLI::App& kerf, ExitStatus& status) {
  CLI::App* command = kerf.add_subcommand("advise",
                                          "Print the permissible powers and speeds and the kerf; "
                                          "exit status 1 for a cut that is refused.");
  command->footer(
      "Examples:\n"
      "  kerfline kerf advise --material 'CSP 1N' --thickness 2\n"
      "  kerfline kerf advise --material 'CSP 1N' --thickness 2 --power 1800 --speed 4000");
  const auto options = std::make_shared<AdviseOptions>();
  options->record.add_to(*command);
  command->get_option("--material")->required();
  command->add_option("--thickness", options->thickness_mm, "Thickness of the material, mm")
      ->required()
      ->check(thickness_range())
      ->type_name("T");
  command->add_option("--power", options->power_w, "Power of the beam, W")
      ->check(power_range())
      ->type_name("P");
  command->add_option("--speed", options->speed_mm_min, "Speed of the cut, mm/min")
      ->check(speed_range())
      ->type_name("V");
  command->callback([options, &status] { status = advise(*options); });
}

}  // namespace

void add_kerf_command(CLI::App& app, ExitStatus& status) {
  CLI::App* kerf =
      app.add_subcommand("kerf",
                         "Measure and predict the kerf: test cuts, laws fitted to them, "
                         "figures, tables for the controller.");
  kerf->require_subcommand(1);
  kerf->footer(
      "Examples:\n"
      "  kerfline kerf show\n"
      "  kerfline kerf advise --material 'CSP 1N' --thickness 2 --power 1800 --speed 4000\n"
      "  kerfline kerf calibrate --material acrylic --thickness 3 --full-power 60 --laser mine\\\n"
      "      --powers 30,45,60 --speeds 400,600,800 --out coupon.nc --form slots.csv\n"
      "  kerfline kerf calibrate --measured slots.csv --db my.db --unit J/mm");
  add_add_command(*kerf, status);
  add_fit_command(*kerf, status);
  add_show_command(*kerf, status);
  add_advise_command(*kerf, status);
  add_kerf_import_command(*kerf);
  add_kerf_test_grid_command(*kerf);
  add_kerf_output_commands(*kerf);
}

}  // namespace sim
