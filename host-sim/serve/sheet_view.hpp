#pragma once

#include <string>

#include "host-sim/serve/page_service.hpp"

namespace sim {

/// Places the parts of a sheet that is being edited, for POST `/sheet`:
///
///     {"sheet":{…},"drawings":{"bracket.svg":"<svg …"},"distance_mm":0.2}
///
/// `sheet` has the form of a sheet file, and the drawings have the names that the sheet uses. The
/// reply has the sheet with all places written out, all faults of the sheet and of its places, and
/// the outlines of each copy in mm, y upwards, as `cut` reads them:
///
///     {"sheet":{…},"faults":["…"],
///      "copies":[{"part":0,"copy":0,"outlines":[[x,y, …], …]}, …]}
///
/// All closed contours count as edges of parts. A fault is reported if they are nearer to each
/// other than `distance_mm` (0 to 100; 0 if it is missing), or if the request does not have this
/// form.
[[nodiscard]] WebReply placed_sheet(const std::string& request);

}  // namespace sim
