#include "host-sim/cli/cut_beam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "firmware/machine/settings.hpp"
#include "host-sim/cli/cut_identity.hpp"
#include "host-sim/cut/condition.hpp"
#include "host-sim/cut/kerf_notes.hpp"
#include "host-sim/cut/known_kerf.hpp"
#include "host-sim/knowledge/experiment.hpp"

namespace sim {
namespace {

/// Checks that each option is given together with the options that it requires. Throws
/// std::invalid_argument otherwise.
void expect_whole_call(const CutCommandOptions& options) {
  const auto refuse = [](const char* reason) { throw std::invalid_argument(reason); };
  const bool has_material = !options.record.material.empty();
  if (has_material && options.thickness_mm <= 0.0) {
    refuse("--thickness is missing; --material requires it, mm");
  }
  if (!has_material && !options.entry.empty()) {
    refuse("--entry: requires a --material; name one, or leave --entry out");
  }
  if (!has_material && (!options.record.data_base.empty() || !options.record.unit.empty())) {
    refuse("--db and --unit: require a --material; name one, or leave them out");
  }
  if (!options.kerf_table) return;
  if (!has_material || options.kerf_mm) {
    refuse("--kerf-table: requires the kerf of a --material; name one, and leave out --kerf");
  }
}

double greatest_watts(const std::vector<cut::LayerSettings>& wishes) {
  double greatest = 0.0;
  for (const cut::LayerSettings& wish : wishes) {
    greatest =
        std::max({greatest, wish.power_w.value_or(0.0), wish.image.min_power.watts.value_or(0.0)});
  }
  return greatest;
}

/// Chooses a full power if none is given.
void guess_full_power(cut::Beam& beam,
                      const std::vector<cut::LayerSettings>& wishes,
                      std::vector<std::string>& notes) {
  const double watts = greatest_watts(wishes);
  const bool has_shares = std::ranges::any_of(wishes, [](const cut::LayerSettings& wish) {
    return wish.power_share.has_value() || wish.image.min_power.share.has_value();
  });
  if (watts > 0.0 && has_shares) {
    throw std::invalid_argument(
        "power is given both in watts and as a share of full power; give the power of the laser, "
        "W, with --full-power "
        "or --machine");
  }
  beam.knows_watts = watts > 0.0;
  beam.full_power_w = beam.knows_watts ? watts : 100.0;
  if (!beam.knows_watts) return;
  notes.push_back(
      fmt::format("the laser's full power is not given: S{:g} is taken as {:g} W, the greatest "
                  "power of the call; give the full power with --full-power or --machine",
                  beam.full_power_s,
                  watts));
}

}  // namespace

ProgramDigest CutKerf::digest() const {
  if (!known_mm && !record.name.empty()) return digest_of(record);
  if (!known_mm) return {"kerf", digest_of("none"), "none"};
  return {
      "kerf", digest_of(fmt::format("{}", *known_mm)), record.name.empty() ? "given" : record.name};
}

namespace {

/// Takes the job's kerf from an entry of a record, unless the call gives a kerf.
void take_entry(CutKerf& kerf, const MaterialRecord& record, const CutCommandOptions& options) {
  if (options.kerf_table) {
    throw std::invalid_argument(fmt::format(
        "--kerf-table: the controller requires a law of the kerf, and {} has none; calibrate it",
        record.name));
  }
  const std::uint32_t thickness_um = thickness_option(options.thickness_mm);
  kerf.operation =
      choose_operation(record.operations, {record.name, "cut", thickness_um, options.entry});
  kerf.origin = kerf.operation ? text_of(kerf.operation->origin) : origins_of(record.operations);
  if (kerf.operation && !kerf.known_mm) kerf.known_mm = kerf.operation->kerf_mm;
  kerf.record = cut::record_of_known_kerf(kerf.known_mm.value_or(0.0), record.name, thickness_um);
  kerf.record.provenance = kerf.origin;
  kerf.record.laser = kerf.operation ? kerf.operation->laser : record.laser;
  kerf.record.calibrated = kerf.operation && kerf.operation->origin.is_measured_here;
}

}  // namespace

CutKerf kerf_of(const CutCommandOptions& options) {
  expect_whole_call(options);
  CutKerf kerf{.known_mm = options.kerf_mm};
  if (!options.record.material.empty()) {
    const MaterialRecord record = options.record.record();
    if (!record.operations.empty() && (!record.has_kerf() || !options.entry.empty())) {
      take_entry(kerf, record, options);
      return kerf;
    }
    if (!options.entry.empty()) {
      throw std::invalid_argument(
          fmt::format("--entry {}: {} has no entries; leave it out", options.entry, record.name));
    }
    kerf.material = record;
  }
  if (kerf.material && !kerf.known_mm) {
    kerf.record = *kerf.material;
    return kerf;
  }
  const std::string name = kerf.material ? kerf.material->name : "";
  kerf.record = cut::record_of_known_kerf(
      kerf.known_mm.value_or(0.0), name, thickness_option(options.thickness_mm));
  return kerf;
}

std::vector<std::pair<std::string, std::string>> values_of_entry(const CutKerf& kerf) {
  std::vector<std::pair<std::string, std::string>> values;
  if (!kerf.operation) return values;
  const OperationRecord& entry = *kerf.operation;
  if (entry.power_percent)
    values.emplace_back("power", fmt::format("{:.10g}%", *entry.power_percent));
  if (entry.speed_um_min) {
    values.emplace_back("feed", fmt::format("{:.10g}", from_thousandths(*entry.speed_um_min)));
  }
  if (entry.passes) values.emplace_back("passes", fmt::format("{}", *entry.passes));
  return values;
}

void tell_origin(const CutCommandOptions& options,
                 const CutKerf& kerf,
                 const std::vector<cut::LayerPlan>& layers,
                 std::vector<std::string>& lines,
                 std::vector<std::string>& notes) {
  const MaterialRecord& record = kerf.record;
  const std::string laser = record.laser.empty() ? "" : fmt::format(", laser {}", record.laser);
  if (kerf.material && !kerf.known_mm) {
    if (record.calibrated) {
      lines.push_back(fmt::format("kerf of {}: {}", record.name, record.provenance));
    }
    const auto found = kerf_notes(record, options.laser, options.record.records(), layers);
    notes.insert(notes.end(), found.begin(), found.end());
  }
  if (kerf.origin.empty()) return;
  std::string text = fmt::format("settings of {}: {}{}", record.name, kerf.origin, laser);
  if (kerf.operation) text += "; " + text_of(*kerf.operation);
  (record.calibrated ? lines : notes).push_back(std::move(text));
}

cut::Beam beam_of(const CutCommandOptions& options,
                  const std::vector<SettingChange>& settings,
                  const CutKerf& kerf,
                  const std::vector<cut::LayerSettings>& wishes,
                  std::vector<std::string>& notes) {
  cut::Beam beam{.full_power_w = options.full_power_w,
                 .follows_speed = !options.constant_power,
                 .kerf_table = options.kerf_table};
  for (const SettingChange& change : settings) {
    if (change.number == cnc::setting::kMaxSpindleSpeed) {
      beam.full_power_s = static_cast<double>(change.value);
    }
  }
  if (beam.full_power_w == 0.0 && kerf.material) {
    beam.full_power_w = from_thousandths(
        cut::greatest_power(*kerf.material, thickness_option(options.thickness_mm)));
  }
  if (beam.full_power_w == 0.0) guess_full_power(beam, wishes, notes);
  return beam;
}

}  // namespace sim
