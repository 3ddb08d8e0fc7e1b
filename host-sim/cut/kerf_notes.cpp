#include "host-sim/cut/kerf_notes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <sstream>
#include <utility>

namespace sim::cut {
namespace {

/// Difference below which two kerfs count as equal, mm.
constexpr double kSameKerfMm = 0.001;

const char* unit_option(cnc::kerf::HeatUnit unit) {
  return unit == cnc::kerf::HeatUnit::kJoulesPerMillimetre ? "J/mm" : "printed";
}

/// Adds a note for each kerf that differs from the kerf according to `other`, the record with the
/// other unit of Q.
void add_other_unit(const MaterialRecord& record,
                    const MaterialRecord& other,
                    const std::vector<LayerPlan>& layers,
                    std::set<std::string>& notes) {
  for (const LayerPlan& layer : layers) {
    if (layer.condition.kerf_mm <= 0.0) continue;  // This layer is not cut, so it has no kerf.
    const auto found = predict(other, layer.condition.cut);
    if (!found.ok()) continue;
    if (std::abs(found.value().kerf_mm - layer.condition.kerf_mm) < kSameKerfMm) continue;
    notes.insert(fmt::format(
        "kerf {:.4f} mm by --unit {}, {:.4f} mm by --unit {}: a test coupon decides, see "
        "`kerfline kerf calibrate`",
        layer.condition.kerf_mm,
        unit_option(record.unit),
        found.value().kerf_mm,
        unit_option(other.unit)));
  }
}

/// Returns a note about the laser of a record; empty if the record was measured with this laser.
std::string note_of_laser(const MaterialRecord& record, const std::string& laser) {
  if (!record.calibrated) {
    return fmt::format("the kerf of {} was not measured on this machine: {}; {}",
                       record.name,
                       record.laser,
                       record.provenance);
  }
  if (is_measured_here(record, laser)) return {};
  if (record.laser.empty()) {
    return fmt::format(
        "the kerf of {} was measured with a laser that has no name, perhaps not on this "
        "machine; calibrate it with --laser NAME",
        record.name);
  }
  if (laser.empty()) {
    return fmt::format(
        "the kerf of {} was measured with the laser `{}`; if this machine has it, name it with "
        "--laser",
        record.name,
        record.laser);
  }
  return fmt::format(
      "the kerf of {} was not measured on this machine: it is of the laser `{}`, not of "
      "`{}`; cut a coupon, see `kerfline kerf calibrate`",
      record.name,
      record.laser,
      laser);
}

}  // namespace

bool is_measured_here(const MaterialRecord& record, const std::string& laser) {
  return record.calibrated && !laser.empty() && record.laser == laser;
}

std::vector<std::string> kerf_notes(const MaterialRecord& record,
                                    const std::string& laser,
                                    const std::vector<MaterialRecord>& others,
                                    const std::vector<LayerPlan>& layers) {
  std::vector<std::string> notes;
  if (std::string note = note_of_laser(record, laser); !note.empty()) {
    notes.push_back(std::move(note));
  }
  std::set<std::string> by_unit;
  for (const MaterialRecord& other : others) {
    if (other.name == record.name && other.unit != record.unit) {
      add_other_unit(record, other, layers, by_unit);
    }
  }
  notes.insert(notes.end(), by_unit.begin(), by_unit.end());
  return notes;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream words{text};
  for (std::string word; words >> word;) {
    if (lines.empty() || lines.back().size() + 1 + word.size() > width) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  return lines;
}

}  // namespace sim::cut
