#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

#include "firmware/machine/settings.hpp"
#include "host-sim/cli/cut_place_options.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cli/kerf_commands.hpp"
#include "host-sim/cli/kerf_options.hpp"
#include "host-sim/cli/machine_option.hpp"
#include "host-sim/cli/post_option.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/knowledge/test_grid.hpp"
#include "host-sim/knowledge/test_grid_form.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

constexpr std::size_t kMaxGridSteps = 10;
constexpr double kMinGridPercent = 0.1;
constexpr double kFullPercent = 100.0;
constexpr double kGreatestGridFeed = from_thousandths(cnc::kerf::kMaxSpeedUmMin);

struct TestGridOptions {
  TestGrid grid{};
  std::string powers;
  std::string feeds;
  std::size_t power_steps = 5;
  std::size_t feed_steps = 5;
  std::string kind = "cut";
  std::optional<double> slot_power;
  std::optional<double> slot_feed;
  CutPlaceOptions place;
  bool constant_power = false;
  std::string air = "on";
  PostOption post;
  std::string program;
  std::string form;
  std::string measured;
  std::string data_base;
  PersonOptions person;
};

/// Option whose value is a range, `LOW:HIGH`, or one number, and the bounds of both.
struct GridRange {
  const char* option;
  double least;
  double most;
  const char* unit;
};

/// Returns the `steps` values of a range in a text. Throws std::invalid_argument naming the
/// permitted range.
std::vector<double> values_in(const GridRange& range, const std::string& text, std::size_t steps) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const auto read = [&](std::string_view word) {
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, value);
    const bool is_number = result.ec == std::errc{} && result.ptr == end && std::isfinite(value);
    if (is_number && value >= range.least && value <= range.most) return value;
    throw std::invalid_argument(
        fmt::format("{} {}: must be LOW:HIGH or one number, {:g} to {:g} {}",
                    range.option,
                    text,
                    range.least,
                    range.most,
                    range.unit));
  };
  const std::string_view words{text};
  const double low = read(words.substr(0, colon));
  const double high = colon == text.size() ? low : read(words.substr(colon + 1));
  if (low > high) {
    throw std::invalid_argument(
        fmt::format("{} {}: must have the lower number first", range.option, text));
  }
  if (low == high) return {low};
  if (steps < 2) {
    throw std::invalid_argument(
        fmt::format("{} {}: a range requires at least 2 steps", range.option, text));
  }
  return steps_between(low, high, steps);
}

double greatest_s_of(const cut::MachineProfile& machine) {
  double greatest = 1000.0;
  for (const SettingChange& change : machine.settings) {
    if (change.number == cnc::setting::kMaxSpindleSpeed) {
      greatest = static_cast<double>(change.value);
    }
  }
  return greatest;
}

/// Checks the feeds. Throws std::invalid_argument if a feed exceeds the machine's rate.
void expect_reachable(const TestGrid& grid, const cut::MachineProfile& machine) {
  for (const SettingChange& change : machine.settings) {
    if (change.number != cnc::setting::kRate) continue;
    const auto most = static_cast<double>(change.value);
    if (grid.feeds_mm_min.back() <= most) continue;
    throw std::invalid_argument(
        fmt::format("--feed: {:g} mm/min exceeds the greatest feed of {}, {:g} mm/min",
                    grid.feeds_mm_min.back(),
                    machine.name,
                    most));
  }
}

/// Returns the position of the grid. Throws std::invalid_argument if it leaves the bed.
drawing::Place place_of(const TestGridOptions& options,
                        const drawing::Place& size,
                        const std::optional<cut::MachineProfile>& machine) {
  CutPlaceOptions place = options.place;
  if (place.place.empty()) place.place = "corner";
  const cut::PlaceWishes wishes = place_wishes_of(place);
  drawing::Place at = lower_left(wishes, size, machine ? &*machine : nullptr) + wishes.move_mm;
  if (machine) at -= machine->beam_offset_mm;
  const drawing::Place far = at + size;
  const cut::BedBox bed = machine ? machine->bed() : cut::BedBox{{0.0, 0.0}, {1.0e6, 1.0e6}};
  constexpr double kSlackMm = 1.0e-6;
  const double beyond = std::max(
      {bed.low.x() - at.x(), bed.low.y() - at.y(), far.x() - bed.high.x(), far.y() - bed.high.y()});
  if (beyond <= kSlackMm) return at;
  throw std::invalid_argument(
      fmt::format("the grid is {:.1f} x {:.1f} mm and leaves {} by {:.3f} mm; take fewer steps, "
                  "smaller cells, or another --place",
                  size.x(),
                  size.y(),
                  machine ? "the bed of " + machine->name : "the quadrant of X0 Y0",
                  beyond));
}

/// Sets the values of the grid that the options give as text, such as ranges.
void complete(TestGridOptions& options) {
  TestGrid& grid = options.grid;
  if (options.powers.empty() || options.feeds.empty()) {
    throw std::invalid_argument(
        "--power and --feed are missing; give both, such as --power 20:80 --feed "
        "300:1500; or --measured reads a form");
  }
  grid.powers_percent = values_in(
      {"--power", kMinGridPercent, kFullPercent, "percent"}, options.powers, options.power_steps);
  grid.feeds_mm_min =
      values_in({"--feed", 1.0, kGreatestGridFeed, "mm/min"}, options.feeds, options.feed_steps);
  grid.is_filled = options.kind == "fill";
  if (grid.is_filled) {
    grid.slots_mm.clear();
  } else if (grid.slots_mm.empty()) {
    grid.slots_mm = {5.0, 10.0, 15.0};
  }
  grid.slots = {options.slot_power.value_or(grid.powers_percent.back()),
                options.slot_feed.value_or(grid.feeds_mm_min.front())};
}

void write_grid(const CLI::App& command, TestGridOptions& options) {
  complete(options);
  if (options.grid.material.empty()) throw std::invalid_argument("--material is missing");
  if (!options.grid.is_filled && options.grid.thickness_mm <= 0.0) {
    throw std::invalid_argument("--thickness is missing; cut squares require it, mm");
  }
  if (options.program.empty() && options.form.empty()) {
    throw std::invalid_argument("--out, --form or --measured is missing");
  }
  const auto machine = machine_profile_of(options.place.machine);
  if (machine) expect_reachable(options.grid, *machine);
  InputFiles inputs{options.program};
  unsigned decimals = 3;
  options.post.read(command, inputs, decimals);
  GridProgram program{.full_power_s = machine ? greatest_s_of(*machine) : 1000.0,
                      .follows_speed = !options.constant_power,
                      .air = options.air == "M7" ? "M7" : "M8"};
  if (options.air == "off") program.air.clear();
  const drawing::Place size = size_of(options.grid);
  program.at_mm = place_of(options, size, machine);
  const TestGrid& grid = options.grid;
  const std::size_t squares = grid.powers_percent.size() * grid.feeds_mm_min.size();
  const std::string about =
      fmt::format("{} squares of {:g} mm, {:g} to {:g} percent, {:g} to {:g} mm/min, {}",
                  squares,
                  grid.cell_mm,
                  grid.powers_percent.front(),
                  grid.powers_percent.back(),
                  grid.feeds_mm_min.front(),
                  grid.feeds_mm_min.back(),
                  grid.passes == 1 ? "1 pass" : fmt::format("{} passes", grid.passes));
  std::vector<std::string> heading{fmt::format("kerfline kerf test-grid: {}", grid.material),
                                   about,
                                   "none of its values is measured"};
  if (grid.thickness_mm > 0.0) heading[0] += fmt::format(", {:g} mm", grid.thickness_mm);
  if (!options.program.empty()) {
    write_file(options.program, options.post.applied_to(program_of(grid, program, heading)));
  }
  if (!options.form.empty()) write_file(options.form, form_of(grid));
  terminal::print("{}: {}; X{:.3f} Y{:.3f} to X{:.3f} Y{:.3f}\n",
                  options.program.empty() ? options.form : options.program,
                  about,
                  program.at_mm.x(),
                  program.at_mm.y(),
                  program.at_mm.x() + size.x(),
                  program.at_mm.y() + size.y());
  if (machine && !machine->note.empty()) {
    terminal::print(stderr, "kerfline: warning: {}: {}\n", machine->name, machine->note);
  }
}

void take_form(const TestGridOptions& options) {
  if (options.data_base.empty()) throw std::invalid_argument("--db is missing");
  if (!options.program.empty() || !options.form.empty()) {
    throw std::invalid_argument(
        "--measured reads a form, but --out and --form write one; leave --measured or these out");
  }
  const MeasuredGrid found = read_form(read_text(options.measured),
                                       name_of_input(options.measured),
                                       {options.person.by, options.person.on});
  KnowledgeBase base{options.data_base, SqlFile::Mode::kCreate};
  base.save_operations(found.material, found.operations);
  for (const std::string& note : found.notes) terminal::print(stderr, "note: {}\n", note);
  terminal::print("{}: {} settings of {}; {}\n",
                  name_of_input(options.measured),
                  found.operations.size(),
                  found.material,
                  text_of(found.operations.front().origin));
}

void add_slot_options(CLI::App& command, TestGridOptions& options) {
  command
      .add_option(
          "--slots", options.grid.slots_mm, "Widths of the slots' paths, mm; default: 5,10,15")
      ->delimiter(',')
      ->expected(1, 10)
      ->check(in_range(1.0, 100.0, "mm"));
  command
      .add_option("--slot-power",
                  options.slot_power,
                  "Power of the slots, percent; default: the greatest of --power")
      ->check(in_range(kMinGridPercent, kFullPercent, "percent"));
  command
      .add_option("--slot-feed",
                  options.slot_feed,
                  "Feed of the slots, mm/min; default: the least of --feed")
      ->check(in_range(1.0, kGreatestGridFeed, "mm/min"));
}

void add_grid_options(CLI::App& command, TestGridOptions& options) {
  TestGrid& grid = options.grid;
  command.add_option("--material", grid.material, "Name of the material in the form")
      ->type_name("NAME");
  command.add_option("--thickness", grid.thickness_mm, "Thickness of the material, mm")
      ->check(thickness_range());
  command.add_option("--laser", grid.laser, "Name of the laser in the form")->type_name("NAME");
  command.add_option("--power", options.powers, "Powers of the columns, percent of full power")
      ->type_name("LOW:HIGH");
  command.add_option("--feed", options.feeds, "Feeds of the rows, mm/min")->type_name("LOW:HIGH");
  const auto steps = [&](const char* name, std::size_t& value, const char* help) {
    command.add_option(name, value, help)
        ->check(in_whole_range(1, kMaxGridSteps))
        ->capture_default_str();
  };
  steps("--power-steps", options.power_steps, "Number of columns");
  steps("--feed-steps", options.feed_steps, "Number of rows");
  command.add_option("--kind", options.kind, "Kind of the squares: cut, or filled with lines")
      ->check(CLI::IsMember({"cut", "fill"}))
      ->capture_default_str();
  command.add_option("--passes", grid.passes, "Number of passes over each square and slot")
      ->check(in_whole_range(1, 100))
      ->capture_default_str();
  const auto length =
      [&](const char* name, double& value, double least, double most, const char* help) {
        command.add_option(name, value, help)
            ->check(in_range(least, most, "mm"))
            ->capture_default_str();
      };
  length("--cell", grid.cell_mm, 1.0, 100.0, "Side of a square, mm");
  length("--gap", grid.gap_mm, 0.5, 100.0, "Distance between squares and between slots, mm");
  length(
      "--interval", grid.interval_mm, 0.01, 10.0, "Distance between lines of a filled square, mm");
  length(
      "--label-height", grid.label_mm, 1.0, 20.0, "Height of the numbers where space permits, mm");
  command.add_option("--label-power", grid.labels.power_percent, "Power of the numbers, percent")
      ->check(in_range(kMinGridPercent, kFullPercent, "percent"))
      ->capture_default_str();
  command.add_option("--label-feed", grid.labels.feed_mm_min, "Feed of the numbers, mm/min")
      ->check(in_range(1.0, kGreatestGridFeed, "mm/min"))
      ->capture_default_str();
  add_slot_options(command, options);
  command.add_flag("--constant-power",
                   options.constant_power,
                   "Use M3 instead of M4: power does not follow the speed");
  command.add_option("--air", options.air, "Air assist: on or M8, M7, off")
      ->check(CLI::IsMember({"on", "M7", "M8", "off"}))
      ->capture_default_str();
}

}  // namespace

void add_kerf_test_grid_command(CLI::App& kerf) {
  CLI::App* command = kerf.add_subcommand(
      "test-grid",
      "Write a grid of squares, power by column and feed by row, with numbers and slots for a\n"
      "caliper (--out), and a form for its results (--form); or read the form (--measured).");
  command->footer(
      "Examples:\n"
      "  kerfline kerf test-grid --material birch --thickness 3 --power 20:80 --feed 300:1500 "
      "--machine k40 --out grid.nc --form grid.json\n"
      "  kerfline kerf test-grid --measured grid.json --db my.db\n"
      "\n"
      "In the form, the result of a square is good or bad, the width of a slot is that of the "
      "hole,\n"
      "measured_by is the person who measured, and measured_on is the day.");
  const auto options = std::make_shared<TestGridOptions>();
  add_grid_options(*command, *options);
  add_machine_options(*command, options->place);
  options->post.add_to(*command);
  const auto add_file = [&](FileRole role, const char* name, std::string& file, const char* help) {
    mark_file(command->add_option(name, file, help)->type_name("FILE"), role);
  };
  add_file(FileRole::kOutput, "--out", options->program, "Write the grid's G-code");
  add_file(FileRole::kOutput, "--form", options->form, "Write the form as JSON");
  add_file(FileRole::kInput, "--measured", options->measured, "Read the form with the results");
  add_file(FileRole::kKept,
           "--db",
           options->data_base,
           "Data base of kerf records; it is created if it does not exist");
  options->person.add_to(*command);
  command->callback([command, options] {
    if (options->measured.empty()) {
      write_grid(*command, *options);
    } else {
      take_form(*options);
    }
  });
}

}  // namespace sim
