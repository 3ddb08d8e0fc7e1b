#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "host-sim/surface/xyz_dialect.hpp"

namespace sim::surface {

/// Fields that hold X, Y and Z.
using XyzColumns = std::array<std::size_t, 3>;

/// Returns the fields that a header line calls X, Y and Z, in any letters and with a unit behind:
/// `X`, `y [mm]`, `Z_in`. Returns nothing unless each name stands there once.
[[nodiscard]] std::optional<XyzColumns> columns_of_header(const XyzFields& header);

}  // namespace sim::surface
