#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/pocket_options.hpp"
#include "host-sim/cli/pocket_report.hpp"
#include "host-sim/contour/contour_file.hpp"
#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/contour/vanished.hpp"
#include "host-sim/plot/contour_picture.hpp"
#include "host-sim/pocket/areas.hpp"
#include "host-sim/pocket/drill_holes.hpp"
#include "host-sim/pocket/fitting_radius.hpp"
#include "host-sim/pocket/loop_contact.hpp"
#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/pocket/terraces.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using pocket::PathRows;
using pocket::Terrace;
using pocket::Terraces;

constexpr const char* kPocketFooter =
    "Each outer contour of FILE is a pocket, holes in it are islands, and contours within islands\n"
    "are pockets again. The top of the stock is Z 0. Passes are the paper's dynamic offset, exact\n"
    "for every corner, arc and island. They are as far apart as possible without stock left "
    "between\n"
    "them, and run from the middle outwards, without lifting where a link fits. In corners that\n"
    "are narrower than the tool, stock stays.\n"
    "With --rest-of, only the stock that a larger tool left is milled: corners, narrow regions.\n"
    "With --v-angle, shapes are carved, such as letters and lines of ornaments.\n"
    "\n"
    "Examples:\n"
    "  kerfline pocket tray.svg --tool 6 --depth 4 --depth-step 2 --feed 1200 --plunge-feed 300 "
    "\\\n"
    "    --spindle 16000 -o tray.nc --svg tray-passes.svg\n"
    "  kerfline pocket sign.svg --v-angle 60 --tool 12 --depth 4 --feed 900 --plunge-feed 200 \\\n"
    "    -o sign.nc\n"
    "\n"
    "Exit status: 0 fine, 1 the drawing has faults or the tool does not fit, 2 the call is wrong.";

/// Prints the parts of pockets into which the tool does not fit. Returns whether there are any.
bool report_unreached(const PocketCommandOptions& options, const std::vector<Contour>& areas) {
  constexpr std::size_t kMaxListed = 20;
  ContourOffset offsetter;
  std::size_t count = 0;
  // Texts that were printed: terraces may share a point, whose text is printed once.
  std::set<std::string> told;
  for (const Contour& area : areas) {
    const double fitting_mm = pocket::fitting_radius(area.view(), options.radius_mm(), offsetter);
    const double radius_mm = fitting_mm > 0.0 ? fitting_mm : options.radius_mm();
    const Contour locus = copy_of(offsetter.offset(area.view(), -radius_mm));
    for (const Vanished& gone : vanished(area, locus, -radius_mm, offsetter)) {
      if (gone.is_hole || !told.insert(gone.text()).second) continue;
      if (++count > kMaxListed) continue;
      terminal::print(stderr,
                      "{}: {} for a tool of {:g} mm; choose a smaller one with --tool\n",
                      options.file,
                      gone.text(),
                      options.tool_mm);
    }
  }
  if (count > kMaxListed) {
    terminal::print(stderr, "{}: and {} more\n", options.file, count - kMaxListed);
  }
  return count != 0;
}

/// Returns the connected areas of a terrace. If a stock is given, one of the areas is the
/// surroundings of the stock, together with the pockets that are open to them.
std::vector<Contour> areas_to_mill(const Terrace& terrace, const PocketCommandOptions& options) {
  const std::optional<pocket::StockBox> stock = options.stock_box();
  if (!stock) return pocket::areas_of(terrace.contours);
  const double margin_mm = pocket::margin_of(strategy_options_of(options));
  return pocket::areas_of(pocket::with_surroundings(terrace.contours, *stock, margin_mm));
}

/// Computes the paths of all pockets, for each pocket terrace by terrace.
class PocketMiller {
 public:
  explicit PocketMiller(const PocketCommandOptions& options)
      : options_{options}, planner_{strategy_options_of(options)} {}

  MilledDrawing mill(const std::vector<Terraces>& pockets) {
    std::vector<PathRows> paths;
    for (const Terraces& terraces : pockets) mill_one(terraces, paths);
    if (!fits_) {
      throw pocket::NoPocketPath{"the tool fits nowhere; choose a smaller one with --tool"};
    }
    if (paths.empty() && options_.rest_of_mm > 0.0) {
      throw pocket::NoPocketPath{fmt::format(
          "a tool of {:g} mm has left no stock in it; no program is needed", options_.rest_of_mm)};
    }
    if (paths.empty()) {
      throw pocket::NoPocketPath{"no pocket is within the stock; check the corners of --stock"};
    }
    for (const std::size_t index : pocket::short_order(paths)) milled_.append(paths[index]);
    milled_.floors_mm.assign(floors_mm_.begin(), floors_mm_.end());
    return std::move(milled_);
  }

 private:
  /// Appends the paths of a pocket: for a single terrace one path for each area, otherwise one path
  /// for all terraces.
  void mill_one(const Terraces& terraces, std::vector<PathRows>& paths) {
    PathRows all;
    std::uint32_t levels = 0;
    for (const Terrace& terrace : terraces) {
      floors_mm_.insert(terrace.to_mm);
      std::vector<PathRows> areas = mill_areas(terrace, levels);
      if (terraces.size() == 1) {
        paths.insert(paths.end(), areas.begin(), areas.end());
      } else if (!areas.empty()) {
        for (const std::size_t index : pocket::short_order(areas)) all.append(areas[index]);
      }
    }
    if (!all.points.empty()) paths.push_back(std::move(all));
    milled_.levels = std::max(milled_.levels, levels);
  }

  /// Mills the areas of a terrace into which the tool fits. Adds the number of the terrace's levels
  /// to `levels`.
  std::vector<PathRows> mill_areas(const Terrace& terrace, std::uint32_t& levels) {
    planner_.set_depth(terrace.to_mm - terrace.from_mm);
    std::vector<PathRows> paths;
    std::uint32_t most = 0;
    for (const Contour& area : areas_to_mill(terrace, options_)) {
      const double radius_mm =
          pocket::fitting_radius(area.view(), options_.radius_mm(), offsetter_);
      if (radius_mm == 0.0) continue;
      const pocket::MilledPocket one = planner_.mill(area.view(), radius_mm);
      fits_ = true;
      if (one.points.empty()) continue;
      most = std::max(most, one.levels);
      ++milled_.pockets;
      milled_.passes += one.passes;
      milled_.links += one.links;
      milled_.narrow.insert(milled_.narrow.end(), one.narrow.begin(), one.narrow.end());
      paths.emplace_back().append(one, -terrace.from_mm);
    }
    levels += most;
    return paths;
  }

  const PocketCommandOptions& options_;
  pocket::StrategyPlanner planner_;
  ContourOffset offsetter_;
  std::set<double> floors_mm_;
  MilledDrawing milled_;
  bool fits_ = false;  ///< Whether the tool fits into any area.
};

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
  if (paths.empty())
    throw pocket::NoPocketPath{"it has no shape that can be carved; draw closed contours"};
  milled.pockets = paths.size();
  for (const std::size_t index : pocket::short_order(paths)) milled.append(paths[index]);
  if (milled.wide_area_mm2 > 0.0) {
    terminal::print(stderr,
                    "{}: {:.1f} mm2 are too wide for {:g} mm of depth and stay; clear them with a "
                    "flat tool, or increase --tool or --depth\n",
                    options.file,
                    milled.wide_area_mm2,
                    wanted.greatest_depth_mm);
  }
  return milled;
}

std::string holes_program(const PocketCommandOptions& options,
                          const MilledDrawing& milled,
                          cnc::gcode::PrintGrid grid) {
  const PathRows holes = pocket::drill_holes(milled.path(), options.level_mm());
  return options.post.applied_to(
      program_of(holes.path(), mill_settings_of(options), grid, holes_heading(options, milled)));
}

void write_outputs(const PocketCommandOptions& options, const MilledDrawing& milled) {
  const cnc::gcode::PrintGrid grid{static_cast<std::uint8_t>(options.decimals)};
  const std::string program = options.post.applied_to(
      program_of(milled.path(), mill_settings_of(options), grid, pocket_heading(options, milled)));
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
  if (!options.holes.empty()) write_file(options.holes, holes_program(options, milled, grid));
  if (!options.report.empty()) write_file(options.report, pocket_report(options, milled));
}

/// Returns the depth that the call gives each loop of a part by its layer or colour.
std::vector<std::optional<double>> depths_of(const ContourPart& part,
                                             const std::vector<LayerDepth>& given) {
  std::vector<std::optional<double>> depths;
  for (const drawing::Layer& layer : part.layers) {
    std::optional<double>& depth = depths.emplace_back();
    for (const LayerDepth& one : given) {
      if (one.is_of(layer)) depth = one.depth_mm;
    }
  }
  return depths;
}

/// Checks the contours. Throws NoPocketPath if contours of one terrace touch, such as an island and
/// its wall.
void refuse_contacts(const std::vector<Terraces>& pockets) {
  for (const Terraces& terraces : pockets) {
    for (const Terrace& terrace : terraces) {
      const auto place = pocket::contact_between_loops(terrace.contours.view());
      if (!place) continue;
      throw pocket::NoPocketPath{fmt::format(
          "at {:.3f} {:.3f} two contours touch or cross; separate them, or draw them as one",
          place->x(),
          place->y())};
    }
  }
}

/// Reads the drawing; appends all its contours to `walls`.
std::vector<Terraces> read_pockets(const PocketCommandOptions& options,
                                   InputFiles& inputs,
                                   Contour& walls) {
  const std::string text = inputs.read_and_add("drawing", options.file);
  const ContourFile read = contours_of(text, options.file, options.outline, Crossing::kRefused);
  for (const std::string& note : read.notes) terminal::print(stderr, "{}\n", note);
  const std::vector<ContourPart>& parts = read.parts;
  const std::vector<LayerDepth> depths = layer_depths_of(options, parts);
  std::vector<Terraces> pockets;
  if (parts.empty()) throw pocket::NoPocketPath{"it has no contour; draw one"};
  for (const ContourPart& part : parts) {
    append_loops(part.contour.view(), walls);
    for (Terraces& terraces :
         pocket::terraces_of(part.contour, depths_of(part, depths), options.depth_mm)) {
      pockets.push_back(std::move(terraces));
    }
  }
  refuse_contacts(pockets);
  if (pockets.empty()) {
    throw pocket::NoPocketPath{"no contour in it is deeper than Z 0; give a depth with --depth-of"};
  }
  return pockets;
}

ExitStatus mill_file(const PocketCommandOptions& options, InputFiles& inputs) {
  Contour walls;
  const std::vector<Terraces> pockets = read_pockets(options, inputs, walls);
  std::vector<Contour> areas;
  for (const Terraces& terraces : pockets) {
    for (const Terrace& terrace : terraces) {
      for (Contour& area : areas_to_mill(terrace, options)) areas.push_back(std::move(area));
    }
  }
  const bool is_incomplete = !options.is_v_carving() && report_unreached(options, areas);
  if (is_incomplete && !options.anyway) {
    terminal::print(
        stderr,
        "kerfline: no program is written; --anyway mills the regions that the tool reaches{}\n",
        stale_note(options.output));
    return ExitStatus::kFaults;
  }
  MilledDrawing milled =
      options.is_v_carving() ? carve(options, areas) : PocketMiller{options}.mill(pockets);
  milled.walls = std::move(walls);
  milled.digests = inputs.digests();
  write_outputs(options, milled);
  return is_incomplete ? ExitStatus::kFaults : ExitStatus::kFine;
}

ExitStatus mill_or_tell(const PocketCommandOptions& options, InputFiles& inputs) {
  try {
    return mill_file(options, inputs);
  } catch (const ContourTextError& error) {
    terminal::print(stderr, "{}\n", error.what());
  } catch (const FaultyDrawing& error) {
    terminal::print_lines(stderr, std::string{error.what()} + "\n");
  } catch (const NoOffset& error) {
    terminal::print(stderr, "{}: {}\n", options.file, error.what());
  } catch (const pocket::NoPocketPath& error) {
    terminal::print(stderr, "{}: {}\n", options.file, error.what());
  }
  for (const std::string& output : {options.output, options.holes, options.report, options.svg}) {
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
    InputFiles inputs{options->output};
    apply_tool(*command, *options, inputs);
    check_pocket_options(*command, *options);
    options->post.read(*command, inputs, options->decimals);
    status = mill_or_tell(*options, inputs);
  });
}

}  // namespace sim
