#pragma once

#include <string>
#include <vector>

namespace sim {

/// Size of an A4 page, in points of 1/72 inch.
inline constexpr double kPageWidthPt = 595.28;
inline constexpr double kPageHeightPt = 841.89;

/// Draws SVG documents as the pages of one PDF by librsvg and cairo, each over a whole A4 page, and
/// writes the file. The file has no date, so that the same pages give the same bytes on systems
/// with the same fonts and libraries.
///
/// Throws std::runtime_error naming the file if a page cannot be drawn, or std::system_error if the
/// file cannot be written.
/// @pre there is at least one page
void write_pdf(const std::string& file,
               const std::vector<std::string>& pages,
               const std::string& title);

}  // namespace sim
