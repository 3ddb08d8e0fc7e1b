#include "host-sim/cli/surface_regions.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "host-sim/cli/cutter_text.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/contour/contour_file.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/contour/vanished.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/path/region/drawn_region.hpp"
#include "host-sim/surface/path/region/rest_region.hpp"
#include "host-sim/surface/path/region/slope_region.hpp"

namespace sim {
namespace {

constexpr double kMinRestMm = 0.02;
constexpr double kRestTolerances = 3.0;

void add_boundary_options(CLI::App& command, RegionOptions& options) {
  mark_file(command
                .add_option("--boundary",
                            options.boundary,
                            "Mill only within the closed contours of a drawing in machine "
                            "coordinates: SVG, DXF,\nJSON or contours as text; contours within "
                            "other contours are islands")
                ->type_name("FILE"),
            FileRole::kInput);
  const std::map<std::string, BoundarySide> sides{{"inside", BoundarySide::kInside},
                                                  {"on", BoundarySide::kOn},
                                                  {"outside", BoundarySide::kOutside}};
  command
      .add_option("--boundary-side",
                  options.side,
                  "Limit of the tool at the boundary: its rim stays inside, its tip goes up to the "
                  "line, or its\nrim goes beyond")
      ->transform(CLI::CheckedTransformer(sides))
      ->option_text("inside|on|outside [on]");
}

void add_rest_options(CLI::App& command, RegionOptions& options) {
  command
      .add_option("--rest-of",
                  options.rest_of,
                  "Larger tool with which the surface was milled: mill only where it left stock")
      ->type_name(kCutterForm);
  command
      .add_option("--rest-allowance",
                  options.rest_allowance_mm,
                  "Allowance that the larger tool left on the whole surface, mm")
      ->check(in_range(0.0, 100.0, "mm"))
      ->type_name("MM");
  command
      .add_option("--rest-depth",
                  options.rest_depth_mm,
                  "Thickness above which stock is a rest, mm; default: three times --tolerance, at "
                  "least 0.02")
      ->check(in_range(0.001, 100.0, "mm"))
      ->type_name("MM");
}

surface::SlopeRange slopes_of(const std::string& text) {
  const std::string_view all = text;
  const std::size_t colon = all.find(':');
  const auto least = surface::parsed_number(all.substr(0, colon));
  const auto most = colon == std::string_view::npos ? std::nullopt
                                                    : surface::parsed_number(all.substr(colon + 1));
  constexpr double kUpright = 90.0;
  if (least && most && *least >= 0.0 && *least < *most && *most <= kUpright) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    return {*least * kDegree, *most * kDegree};
  }
  throw std::invalid_argument(fmt::format(
      "--slope {}: is not LOW:HIGH in degrees from the level, 0 to 90, such as 0:35", text));
}

/// Returns the first fault of a drawing, and a remark if there are more.
std::string first_of(std::string_view faults) {
  const std::size_t end = faults.find('\n');
  if (end == std::string_view::npos) return std::string{faults};
  return fmt::format("{} (and more faults; kerfline drawing lists them)", faults.substr(0, end));
}

/// Returns the contours of each part of a drawing.
std::vector<Contour> drawn_in(const std::string& file, double tolerance_mm, InputFiles& inputs) {
  const std::string text = inputs.read_and_add("boundary", file);
  const OutlineOptions fit{.tolerance_mm = tolerance_mm};
  std::vector<Contour> areas;
  try {
    ContourFile read = contours_of(text, file, fit, Crossing::kRefused);
    for (const std::string& note : read.notes) terminal::print(stderr, "{}\n", note);
    for (ContourPart& part : read.parts) areas.push_back(std::move(part.contour));
  } catch (const FaultyDrawing& error) {
    throw std::invalid_argument{"--boundary: " + first_of(error.what())};
  } catch (const ContourTextError& error) {
    throw std::invalid_argument{fmt::format("--boundary: {}", error.what())};
  }
  return areas;
}

/// Prints the parts of an area that vanish in an offset.
void print_vanished(const std::string& file, const std::vector<Vanished>& found) {
  constexpr std::size_t kMaxPlaces = 20;
  for (std::size_t i = 0; i < std::min(found.size(), kMaxPlaces); ++i) {
    terminal::print(stderr, "{}: {} for the tool\n", file, found[i].text());
  }
  if (found.size() > kMaxPlaces) {
    terminal::print(
        stderr, "{}: {} more places vanish under the tool\n", file, found.size() - kMaxPlaces);
  }
}

/// Returns the area for the tool's centre in which the tool's rim reaches the boundary from one
/// side. It is `area` offset by `distance_mm`.
Contour moved(const std::string& file, const Contour& area, double distance_mm) {
  ContourOffset offsetter;
  try {
    Contour result = copy_of(offsetter.offset(area.view(), distance_mm));
    print_vanished(file, vanished(area, result, distance_mm, offsetter));
    return result;
  } catch (const NoOffset& error) {
    throw std::invalid_argument{fmt::format("--boundary {}: {}", file, error.what())};
  }
}

std::shared_ptr<const surface::MilledRegion> rest_of(const RegionOptions& options,
                                                     const surface::Mesh& mesh,
                                                     const surface::RowOptions& rows) {
  const surface::RestOptions rest{
      .larger = profile_of(cutter_of("--rest-of", options.rest_of)),
      .larger_allowance_mm = options.rest_allowance_mm,
      .depth_mm = options.rest_depth_mm > 0.0
                      ? options.rest_depth_mm
                      : std::max(kMinRestMm, kRestTolerances * rows.tolerance_mm),
      .allowance_mm = rows.allowance_mm,
      .floor_mm = rows.floor_mm};
  if (rest.larger.radius_mm <= rows.tool.radius_mm) {
    throw std::invalid_argument{
        fmt::format("--rest-of {}: is no larger than --tool, whose diameter is {:g} mm",
                    options.rest_of,
                    2.0 * rows.tool.radius_mm)};
  }
  if (rest.larger_allowance_mm - rest.allowance_mm >= rest.depth_mm) {
    throw std::invalid_argument{
        fmt::format("--rest-allowance: {:g} mm of stock are a rest everywhere; leave out "
                    "--rest-of, or take a --rest-depth above it",
                    rest.larger_allowance_mm)};
  }
  if (rest.depth_mm >= rows.tool.radius_mm) {
    throw std::invalid_argument{
        fmt::format("--rest-depth: {:g} mm is not less than the tool's radius", rest.depth_mm)};
  }
  return std::make_shared<surface::RestRegion>(mesh, rows.tool, rest);
}

}  // namespace

void add_region_options(CLI::App& command, RegionOptions& options) {
  add_boundary_options(command, options);
  command
      .add_option(
          "--slope",
          options.slope,
          "Mill only where the surface under the tool has a slope in this range, degrees "
          "from the level;\nranges with a common limit overlap by a quarter of the tool's radius")
      ->type_name("LOW:HIGH");
  add_rest_options(command, options);
}

void check_region_options(const RegionOptions& options, const std::string& surface) {
  if (options.boundary == "-" && surface == "-") {
    throw std::invalid_argument("--boundary: standard input is FILE already; name a file");
  }
  if (options.boundary.empty() && options.side != BoundarySide::kOn) {
    throw std::invalid_argument("--boundary-side: requires --boundary, a drawing");
  }
  if (!options.rest_of.empty()) return;
  if (options.rest_allowance_mm > 0.0) {
    throw std::invalid_argument("--rest-allowance: requires --rest-of, the larger tool");
  }
  if (options.rest_depth_mm > 0.0) {
    throw std::invalid_argument("--rest-depth: requires --rest-of, the larger tool");
  }
}

std::vector<Contour> boundary_areas_of(const RegionOptions& options,
                                       const surface::RowOptions& rows,
                                       InputFiles& inputs) {
  if (options.boundary.empty()) return {};
  std::vector<Contour> areas = drawn_in(options.boundary, rows.tolerance_mm, inputs);
  bool is_empty = true;
  for (Contour& area : areas) {
    const double radius = rows.tool.radius_mm;
    if (options.side == BoundarySide::kInside) area = moved(options.boundary, area, -radius);
    if (options.side == BoundarySide::kOutside) area = moved(options.boundary, area, radius);
    is_empty = is_empty && area.loop_ends.empty();
  }
  if (is_empty) {
    throw std::invalid_argument{fmt::format(
        "--boundary {}: the tool fits nowhere within it; take a smaller tool or --boundary-side on",
        options.boundary)};
  }
  return areas;
}

surface::MilledRegions regions_of(const RegionOptions& options,
                                  const surface::Mesh& mesh,
                                  const surface::RowOptions& rows,
                                  InputFiles& inputs) {
  surface::MilledRegions regions;
  if (!options.boundary.empty()) {
    regions.push_back(
        std::make_shared<surface::DrawnRegion>(boundary_areas_of(options, rows, inputs)));
  }
  if (!options.slope.empty()) {
    regions.push_back(std::make_shared<surface::SlopeRegion>(
        mesh, rows.tool, rows.floor_mm, slopes_of(options.slope)));
  }
  if (!options.rest_of.empty()) regions.push_back(rest_of(options, mesh, rows));
  return regions;
}

}  // namespace sim
