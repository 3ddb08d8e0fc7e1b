#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host-sim/cut/edge_check.hpp"

namespace sim::cut {
namespace {

constexpr double kMicrometres = 1000.0;

std::string text_of(const EdgePeak& peak) {
  return fmt::format("{:.1f} um at {:.3f} {:.3f}",
                     kMicrometres * std::abs(peak.mm),
                     peak.place.x(),
                     peak.place.y());
}

nlohmann::ordered_json json_of(const EdgePeak& peak) {
  return {{"mm", peak.mm}, {"place_mm", {peak.place.x(), peak.place.y()}}};
}

}  // namespace

std::vector<std::string> lines_of(const EdgeFigures& figures) {
  const double corners = figures.greatest_corner_ratio;
  const std::string at_corners =
      corners > 0.0 ? fmt::format(", at corners {:.3f} at most", corners) : std::string{};
  return {fmt::format("cut off the part at most {}, left on it at most {}, mean error {:.1f} um",
                      text_of(figures.max_off),
                      text_of(figures.max_left),
                      kMicrometres * figures.mean_mm),
          fmt::format(
              "distance from the edge of the planned kerf at most {}; {:.2f} mm of edges in inner "
              "corners, slots and tabs are not reached",
              text_of(figures.max_off_model),
              figures.untouched_mm),
          fmt::format("this distance where test cuts cover power and speed at most {}; {:.2f} mm "
                      "of edges are cut at other powers and speeds, by the same law",
                      text_of(figures.max_off_known),
                      figures.unknown_mm),
          fmt::format("power over speed {:.3f} to {:.3f} of the planned value{}",
                      figures.min_heat_ratio,
                      figures.greatest_heat_ratio,
                      at_corners)};
}

nlohmann::ordered_json json_of(const EdgeFigures& figures) {
  nlohmann::ordered_json json;
  json["most_off"] = json_of(figures.max_off);
  json["most_left"] = json_of(figures.max_left);
  json["mean_mm"] = figures.mean_mm;
  json["places"] = figures.places;
  json["untouched_mm"] = figures.untouched_mm;
  json["most_off_model"] = json_of(figures.max_off_model);
  json["most_off_known"] = json_of(figures.max_off_known);
  json["unknown_mm"] = figures.unknown_mm;
  json["heat_ratio"] = {{"least", figures.min_heat_ratio},
                        {"greatest", figures.greatest_heat_ratio},
                        {"greatest_at_corners", figures.greatest_corner_ratio}};
  return json;
}

}  // namespace sim::cut
