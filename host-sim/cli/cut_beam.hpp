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

/// Source of a job's kerf, powers and feeds.
struct CutKerf {
  /// Material that supplies the values that the call does not give.
  std::optional<MaterialRecord> material{};
  std::optional<double> known_mm{};  ///< The kerf, if the call gives it.
  MaterialRecord record{};           ///< Record of the job, with the known kerf if there is one.
  std::optional<OperationRecord> operation{};  ///< Operation that replaces a law of the kerf.
  /// Source of the settings, as text for people; if empty, the source is `record`.
  std::string origin{};

  /// Returns the digest of the kerf for the heading of a program.
  [[nodiscard]] ProgramDigest digest() const;
};

/// Reads the record of the call's material, and its known kerf. Throws std::invalid_argument if an
/// option lacks another option that it needs, and as RecordOptions::record() does.
[[nodiscard]] CutKerf kerf_of(const CutCommandOptions& options);

/// Returns power, feed and passes of the material's entry, as options of all cuts.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> values_of_entry(const CutKerf& kerf);

/// Adds the sources of kerf and settings: measured ones to `lines`, all others to `notes`. Also
/// adds notes about the kerf of a record.
void tell_origin(const CutCommandOptions& options,
                 const CutKerf& kerf,
                 const std::vector<cut::LayerPlan>& layers,
                 std::vector<std::string>& lines,
                 std::vector<std::string>& notes);

/// Returns the laser of a call. Its full power is the given one, else the greatest of the
/// material's record, else the greatest that the call has in watts. If the call has only shares of
/// power, the watts are not known. Guesses are added to `notes`.
/// @param wishes settings of all cuts, and of layers
[[nodiscard]] cut::Beam beam_of(const CutCommandOptions& options,
                                const std::vector<SettingChange>& settings,
                                const CutKerf& kerf,
                                const std::vector<cut::LayerSettings>& wishes,
                                std::vector<std::string>& notes);

}  // namespace sim
