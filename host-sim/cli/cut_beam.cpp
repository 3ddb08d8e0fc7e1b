#include "host-sim/cli/cut_beam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "firmware/machine/settings.hpp"
#include "host-sim/cli/cut_identity.hpp"
#include "host-sim/cut/condition.hpp"
#include "host-sim/cut/known_kerf.hpp"
#include "host-sim/knowledge/experiment.hpp"

namespace sim {
namespace {

/// Throws std::invalid_argument for options without those that they need.
void expect_whole_call(const CutCommandOptions& options) {
  const auto refuse = [](const char* reason) { throw std::invalid_argument(reason); };
  const bool has_material = !options.record.material.empty();
  if (has_material && options.thickness_mm <= 0.0) {
    refuse("--thickness: is needed with --material, mm");
  }
  if (!has_material && (!options.record.data_base.empty() || !options.record.unit.empty())) {
    refuse("--db and --unit: are for the record of a --material; name it, or leave them out");
  }
  if (!options.kerf_table) return;
  if (!has_material || options.kerf_mm) {
    refuse("--kerf-table: the controller needs the kerf of a --material, and no --kerf");
  }
}

double greatest_watts(const std::vector<cut::LayerSettings>& wishes) {
  double greatest = 0.0;
  for (const cut::LayerSettings& wish : wishes) {
    greatest = std::max(greatest, wish.power_w.value_or(0.0));
  }
  return greatest;
}

/// Chooses a full power that nobody has given.
void guess_full_power(cut::Beam& beam,
                      const std::vector<cut::LayerSettings>& wishes,
                      std::vector<std::string>& notes) {
  const double watts = greatest_watts(wishes);
  const bool has_shares = std::ranges::any_of(
      wishes, [](const cut::LayerSettings& wish) { return wish.power_share.has_value(); });
  if (watts > 0.0 && has_shares) {
    throw std::invalid_argument(
        "power is given in watts and as a share; say with --full-power or --machine what the laser "
        "gives, W");
  }
  beam.knows_watts = watts > 0.0;
  beam.full_power_w = beam.knows_watts ? watts : 100.0;
  if (!beam.knows_watts) return;
  notes.push_back(
      fmt::format("the laser's full power is not given: S{:g} is taken as {:g} W, the greatest "
                  "power of the call; say with --full-power or --machine what it gives",
                  beam.full_power_s,
                  watts));
}

}  // namespace

ProgramDigest CutKerf::digest() const {
  if (!known_mm) return digest_of(record);
  return {
      "kerf", digest_of(fmt::format("{}", *known_mm)), record.name.empty() ? "given" : record.name};
}

CutKerf kerf_of(const CutCommandOptions& options) {
  expect_whole_call(options);
  CutKerf kerf{.known_mm = options.kerf_mm};
  if (!options.record.material.empty()) kerf.material = options.record.record();
  if (kerf.material && !kerf.known_mm) {
    kerf.record = *kerf.material;
    return kerf;
  }
  const std::string name = kerf.material ? kerf.material->name : "";
  kerf.record = cut::record_of_known_kerf(
      kerf.known_mm.value_or(0.0), name, thickness_option(options.thickness_mm));
  return kerf;
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
    if (change.number == cnc::setting::kMostSpindleSpeed) {
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
