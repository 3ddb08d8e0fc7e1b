#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim::cut {

/// Returns whether a record has test cuts made with this laser. Returns false if either side has no
/// name, because then this is not known.
[[nodiscard]] bool is_measured_here(const MaterialRecord& record, const std::string& laser);

/// Returns notes for the user about the kerf of a job. A note says that the kerf was not measured
/// on this machine, or that this is not known. Another note gives the kerf by a record of the same
/// material that has another unit of Q.
/// @param laser the name of this machine's laser; empty if the user gave none
/// @param others records of the same name; a record with the same unit of Q as `record` does not
/// count
[[nodiscard]] std::vector<std::string> kerf_notes(const MaterialRecord& record,
                                                  const std::string& laser,
                                                  const std::vector<MaterialRecord>& others,
                                                  const std::vector<LayerPlan>& layers);

/// Returns a text broken into lines of at most `width` characters. Only a longer word makes a
/// longer line.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace sim::cut
