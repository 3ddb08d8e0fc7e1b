#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/pocket_options.hpp"
#include "host-sim/cli/pocket_report.hpp"
#include "host-sim/contour/contour_file.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/contour/vanished.hpp"
#include "host-sim/plot/contour_picture.hpp"
#include "host-sim/pocket/areas.hpp"
#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using pocket::PathRows;

constexpr const char* kPocketFooter =
    "Each outer contour of FILE is a pocket, holes in it are islands, and contours within those "
    "are\n"
    "pockets again. The top of the stock is Z 0. Passes are the paper's dynamic offset made exact\n"
    "for every corner, arc and island: as far apart as nothing is left between them, driven from\n"
    "the middle outwards without lifting where a link fits. Corners narrower than the tool stay.\n"
    "With --v-angle, shapes are carved: letters, lines of ornaments.\n"
    "\n"
    "Examples:\n"
    "  kerfline pocket tray.svg --tool 6 --depth 4 --depth-step 2 --feed 1200 --plunge-feed 300 "
    "\\\n"
    "    --spindle 16000 -o tray.nc --svg tray-passes.svg\n"
    "  kerfline pocket sign.svg --v-angle 60 --tool 12 --depth 4 --feed 900 --plunge-feed 200 \\\n"
    "    -o sign.nc\n"
    "\n"
    "Exit status: 0 fine, 1 the drawing has faults or the tool does not fit, 2 the call is wrong.";

/// Prints the parts of pockets that the tool does not fit into. True where there is any.
bool report_unreached(const PocketCommandOptions& options, const std::vector<Contour>& areas) {
  constexpr std::size_t kMostListed = 20;
  ContourOffset offsetter;
  std::size_t count = 0;
  for (const Contour& area : areas) {
    const double fitting_mm = pocket::fitting_radius(area.view(), options.radius_mm(), offsetter);
    const double radius_mm = fitting_mm > 0.0 ? fitting_mm : options.radius_mm();
    const Contour locus = copy_of(offsetter.offset(area.view(), -radius_mm));
    for (const Vanished& gone : vanished(area, locus, -radius_mm, offsetter)) {
      if (gone.is_hole || ++count > kMostListed) continue;
      terminal::print(stderr,
                      "{}: {} for a tool of {:g} mm; choose a smaller one with --tool\n",
                      options.file,
                      gone.text(),
                      options.tool_mm);
    }
  }
  if (count > kMostListed) {
    terminal::print(stderr, "{}: and {} more\n", options.file, count - kMostListed);
  }
  return count != 0;
}

/// Appends the loops of one contour to another.
void append(const Contour& contour, Contour& to) {
  const auto before = static_cast<std::uint32_t>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), contour.vertices.begin(), contour.vertices.end());
  for (const std::uint32_t end : contour.loop_ends) to.loop_ends.push_back(before + end);
}

/// Appends paths in an order with short rapids.
void append_in_order(const std::vector<PathRows>& paths, MilledDrawing& milled) {
  milled.pockets = paths.size();
  for (const std::size_t index : pocket::short_order(paths)) milled.append(paths[index]);
}

/// Mills the areas that the tool fits into.
MilledDrawing mill(const PocketCommandOptions& options, const std::vector<Contour>& areas) {
  pocket::StrategyPlanner planner{strategy_options_of(options)};
  ContourOffset offsetter;
  MilledDrawing milled;
  std::vector<PathRows> paths;
  for (const Contour& area : areas) {
    const double radius_mm = pocket::fitting_radius(area.view(), options.radius_mm(), offsetter);
    if (radius_mm == 0.0) continue;
    pocket::MilledPocket one = planner.mill(area.view(), radius_mm);
    milled.levels = one.levels;
    milled.passes += one.passes;
    milled.links += one.links;
    milled.narrow.insert(milled.narrow.end(), one.narrow.begin(), one.narrow.end());
    paths.push_back(std::move(one));
  }
  if (paths.empty()) {
    throw pocket::NoPocketPath{"the tool fits nowhere; choose a smaller one with --tool"};
  }
  append_in_order(paths, milled);
  return milled;
}

MilledDrawing carve(const PocketCommandOptions& options, const std::vector<Contour>& areas) {
  const pocket::VCarveOptions wanted = carve_options_of(options);
  MilledDrawing milled;
  std::vector<PathRows> paths;
  for (const Contour& area : areas) {
    pocket::VCarving one = pocket::v_carve(area.view(), wanted);
    milled.carved_depth_mm = std::max(milled.carved_depth_mm, one.depth_mm);
    milled.wide_area_mm2 += one.wide_area_mm2;
    if (!one.points.empty()) paths.push_back(std::move(one));
  }
  if (paths.empty()) throw pocket::NoPocketPath{"no shape in it can be carved"};
  append_in_order(paths, milled);
  if (milled.wide_area_mm2 > 0.0) {
    terminal::print(stderr,
                    "{}: {:.1f} mm2 are too wide for {:g} mm of depth and stay; clear them with a "
                    "flat tool, or take a larger one with --tool or --depth\n",
                    options.file,
                    milled.wide_area_mm2,
                    wanted.greatest_depth_mm);
  }
  return milled;
}

void write_outputs(const PocketCommandOptions& options, const MilledDrawing& milled) {
  const std::string program =
      program_of(milled.path(),
                 mill_settings_of(options),
                 cnc::gcode::PrintGrid{static_cast<std::uint8_t>(options.decimals)},
                 pocket_heading(options, milled));
  terminal::print(
      options.output.empty() ? stderr : stdout, "{}\n", pocket_summary(options, milled));
  if (options.output.empty()) {
    terminal::write_data(program);
  } else {
    write_file(options.output, program);
  }
  if (!options.svg.empty()) {
    write_file(options.svg, draw_tool_path(milled.walls, milled.path(), options.file));
  }
  if (!options.report.empty()) write_file(options.report, pocket_report(options, milled));
}

ExitStatus mill_file(const PocketCommandOptions& options) {
  std::vector<Contour> areas;
  Contour walls;
  for (const Contour& part : read_contour_file(options.file, options.outline)) {
    append(part, walls);
    for (Contour& area : pocket::areas_of(part)) areas.push_back(std::move(area));
  }
  if (areas.empty()) throw pocket::NoPocketPath{"no contour in it; draw one"};
  const bool is_incomplete = !options.is_v_carving() && report_unreached(options, areas);
  if (is_incomplete && !options.anyway) {
    terminal::print(stderr,
                    "kerfline: no program is written; --anyway mills what the tool reaches{}\n",
                    stale_note(options.output));
    return ExitStatus::kFaults;
  }
  MilledDrawing milled = options.is_v_carving() ? carve(options, areas) : mill(options, areas);
  milled.walls = std::move(walls);
  write_outputs(options, milled);
  return is_incomplete ? ExitStatus::kFaults : ExitStatus::kFine;
}

ExitStatus mill_or_tell(const PocketCommandOptions& options) {
  try {
    return mill_file(options);
  } catch (const ContourTextError& error) {
    terminal::print(stderr, "{}\n", error.what());
  } catch (const FaultyDrawing& error) {
    terminal::print_lines(stderr, std::string{error.what()} + "\n");
  } catch (const NoOffset& error) {
    terminal::print(stderr, "{}: {}\n", options.file, error.what());
  } catch (const pocket::NoPocketPath& error) {
    terminal::print(stderr, "{}: {}\n", options.file, error.what());
  }
  for (const std::string& output : {options.output, options.report, options.svg}) {
    const std::string stale = stale_note(output);
    if (!stale.empty()) terminal::print(stderr, "kerfline: nothing is written{}\n", stale);
  }
  return ExitStatus::kFaults;
}

}  // namespace

void add_pocket_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command =
      app.add_subcommand("pocket", "Make a program that mills the pockets of a drawing.");
  command->footer(kPocketFooter);
  const auto options = std::make_shared<PocketCommandOptions>();
  add_pocket_options(*command, *options);
  command->callback([options, command, &status] {
    check_pocket_options(*command, *options);
    status = mill_or_tell(*options);
  });
}

}  // namespace sim
