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
  /// Material whose values replace those that the call does not give.
  std::optional<MaterialRecord> material{};
  std::optional<double> known_mm{};  ///< Kerf that the call gives; empty if it gives none.
  MaterialRecord record{};  ///< Record of the job; it contains the known kerf if there is one.
  std::optional<OperationRecord> operation{};  ///< Operation that replaces a law of the kerf.
  /// Source of the settings as text for the user; if empty, the source is `record`.
  std::string origin{};

  /// Returns the digest of the kerf for the heading of a program.
  [[nodiscard]] ProgramDigest digest() const;
};

/// Reads the record of the call's material, and the known kerf. Throws std::invalid_argument if an
/// option is given without another option that it requires, and the exceptions of
/// RecordOptions::record().
[[nodiscard]] CutKerf kerf_of(const CutCommandOptions& options);

/// Returns power, feed and passes of the material's entry as keys and values for all cuts.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> values_of_entry(const CutKerf& kerf);

/// Describes the sources of kerf and settings: appends measured sources to `lines`, all other
/// sources to `notes`. Also appends notes about the kerf of a record.
void tell_origin(const CutCommandOptions& options,
                 const CutKerf& kerf,
                 const std::vector<cut::LayerPlan>& layers,
                 std::vector<std::string>& lines,
                 std::vector<std::string>& notes);

/// Returns the laser of a call. Its full power is the first of these values that is known: the full
/// power that the call gives, the greatest power in the material's record, the greatest power in
/// watts that the call gives. If the call gives only shares of power, the watts are not known.
/// Guesses are appended to `notes`.
/// @param wishes settings of all cuts, and of layers
[[nodiscard]] cut::Beam beam_of(const CutCommandOptions& options,
                                const std::vector<SettingChange>& settings,
                                const CutKerf& kerf,
                                const std::vector<cut::LayerSettings>& wishes,
                                std::vector<std::string>& notes);

}  // namespace sim
