#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/engrave/burn_raster.hpp"

namespace sim::engrave {

/// Returns the names `grey`, `threshold`, `ordered`, `floyd-steinberg`, `jarvis`, `stucki`.
[[nodiscard]] std::vector<std::string> shading_names();

/// Returns the shading with the given name; none for any other text.
[[nodiscard]] std::optional<Shading> shading_named(std::string_view name);

}  // namespace sim::engrave
