#pragma once

#include "host-sim/job/program_digest.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// Returns the digest of a kerf record: the digest of the image that a controller would store of
/// it.
[[nodiscard]] ProgramDigest digest_of(const MaterialRecord& record);

/// Returns the digest of a machine's settings.
/// @param is_given whether the call names any setting
[[nodiscard]] ProgramDigest settings_digest(const cnc::Settings& settings, bool is_given);

}  // namespace sim
