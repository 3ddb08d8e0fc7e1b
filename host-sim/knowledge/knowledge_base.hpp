#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/knowledge/material_record.hpp"
#include "host-sim/knowledge/sqlite.hpp"

namespace sim {

/// Test cuts, accepted and rejected, and the records fitted to them: one SQLite file, whose tables
/// README.md beside this file describes. A new one holds the shipped records.
/// Every member throws std::runtime_error naming the file when SQLite fails.
class KnowledgeBase {
 public:
  /// Throws also when the file is no such data base, is empty, or one of another version, and
  /// unless `mode` creates it when there is none. With kRead nothing is ever written.
  KnowledgeBase(const std::string& file, SqlFile::Mode mode);

  /// The shipped records and nothing else.
  [[nodiscard]] static KnowledgeBase shipped() { return {":memory:", SqlFile::Mode::kCreate}; }

  /// Adds all cuts of a file or none. Throws std::invalid_argument when the same bytes
  /// were added before: cuts that count twice would look surer than they are.
  void add(const std::vector<Experiment>& cuts, const std::string& file, std::string_view text);

  /// In the order in which they were added.
  [[nodiscard]] std::vector<Experiment> cuts_of(std::string_view material) const;

  /// Takes the place of the record with the same name and unit; operations stay.
  void save(const MaterialRecord& record);

  /// Adds operations of a material, and a record without a kerf where it has none. Those that were
  /// not measured here take the place of others from the same source; measured ones that of others
  /// of the same kind, laser and thickness.
  /// @pre all have the same origin
  void save_operations(const std::string& material, const std::vector<OperationRecord>& operations);

  /// In the order in which they were first saved.
  [[nodiscard]] std::vector<MaterialRecord> records() const;

  /// The record of a material: that with the unit, else the first.
  /// Throws std::invalid_argument naming what there is when there is none.
  [[nodiscard]] MaterialRecord record_of(std::string_view material,
                                         std::optional<cnc::kerf::HeatUnit> unit) const;

 private:
  void insert(const MaterialRecord& record);
  void remove_like(const std::string& material, const OperationRecord& operation);
  void insert_operation(const std::string& material, const OperationRecord& operation);
  [[nodiscard]] std::vector<OperationRecord> operations_of(const std::string& material) const;
  void insert_thickness(std::int64_t record, const ThicknessRecord& row);
  [[nodiscard]] std::vector<ThicknessRecord> thicknesses_of(std::int64_t record) const;
  [[nodiscard]] std::vector<PowerRecord> powers_of(std::int64_t thickness) const;
  [[nodiscard]] std::vector<cnc::kerf::Point> points_of(std::int64_t power) const;
  void prepare_file(SqlFile::Mode mode);
  void create();
  void upgrade();

  bool is_new_;  ///< No file had the name before.
  SqlFile file_;
  bool knows_origins_ = true;  ///< Else the file is of version 1.
};

}  // namespace sim
