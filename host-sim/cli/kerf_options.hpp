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

/// Which record a command is about: options that all commands of `kerfline kerf` share.
struct RecordOptions {
  std::string data_base;
  std::string material;
  std::string unit;

  void add_to(CLI::App& command);
  /// The data base as it is, or the shipped records where none is named. Questions only read.
  [[nodiscard]] KnowledgeBase open(SqlFile::Mode mode = SqlFile::Mode::kRead) const;
  [[nodiscard]] std::optional<cnc::kerf::HeatUnit> heat_unit() const;
  [[nodiscard]] MaterialRecord record() const { return open().record_of(material, heat_unit()); }
  /// All records of the data base.
  [[nodiscard]] std::vector<MaterialRecord> records() const { return open().records(); }
};

/// The person who measured, and the day.
struct PersonOptions {
  std::string by{};  ///< Empty: not named.
  std::string on{};  ///< YYYY-MM-DD; empty: not said.

  /// Adds `--by` and `--on`.
  void add_to(CLI::App& command);
};

/// Where test cuts go: `add`, and `calibrate` with measured slots.
struct CutOptions {
  std::string data_base;
  AcceptanceLimits limits;
  std::string laser{};  ///< Of cuts whose file does not name it.
  PersonOptions person{};
  /// The cuts are to be fitted at once, so that it must be known whose they are.
  bool asks_for_laser = false;

  void add_to(CLI::App& command);
};

/// Reads, judges and adds a file of cuts, and prints what was rejected and why.
/// Throws as read_experiments() and KnowledgeBase do.
[[nodiscard]] std::vector<Experiment> add_cuts(const std::string& file, const CutOptions& options);

/// Adds `--unit`, as `printed` or `J/mm`.
void add_unit_option(CLI::App& command, std::string& unit);
[[nodiscard]] std::optional<cnc::kerf::HeatUnit> unit_of(const std::string& option);

/// A day of the calendar, YYYY-MM-DD, as a check of an option.
[[nodiscard]] CLI::Validator day_of_calendar();

/// The option's value in thousandths. Throws std::invalid_argument naming it, with range and unit,
/// when it is not a number, negative, or more than `most`.
[[nodiscard]] std::uint32_t thousandths_of(const char* option,
                                           double value,
                                           double most,
                                           const char* unit);
/// Checks of options with these values, for messages that name range and unit.
[[nodiscard]] CLI::Validator thickness_range();
[[nodiscard]] CLI::Validator power_range();
[[nodiscard]] CLI::Validator speed_range();

[[nodiscard]] std::uint32_t thickness_option(double mm);
[[nodiscard]] std::uint32_t power_option(double watts);
[[nodiscard]] std::uint32_t speed_option(double mm_min);

/// The whole record: laws, how good they are, and the permissible region.
void print_record(const MaterialRecord& record);

}  // namespace sim
