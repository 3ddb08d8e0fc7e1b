#pragma once

#include <string>
#include <vector>

namespace sim {

/// A4, in points of 1/72 inch.
inline constexpr double kPageWidthPt = 595.28;
inline constexpr double kPageHeightPt = 841.89;

/// Draws SVG documents as the pages of one PDF by librsvg and cairo, each over a whole A4 page, and
/// writes it. The file has no date, so that the same pages are the same bytes wherever fonts and
/// libraries are the same.
///
/// Throws std::runtime_error naming the file when a page cannot be drawn, std::system_error when
/// the file cannot be written. @pre there is a page
void write_pdf(const std::string& file,
               const std::vector<std::string>& pages,
               const std::string& title);

}  // namespace sim
