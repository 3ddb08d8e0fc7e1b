#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/job/program_digest.hpp"
#include "host-sim/job/setting_line.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// Where a job has its kerf, powers and feeds from.
struct CutKerf {
  std::optional<MaterialRecord> material{};  ///< Chooses what the call does not give.
  std::optional<double> known_mm{};          ///< The kerf, as the call gives it.
  MaterialRecord record{};  ///< Of the job: with the known kerf where there is one.

  /// Returns the digest of the kerf for the heading of a program.
  [[nodiscard]] ProgramDigest digest() const;
};

/// Reads the record of the call's material, and its known kerf. Throws std::invalid_argument for
/// options that need others, and as RecordOptions::record() does.
[[nodiscard]] CutKerf kerf_of(const CutCommandOptions& options);

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
