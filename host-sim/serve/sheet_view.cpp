#include "host-sim/serve/sheet_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/report/printable.hpp"
#include "host-sim/serve/http_status.hpp"
#include "host-sim/sheet/place_parts.hpp"
#include "host-sim/sheet/sheet_check.hpp"

namespace sim {
namespace {

using nlohmann::ordered_json;

/// Greatest distance between a curve and the chords by which the page shows it, mm.
constexpr double kViewChordMm = 0.05;
constexpr double kMaxPartDistanceMm = 100.0;
/// Limit of the work for one drawing, as a share of the work that `cut` permits. It is small
/// because the page sends a request after each change.
constexpr double kEffort = 0.1;
/// Greatest depth of nested JSON that is read. No sheet is nested more deeply, even with mistakes,
/// and writing deeper JSON would use more stack.
constexpr int kDeepest = 16;

/// Part and copy number of each copy that is placed, in the order of Entity::part.
struct PlacedCopy {
  std::size_t part = 0;
  std::size_t copy = 0;
};

class SheetView {
 public:
  explicit SheetView(const ordered_json& request)
      : sheet_{sheet::read_sheet("sheet.json", request.value("sheet", ordered_json{}).dump())} {
    const auto drawings = request.find("drawings");
    if (drawings != request.end() && drawings->is_object()) {
      for (const auto& [name, text] : drawings->items()) {
        if (text.is_string()) texts_[sheet::resolved(sheet_, name)] = text.get<std::string>();
      }
    }
    const auto distance = request.find("distance_mm");
    if (distance != request.end() && distance->is_number()) {
      distance_mm_ = std::clamp(distance->get<double>(), 0.0, kMaxPartDistanceMm);
    }
  }

  [[nodiscard]] ordered_json reply() const {
    const auto read = [this](const std::string& name) {
      const auto found = texts_.find(name);
      if (found != texts_.end()) return found->second;
      throw std::invalid_argument(fmt::format("{} is not here", printable(name)));
    };
    const drawing::Drawing placed = sheet::place_parts(sheet_, read, {.effort = kEffort});
    return {{"sheet", ordered_json::parse(text_of(sheet_))},
            {"faults", faults_of(placed)},
            {"copies", copies_of(placed)}};
  }

 private:
  [[nodiscard]] ordered_json faults_of(const drawing::Drawing& placed) const {
    ordered_json faults = ordered_json::array();
    for (const drawing::Fault& fault : placed.faults) {
      if (fault.is_error()) faults.push_back(to_string(fault, placed.file));
    }
    std::vector<sheet::ContourUse> uses;
    for (const drawing::DrawnContour& contour : placed.contours) {
      uses.push_back({.is_cut = true, .is_edge = contour.closed, .kerf_mm = distance_mm_});
    }
    for (const drawing::Fault& fault : sheet::check_places(placed, uses)) {
      faults.push_back(to_string(fault, placed.file));
    }
    return faults;
  }

  /// Returns the copies in the numbering of place_parts(), which omits copies whose drawing cannot
  /// be read.
  [[nodiscard]] std::vector<PlacedCopy> numbered_copies() const {
    std::vector<PlacedCopy> copies;
    for (std::size_t part = 0; part < sheet_.parts.size(); ++part) {
      const auto text = texts_.find(sheet::resolved(sheet_, sheet_.parts[part].drawing));
      if (text == texts_.end() || sheet::is_sheet(text->second)) continue;
      for (std::size_t copy = 0; copy < sheet_.parts[part].places.size(); ++copy) {
        copies.push_back({part, copy});
      }
    }
    return copies;
  }

  [[nodiscard]] ordered_json copies_of(const drawing::Drawing& placed) const {
    const std::vector<PlacedCopy> copies = numbered_copies();
    std::vector<ordered_json> outlines(copies.size(), ordered_json::array());
    for (const drawing::DrawnContour& contour : placed.contours) {
      if (contour.entity.part >= outlines.size()) continue;
      ordered_json points = ordered_json::array();
      for (const drawing::Place& place : outline_of(contour.shapes, kViewChordMm)) {
        points.push_back(std::round(place.x() * 1000.0) / 1000.0);
        points.push_back(std::round(place.y() * 1000.0) / 1000.0);
      }
      outlines[contour.entity.part].push_back(std::move(points));
    }
    ordered_json rows = ordered_json::array();
    for (std::size_t i = 0; i < copies.size(); ++i) {
      rows.push_back({{"part", copies[i].part},
                      {"copy", copies[i].copy},
                      {"outlines", std::move(outlines[i])}});
    }
    return rows;
  }

  sheet::Sheet sheet_;
  std::map<std::string, std::string> texts_;  ///< Texts of drawings by their resolved names.
  double distance_mm_ = 0.0;
};

}  // namespace

WebReply placed_sheet(const std::string& request) {
  bool is_shallow = true;
  const auto look = [&is_shallow](int depth, ordered_json::parse_event_t, ordered_json&) {
    is_shallow = is_shallow && depth <= kDeepest;
    return is_shallow;
  };
  const ordered_json json = ordered_json::parse(request, look, false);
  const ordered_json reply =
      is_shallow && json.is_object()
          ? SheetView{json}.reply()
          : ordered_json{
                {"faults", {R"(the request is no JSON object with "sheet" and "drawings")"}}};
  return {.status = http_status::kFine,
          .type = "application/json",
          .content = reply.dump(-1, ' ', false, ordered_json::error_handler_t::replace)};
}

}  // namespace sim
