#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/kerf_commands.hpp"
#include "host-sim/cli/kerf_options.hpp"
#include "host-sim/cut/offered_settings.hpp"
#include "host-sim/import/clb_reader.hpp"
#include "host-sim/report/printable.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/input_file.hpp"

namespace sim {
namespace {

struct LibraryOptions {
  std::string file;
  std::string data_base;
  std::string laser;
  std::string date;
};

using OperationsByMaterial = std::map<std::string, std::vector<OperationRecord>>;

/// Returns the day on which a file was last changed, in UTC; today for standard input.
std::string day_of(const std::string& file) {
  using Days = std::chrono::days;
  auto time = std::chrono::system_clock::now();
  std::error_code failed;
  const auto changed = std::filesystem::last_write_time(file, failed);
  if (!failed) {
    time = std::chrono::time_point_cast<std::chrono::system_clock::duration>(
        std::chrono::file_clock::to_sys(changed));
  }
  const std::chrono::year_month_day day{std::chrono::floor<Days>(time)};
  return fmt::format("{:04}-{:02}-{:02}",
                     static_cast<int>(day.year()),
                     static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

/// Returns an entry of the library as an operation; empty for a mode other than Cut and Scan.
std::optional<OperationRecord> operation_of(const drawing::LibraryEntry& entry,
                                            const LibraryOptions& options,
                                            const Origin& origin) {
  const drawing::OfferedSettings& settings = entry.settings;
  const bool is_cut = settings.kind == "Cut";
  if (!is_cut && settings.kind != "Scan") return std::nullopt;
  OperationRecord operation{.kind = is_cut ? "cut" : "fill",
                            .description = entry.description,
                            .laser = options.laser,
                            .origin = origin};
  if (entry.thickness_mm) operation.thickness_um = to_thousandths(*entry.thickness_mm);
  if (operation.thickness_um == 0U) operation.thickness_um.reset();
  constexpr double kFull = 100.0;
  if (settings.power_share.value_or(0.0) > 0.0) {
    operation.power_percent = kFull * *settings.power_share;
  }
  constexpr double kMaxSpeed = from_thousandths(cnc::kerf::kMaxSpeedUmMin);
  constexpr double kSecondsPerMinute = 60.0;
  const double speed = kSecondsPerMinute * settings.speed_mm_s.value_or(0.0);
  if (speed >= from_thousandths(cnc::kerf::kMinSpeedUmMin) && speed <= kMaxSpeed) {
    operation.speed_um_min = to_thousandths(speed);
  }
  if (settings.passes) operation.passes = static_cast<std::uint32_t>(*settings.passes);
  if (!is_cut) operation.interval_mm = settings.interval_mm;
  return operation;
}

void print_left_out(const LibraryOptions& options,
                    const drawing::LibraryEntry& entry,
                    const std::string& reason) {
  terminal::print(stderr,
                  "note: {}:{}:{}: {} \"{}\": {}\n",
                  name_of_input(options.file),
                  entry.line,
                  entry.column,
                  entry.material,
                  entry.description,
                  reason);
}

/// Returns the operations of a library, and prints the entries that cannot be used.
OperationsByMaterial operations_of(const drawing::MaterialLibrary& library,
                                   const LibraryOptions& options,
                                   const Origin& origin) {
  OperationsByMaterial found;
  for (const std::string& note : library.notes) terminal::print(stderr, "note: {}\n", note);
  for (const drawing::LibraryEntry& entry : library.entries) {
    const auto operation = operation_of(entry, options, origin);
    if (!operation) {
      print_left_out(options,
                     entry,
                     fmt::format("the mode {:.40} is neither Cut nor Scan; the entry is left out",
                                 printable_line(entry.settings.kind)));
      continue;
    }
    if (!operation->power_percent || !operation->speed_um_min) {
      print_left_out(options, entry, text_of(*operation) + "; give it with --power and --feed");
    }
    found[entry.material].push_back(*operation);
  }
  return found;
}

void import_library(const LibraryOptions& options) {
  const drawing::MaterialLibrary library =
      drawing::read_clb(read_text(options.file), name_of_input(options.file));
  const std::string name = std::filesystem::path{name_of_input(options.file)}.filename().string();
  const Origin origin{.on = options.date.empty() ? day_of(options.file) : options.date,
                      .source = "LightBurn library " + printable_line(name)};
  const OperationsByMaterial found = operations_of(library, options, origin);
  if (found.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: no entry is for cutting or filling", name_of_input(options.file)));
  }
  KnowledgeBase base{options.data_base, SqlFile::Mode::kCreate};
  std::size_t count = 0;
  for (const auto& [material, operations] : found) {
    base.save_operations(material, operations);
    count += operations.size();
  }
  terminal::print(
      "{}: {} settings of {} materials; {}. Kerfs are not known: `kerfline cut` requires "
      "--kerf, or `kerfline kerf test-grid` measures them\n",
      name_of_input(options.file),
      count,
      found.size(),
      text_of(origin));
}

}  // namespace

void add_kerf_import_command(CLI::App& kerf) {
  CLI::App* command = kerf.add_subcommand(
      "import",
      "Import the settings of a LightBurn library of materials (.clb) into a data base, marked as "
      "not\nmeasured here. They replace the settings of an earlier import of the same file.");
  command->footer(
      "Example:\n"
      "  kerfline kerf import shop.clb --db my.db\n"
      "  kerfline cut box.svg --db my.db --material Birch --thickness 3 --kerf 0.15 -o box.nc");
  const auto options = std::make_shared<LibraryOptions>();
  mark_file(
      command->add_option("FILE.clb", options->file, "Library of materials; - is standard input")
          ->required(),
      FileRole::kInput);
  mark_file(command
                ->add_option("--db",
                             options->data_base,
                             "Data base of kerf records; it is created if it does not exist")
                ->required()
                ->type_name("FILE"),
            FileRole::kKept);
  command->add_option("--laser", options->laser, "Name of the laser of these settings")
      ->type_name("NAME");
  command
      ->add_option(
          "--on", options->date, "Day of the library; default: the last change of the file")
      ->check(day_of_calendar())
      ->type_name("YYYY-MM-DD");
  command->callback([options] { import_library(*options); });
}

}  // namespace sim
