#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim::cut {

/// What a user has to know of the kerf that a job counts on: that nobody measured it on this
/// machine, and how wide it would be by a record of the same material with another unit of Q.
/// @param others records of the same name; that with the unit of `record` does not count
[[nodiscard]] std::vector<std::string> kerf_notes(const MaterialRecord& record,
                                                  const std::vector<MaterialRecord>& others,
                                                  const std::vector<LayerPlan>& layers);

/// The text in lines of at most `width` characters, but for longer words.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace sim::cut
