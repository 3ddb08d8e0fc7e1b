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

/// Test cuts, accepted and rejected, and the records fitted to them. They are in one SQLite file,
/// whose tables README.md in this folder describes. A new file holds the shipped records. Every
/// member throws std::runtime_error naming the file when SQLite fails.
class KnowledgeBase {
 public:
  /// Opens the file. Also throws if the file is no such data base, is empty, or has an unknown
  /// version. Throws, too, if the file does not exist and `mode` does not create it. With kRead the
  /// file stays unchanged.
  KnowledgeBase(const std::string& file, SqlFile::Mode mode);

  /// Returns a data base with only the shipped records.
  [[nodiscard]] static KnowledgeBase shipped() { return {":memory:", SqlFile::Mode::kCreate}; }

  /// Adds all cuts of a file, or none of them. Throws std::invalid_argument if a file with the same
  /// bytes was added before, because duplicate cuts would make the record seem too certain.
  void add(const std::vector<Experiment>& cuts, const std::string& file, std::string_view text);

  /// Returns the cuts of a material in the order in which they were added.
  [[nodiscard]] std::vector<Experiment> cuts_of(std::string_view material) const;

  /// Saves a record. It replaces the record with the same name and unit; the operations remain.
  void save(const MaterialRecord& record);

  /// Adds operations of a material. If the material has no record, adds one without a kerf, too.
  /// Operations that were not measured here replace all operations from the same source. Measured
  /// operations replace measured ones of the same kind, laser and thickness.
  /// @pre all operations have the same origin
  void save_operations(const std::string& material, const std::vector<OperationRecord>& operations);

  /// Returns the records in the order in which they were first saved.
  [[nodiscard]] std::vector<MaterialRecord> records() const;

  /// Returns the record of a material: if a unit is given, the record with this unit, otherwise the
  /// first record. Throws std::invalid_argument with the existing names if there is no such record.
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

  bool is_new_;  ///< Whether the file did not exist before.
  SqlFile file_;
  /// Whether the tables have columns for origins, which version 1 lacks.
  bool knows_origins_ = true;
};

}  // namespace sim
