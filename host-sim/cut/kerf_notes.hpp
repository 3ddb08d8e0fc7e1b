#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim::cut {

/// Whether a record is of test cuts by this laser. Without a name on either side it is not known,
/// and false.
[[nodiscard]] bool is_measured_here(const MaterialRecord& record, const std::string& laser);

/// Notes on the kerf that a job counts on, for its user: that it was not measured on this machine,
/// or that this is not known, and its width by a record of the same material with another unit of
/// Q.
/// @param laser the name of this machine's laser; empty where the user gave none
/// @param others records of the same name; that with the unit of `record` does not count
[[nodiscard]] std::vector<std::string> kerf_notes(const MaterialRecord& record,
                                                  const std::string& laser,
                                                  const std::vector<MaterialRecord>& others,
                                                  const std::vector<LayerPlan>& layers);

/// The text in lines of at most `width` characters, but for longer words.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace sim::cut
