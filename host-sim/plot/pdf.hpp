#pragma once

#include <string>
#include <vector>

namespace sim {

/// Size of an A4 page, in points of 1/72 inch.
inline constexpr double kPageWidthPt = 595.28;
inline constexpr double kPageHeightPt = 841.89;

/// Draws SVG documents with librsvg and cairo as the pages of one PDF, and writes the file. Each
/// document fills an A4 page. The file contains no date, so that the same pages result in the same
/// bytes on systems with the same fonts and libraries.
///
/// Throws std::runtime_error, with the name of the file, if a page cannot be drawn, and
/// std::system_error if the file cannot be written.
/// @pre there is at least one page
void write_pdf(const std::string& file,
               const std::vector<std::string>& pages,
               const std::string& title);

}  // namespace sim
