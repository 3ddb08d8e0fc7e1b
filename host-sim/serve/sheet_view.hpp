#pragma once

#include <string>

#include "host-sim/serve/page_service.hpp"

namespace sim {

/// Places the parts of a sheet that is being edited, for POST `/sheet`:
///
///     {"sheet":{…},"drawings":{"bracket.svg":"<svg …"},"distance_mm":0.2}
///
/// The sheet is as in a sheet file; drawings have the names that it uses. The reply has the sheet
/// with all places written out, whatever is wrong with it and with its places, and the outlines of
/// each copy in mm, y upwards, as `cut` reads them:
///
///     {"sheet":{…},"faults":["…"],
///      "copies":[{"part":0,"copy":0,"outlines":[[x,y, …], …]}, …]}
///
/// All closed contours count as edges of parts, no nearer to each other than `distance_mm` (0 to
/// 100; 0 without it). What is no such request has a fault that says so.
[[nodiscard]] WebReply placed_sheet(const std::string& request);

}  // namespace sim
