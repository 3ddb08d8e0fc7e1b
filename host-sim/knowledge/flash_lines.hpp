#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// Returns the image of a record as the controller stores it (planner/kerf/table_image.hpp), under
/// the name `name`. Throws std::invalid_argument if the record is too large: `kerf table has 9
/// thicknesses, capacity 8`.
[[nodiscard]] std::vector<std::byte> flash_image(const MaterialRecord& record,
                                                 const std::string& name);

/// Returns the lines that write an image into a controller, `$KW=0:…` to `$KS`.
[[nodiscard]] std::string flash_lines(std::span<const std::byte> image);

}  // namespace sim
