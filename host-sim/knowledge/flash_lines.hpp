#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// The record as the controller stores it (planner/kerf/table_image.hpp), under a name of its own.
/// Throws std::invalid_argument where it does not fit: `kerf table has 9 thicknesses, capacity 8`.
[[nodiscard]] std::vector<std::byte> flash_image(const MaterialRecord& record,
                                                 const std::string& name);

/// The lines that write an image into a controller, `$KW=0:…` to `$KS`.
[[nodiscard]] std::string flash_lines(std::span<const std::byte> image);

}  // namespace sim
