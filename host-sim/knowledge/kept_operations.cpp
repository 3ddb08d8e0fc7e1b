#include <optional>

#include "host-sim/knowledge/knowledge_base.hpp"

namespace sim {

void KnowledgeBase::save_operations(const std::string& material,
                                    const std::vector<OperationRecord>& operations) {
  SqlTransaction transaction{file_};
  for (const OperationRecord& operation : operations) {
    remove_like(material, operation);
    // All operations have the same origin. Therefore a single deletion removes all earlier
    // operations of this origin.
    if (!operation.origin.is_measured_here) break;
  }
  for (const OperationRecord& operation : operations) insert_operation(material, operation);
  SqlStatement record = file_.prepare("SELECT id FROM record WHERE material = ?");
  if (!record.bind(material).next()) insert({.name = material});
  transaction.commit();
}

void KnowledgeBase::remove_like(const std::string& material, const OperationRecord& operation) {
  if (!operation.origin.is_measured_here) {
    file_.prepare("DELETE FROM operation WHERE material = ? AND measured_here = 0 AND source = ?")
        .bind(material)
        .bind(operation.origin.source)
        .run();
    return;
  }
  file_
      .prepare(
          "DELETE FROM operation WHERE material = ? AND measured_here = 1 AND kind = ? AND "
          "laser = ? AND thickness_um IS ?")
      .bind(material)
      .bind(operation.kind)
      .bind(operation.laser)
      .bind_optional(operation.thickness_um)
      .run();
}

void KnowledgeBase::insert_operation(const std::string& material,
                                     const OperationRecord& operation) {
  file_
      .prepare(
          "INSERT INTO operation (material, kind, description, laser, thickness_um, "
          "power_percent, speed_um_min, passes, interval_mm, kerf_mm, measured_here, "
          "measured_by, measured_on, source) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(material)
      .bind(operation.kind)
      .bind(operation.description)
      .bind(operation.laser)
      .bind_optional(operation.thickness_um)
      .bind_optional(operation.power_percent)
      .bind_optional(operation.speed_um_min)
      .bind_optional(operation.passes)
      .bind_optional(operation.interval_mm)
      .bind_optional(operation.kerf_mm)
      .bind(operation.origin.is_measured_here ? 1U : 0U)
      .bind(operation.origin.by)
      .bind(operation.origin.on)
      .bind(operation.origin.source)
      .run();
}

std::vector<OperationRecord> KnowledgeBase::operations_of(const std::string& material) const {
  std::vector<OperationRecord> operations;
  if (!knows_origins_) return operations;
  SqlStatement rows = file_.prepare(
      "SELECT kind, description, laser, thickness_um, power_percent, speed_um_min, passes, "
      "interval_mm, kerf_mm, measured_here, measured_by, measured_on, source FROM operation "
      "WHERE material = ? ORDER BY thickness_um, id");
  rows.bind(material);
  const auto real = [&rows](int column) {
    return rows.is_null(column) ? std::nullopt : std::optional{rows.real(column)};
  };
  const auto small = [&rows](int column) {
    return rows.is_null(column) ? std::nullopt : std::optional{rows.small(column)};
  };
  while (rows.next()) {
    operations.push_back(
        {.kind = rows.text(0),
         .description = rows.text(1),
         .laser = rows.text(2),
         .thickness_um = small(3),
         .power_percent = real(4),
         .speed_um_min = small(5),
         .passes = small(6),
         .interval_mm = real(7),
         .kerf_mm = real(8),
         .origin = {rows.whole(9) != 0, rows.text(10), rows.text(11), rows.text(12)}});
  }
  return operations;
}

}  // namespace sim
