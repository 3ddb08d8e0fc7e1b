#pragma once

#include <string>

#include "host-sim/stock/stock.hpp"

namespace sim {

/// Returns the picture of a carved stock as an SVG document. The plan of the stock is coloured by
/// the depth below its top where material was removed. The picture also contains a grid, a legend
/// and a scale bar. The plan is an image within the document. Throws std::runtime_error, with the
/// name `file`, if the plan cannot be drawn.
/// @param facts text of the line below the title, such as the removed volume; may be empty
[[nodiscard]] std::string draw_stock(const std::string& file,
                                     const stock::Stock& carved,
                                     const std::string& title,
                                     const std::string& facts);

}  // namespace sim
