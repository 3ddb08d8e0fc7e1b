#pragma once

#include <string>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cli/wall_options.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim {

/// Writes the program that cuts a part layer by layer, its beams and its report, and prints its
/// figures. Returns kFaults if a tip is out of reach. If the part cannot be cut, throws
/// std::invalid_argument before any file is written.
/// @pre check_wall_options() accepts the options, and require_solid() the part
[[nodiscard]] ExitStatus write_wall_job(const WallOptions& options,
                                        const surface::Mesh& part,
                                        InputFiles& inputs);

}  // namespace sim
