#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/stock/stock_report.hpp"

namespace sim {

/// Returns a description such as `flat 6 mm` or `bull nose 6 mm with corners of 1 mm`.
[[nodiscard]] std::string to_string(const stock::Cutter& cutter);

/// Returns the element `stock` of a report. The keys for the bounds of a figure are `least` and
/// `most`.
[[nodiscard]] nlohmann::ordered_json to_json(const stock::StockReport& report);

/// Returns the name and the value of each fact as readable text.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> stock_facts(
    const stock::StockReport& report);

/// Returns the name and the value of each fact of a comparison with a surface: gouge, rest, and the
/// worst points.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> surface_facts(
    const stock::SurfaceFigures& figures);

/// Returns the warnings of a report. The first lines whose rapids cut stock have one warning each.
/// All further lines whose rapids cut stock have one common warning. A gouged pocket and a gouged
/// surface have one warning each.
[[nodiscard]] std::vector<std::string> warnings_of(const stock::StockReport& report,
                                                   const std::string& file);

}  // namespace sim
