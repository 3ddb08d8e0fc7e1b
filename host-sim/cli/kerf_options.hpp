#pragma once

#include <optional>
#include <string>

#include "host-sim/knowledge/fit.hpp"
#include "host-sim/knowledge/knowledge_base.hpp"

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace sim {

/// Options that name the kerf record; all commands of `kerfline kerf` share them.
struct RecordOptions {
  std::string data_base;
  std::string material;
  std::string unit;

  void add_to(CLI::App& command);
  /// Opens the data base, or returns the shipped records if no data base is named. With kRead the
  /// data base stays unchanged.
  [[nodiscard]] KnowledgeBase open(SqlFile::Mode mode = SqlFile::Mode::kRead) const;
  [[nodiscard]] std::optional<cnc::kerf::HeatUnit> heat_unit() const;
  [[nodiscard]] MaterialRecord record() const { return open().record_of(material, heat_unit()); }
  /// Returns all records of the data base.
  [[nodiscard]] std::vector<MaterialRecord> records() const { return open().records(); }
};

/// Person who measured, and day of the measurement.
struct PersonOptions {
  std::string by{};  ///< Name of the person; empty if not named.
  std::string on{};  ///< Day of the measurement, YYYY-MM-DD; empty if not given.

  /// Adds `--by` and `--on`.
  void add_to(CLI::App& command);
};

/// Data base and laser of test cuts: options of `add`, and of `calibrate` with measured slots.
struct CutOptions {
  std::string data_base;
  AcceptanceLimits limits;
  std::string laser{};  ///< Laser of cuts whose file does not name it.
  PersonOptions person{};
  /// Whether the command also fits a record to the cuts, for which it must know their laser.
  bool asks_for_laser = false;

  void add_to(CLI::App& command);
};

/// Reads, judges and adds a file of cuts, and prints the rejected cuts with the reasons. Throws as
/// read_experiments() and KnowledgeBase do.
[[nodiscard]] std::vector<Experiment> add_cuts(const std::string& file, const CutOptions& options);

/// Adds `--unit`, whose value is `printed` or `J/mm`.
void add_unit_option(CLI::App& command, std::string& unit);
[[nodiscard]] std::optional<cnc::kerf::HeatUnit> unit_of(const std::string& option);

/// Returns a check that an option's value is a day of the calendar, YYYY-MM-DD.
[[nodiscard]] CLI::Validator day_of_calendar();

/// Returns the option's value in thousandths. Throws std::invalid_argument naming the option, with
/// range and unit, if the value is not a number, negative, or more than `most`.
[[nodiscard]] std::uint32_t thousandths_of(const char* option,
                                           double value,
                                           double most,
                                           const char* unit);
/// Return checks for options whose value is a thickness, a power or a speed. Their messages name
/// range and unit.
[[nodiscard]] CLI::Validator thickness_range();
[[nodiscard]] CLI::Validator power_range();
[[nodiscard]] CLI::Validator speed_range();

[[nodiscard]] std::uint32_t thickness_option(double mm);
[[nodiscard]] std::uint32_t power_option(double watts);
[[nodiscard]] std::uint32_t speed_option(double mm_min);

/// Prints a record: the laws with their accuracy, and the permissible region.
void print_record(const MaterialRecord& record);

}  // namespace sim
