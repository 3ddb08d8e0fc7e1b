#include "host-sim/cli/cut_place_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "host-sim/cli/machine_option.hpp"
#include "host-sim/cli/value_range.hpp"

namespace sim {
namespace {

constexpr double kFarthestPlaceMm = 1.0e5;
constexpr std::size_t kMaxColumns = 1000;

/// Reads two numbers with the character `between` between them.
std::optional<cut::Place> two_numbers(const std::string& text, char between) {
  const std::size_t split = text.find(between);
  if (split == std::string::npos) return std::nullopt;
  cut::Place place{0.0, 0.0};
  const auto read = [&text](std::size_t begin, std::size_t end, double& value) {
    const auto [rest, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    return error == std::errc{} && rest == text.data() + end && std::abs(value) <= kFarthestPlaceMm;
  };
  const bool is_fine = read(0, split, place.x()) && read(split + 1, text.size(), place.y());
  return is_fine ? std::optional{place} : std::nullopt;
}

cut::Place point_from(const char* option, const std::string& text, const char* wanted) {
  const auto point = two_numbers(text, ',');
  if (point) return *point;
  throw std::invalid_argument(fmt::format("{} {}: must be {}", option, text, wanted));
}

}  // namespace

void add_machine_options(CLI::App& command, CutPlaceOptions& options) {
  add_machine_option(command, options.machine);
  command
      .add_option("--place",
                  options.place,
                  "Position of the drawing: corner or centre of the bed, or X,Y in mm")
      ->type_name("WHERE");
  command
      .add_option("--place-margin",
                  options.margin_mm,
                  "Distance from the edges of the bed with --place corner, mm")
      ->check(in_range(0.0, 1000.0, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option("--move",
                  options.move,
                  "Distance by which the drawing is moved after --place, mm, such as --move=-5,0")
      ->type_name("DX,DY");
}

void add_cut_place_options(CLI::App& command, CutPlaceOptions& options) {
  add_machine_options(command, options);
  command
      .add_option("--turn",
                  options.turn_deg,
                  "Angle by which the drawing is rotated to the left about its middle, degrees")
      ->check(in_range(-360.0, 360.0, "degrees"))
      ->type_name("DEG");
  command
      .add_option("--mirror",
                  options.mirror,
                  "Mirror the drawing: x exchanges left and right, y up and down")
      ->check(CLI::IsMember({"x", "y"}))
      ->type_name("AXIS");
  command.add_option("--scale", options.scale, "Factor by which the drawing is scaled")
      ->check(in_range(1.0e-4, 1.0e4, ""))
      ->type_name("F");
  command
      .add_option("--copies", options.copies, "Number of copies along X and along Y, such as 3x2")
      ->type_name("NxM");
  command.add_option("--copy-gap", options.gap_mm, "Distance between copies, mm")
      ->check(in_range(0.0, 1.0e4, "mm"))
      ->type_name("MM")
      ->capture_default_str();
}

cut::PlaceWishes place_wishes_of(const CutPlaceOptions& options) {
  cut::PlaceWishes wishes{.turn_deg = options.turn_deg,
                          .scale = options.scale,
                          .gap_mm = options.gap_mm,
                          .margin_mm = options.margin_mm};
  if (options.place == "corner") {
    wishes.at = cut::PlaceAt::kCorner;
  } else if (options.place == "centre" || options.place == "center") {
    wishes.at = cut::PlaceAt::kCentre;
  } else if (!options.place.empty()) {
    wishes.at = cut::PlaceAt::kPoint;
    wishes.point_mm =
        point_from("--place", options.place, "corner, centre, or X,Y in mm, such as 10,20");
  }
  if (!options.move.empty()) {
    wishes.move_mm = point_from("--move", options.move, "DX,DY in mm, such as 10,0");
  }
  if (!options.mirror.empty()) {
    wishes.mirror = options.mirror == "x" ? cut::MirrorAlong::kX : cut::MirrorAlong::kY;
  }
  if (options.copies.empty()) return wishes;
  const auto counts = two_numbers(options.copies, 'x');
  const auto is_count = [](double value) {
    return value >= 1.0 && value <= static_cast<double>(kMaxColumns) && value == std::floor(value);
  };
  if (!counts || !is_count(counts->x()) || !is_count(counts->y())) {
    throw std::invalid_argument(fmt::format(
        "--copies {}: must be NxM, each from 1 to {}, such as 3x2", options.copies, kMaxColumns));
  }
  wishes.columns = static_cast<std::size_t>(counts->x());
  wishes.rows = static_cast<std::size_t>(counts->y());
  return wishes;
}

}  // namespace sim
