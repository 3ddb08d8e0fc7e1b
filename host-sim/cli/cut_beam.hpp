#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/recipe.hpp"
#include "host-sim/job/program_digest.hpp"
#include "host-sim/job/setting_line.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// Where a job has its kerf, powers and feeds from.
struct CutKerf {
  std::optional<MaterialRecord> material{};  ///< Chooses what the call does not give.
  std::optional<double> known_mm{};          ///< The kerf, as the call gives it.
  MaterialRecord record{};                   ///< The job's; with the known kerf where there is one.
  std::optional<OperationRecord> operation{};  ///< In place of a law of the kerf.
  std::string origin{};  ///< Source of the settings, for people; empty: see `record`.

  /// Returns the digest of the kerf for the heading of a program.
  [[nodiscard]] ProgramDigest digest() const;
};

/// Reads the record of the call's material, and its known kerf. Throws std::invalid_argument for
/// options that need others, and as RecordOptions::record() does.
[[nodiscard]] CutKerf kerf_of(const CutCommandOptions& options);

/// Returns what the material's entry says of power, feed and passes, as options of all cuts.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> values_of_entry(const CutKerf& kerf);

/// Adds where kerf and settings are from: to `lines` what was measured, to `notes` the rest, and
/// what is to be known of the kerf of a record.
void tell_origin(const CutCommandOptions& options,
                 const CutKerf& kerf,
                 const std::vector<cut::LayerPlan>& layers,
                 std::vector<std::string>& lines,
                 std::vector<std::string>& notes);

/// Returns the laser of a call. Its full power is the one that is given, else the greatest of the
/// material's record, else the greatest that the call has in watts; where the call has shares only,
/// watts are not known. What was guessed is added to `notes`.
/// @param wishes settings of all cuts, and of layers
[[nodiscard]] cut::Beam beam_of(const CutCommandOptions& options,
                                const std::vector<SettingChange>& settings,
                                const CutKerf& kerf,
                                const std::vector<cut::LayerSettings>& wishes,
                                std::vector<std::string>& notes);

}  // namespace sim
