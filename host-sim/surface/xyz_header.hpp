#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "host-sim/surface/xyz_dialect.hpp"

namespace sim::surface {

/// Indices of the fields that contain X, Y and Z.
using XyzColumns = std::array<std::size_t, 3>;

/// Returns the fields that a header line names X, Y and Z, in capital or small letters and with an
/// optional unit: `X`, `y [mm]`, `Z_in`. Returns nothing unless each of the three names occurs
/// exactly once.
[[nodiscard]] std::optional<XyzColumns> columns_of_header(const XyzFields& header);

}  // namespace sim::surface
