#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/stock/stock_report.hpp"

namespace sim {

/// Returns a description such as `flat 6 mm` or `bull nose 6 mm with corners of 1 mm`.
[[nodiscard]] std::string to_string(const stock::Cutter& cutter);

/// Returns the element `stock` of a report. The bounds of a figure are called `least` and `most`.
[[nodiscard]] nlohmann::ordered_json to_json(const stock::StockReport& report);

/// Returns name and value of each fact, as text for people.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> stock_facts(
    const stock::StockReport& report);

/// Returns name and value of each fact of a comparison with a surface: gouge, rest, and the worst
/// points.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> surface_facts(
    const stock::SurfaceFigures& figures);

/// Returns the warnings of a report: one for each of the first lines whose rapids cut stock, one
/// for all other such lines, and one for a pocket or a surface that is gouged.
[[nodiscard]] std::vector<std::string> warnings_of(const stock::StockReport& report,
                                                   const std::string& file);

}  // namespace sim
