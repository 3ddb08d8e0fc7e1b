#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim::cut {

/// Returns whether a record has test cuts that were made with the laser named `laser`. Returns
/// false if the record or `laser` has no name, because the answer is then not known.
[[nodiscard]] bool is_measured_here(const MaterialRecord& record, const std::string& laser);

/// Returns notes for the user about the kerf of a job. One note says that the kerf was not measured
/// on this machine, or that this is not known. Further notes give the kerf by a record of the same
/// material with another unit of Q.
/// @param laser name of this machine's laser; empty if the user gave none
/// @param others records of the same name; those with the same unit of Q as `record` are ignored
[[nodiscard]] std::vector<std::string> kerf_notes(const MaterialRecord& record,
                                                  const std::string& laser,
                                                  const std::vector<MaterialRecord>& others,
                                                  const std::vector<LayerPlan>& layers);

/// Returns a text broken into lines of at most `width` characters. A line is longer only if it
/// consists of one longer word.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace sim::cut
