#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "firmware/protocol/identity.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/pocket_options.hpp"
#include "host-sim/contour/contour_file.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/contour/vanished.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/plot/contour_picture.hpp"
#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using pocket::PocketPlan;

constexpr const char* kPocketFooter =
    "Each outer contour of FILE is a pocket, holes in it are islands, and contours within those "
    "are\n"
    "pockets again. The top of the stock is Z 0. Passes are the paper's dynamic offset made exact\n"
    "for every corner, arc and island: as far apart as nothing is left between them, driven from\n"
    "the middle outwards without lifting where a link fits. Corners narrower than the tool stay.\n"
    "\n"
    "Examples:\n"
    "  kerfline pocket tray.svg --tool 6 --depth 4 --depth-step 2 --feed 1200 --plunge-feed 300 "
    "\\\n"
    "    --spindle 16000 -o tray.nc --svg tray-passes.svg\n"
    "\n"
    "Exit status: 0 fine, 1 the drawing has faults or the tool does not fit, 2 the call is wrong.";

/// Lengths of a path by the use of its elements, mm.
struct PathLengths {
  double pass_mm = 0.0;
  double link_mm = 0.0;
  double entry_mm = 0.0;
  double between_rows_mm = 0.0;  ///< In the plane, in rapids.

  [[nodiscard]] double fed_mm() const { return pass_mm + link_mm + entry_mm; }
};

/// Adds a plan's lengths. @param last where the tool was, none before the first row
void add_lengths(const PocketPlan& plan,
                 std::vector<cnc::pocket::PathPoint<double>>& last,
                 PathLengths& lengths) {
  const auto path = plan.path();
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    for (std::uint32_t i = path.row_begin(row); i < path.row_ends[row]; ++i) {
      const auto& to = path.points[i];
      if (i == path.row_begin(row)) {
        if (!last.empty()) lengths.between_rows_mm += (to.point() - last.back().point()).norm();
      } else {
        const auto& from = path.points[i - 1];
        const cut::Stroke stroke{.from = from.point(), .to = to.point(), .bulge = from.bulge};
        const double length_mm = std::hypot(cut::length_of(stroke), to.z - from.z);
        using cnc::pocket::Use;
        (from.use == Use::kPass   ? lengths.pass_mm
         : from.use == Use::kLink ? lengths.link_mm
                                  : lengths.entry_mm) += length_mm;
      }
      last = {to};
    }
  }
}

/// The plans of all pockets as one path.
PocketPlan joined(const std::vector<PocketPlan>& plans) {
  PocketPlan all;
  for (const PocketPlan& plan : plans) {
    const auto before = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), plan.points.begin(), plan.points.end());
    for (const std::uint32_t end : plan.row_ends) all.row_ends.push_back(before + end);
    all.passes.insert(all.passes.end(), plan.passes.begin(), plan.passes.end());
    all.report.passes += plan.report.passes;
    all.report.levels = plan.report.levels;
    all.report.rows += plan.report.rows;
    all.report.links += plan.report.links;
  }
  return all;
}

std::vector<std::string> heading_of(const PocketCommandOptions& options, const PocketPlan& plan) {
  const std::string name =
      options.file == "-" ? options.file : std::filesystem::path{options.file}.filename().string();
  return {fmt::format("kerfline {} pocket: {}", cnc::identity::version(), name),
          fmt::format("tool {:g} mm, {:g} mm deep in {} levels, {} passes in each",
                      options.tool_mm,
                      options.depth_mm,
                      plan.report.levels,
                      plan.report.passes)};
}

nlohmann::ordered_json json_of(const PocketCommandOptions& options,
                               const PocketPlan& plan,
                               const PathLengths& lengths) {
  nlohmann::ordered_json report;
  report["drawing"] = options.file;
  report["version"] = cnc::identity::version();
  report["tool_mm"] = options.tool_mm;
  report["depth_mm"] = options.depth_mm;
  report["levels"] = plan.report.levels;
  report["passes"] = plan.report.passes;
  report["rows"] = plan.report.rows;
  report["links"] = plan.report.links;
  report["pass_length_mm"] = lengths.pass_mm;
  report["link_length_mm"] = lengths.link_mm;
  report["entry_length_mm"] = lengths.entry_mm;
  report["rapid_length_mm"] = lengths.between_rows_mm;
  return report;
}

/// Prints the parts of pockets that the tool does not fit into. True where there is any.
bool report_unreached(const PocketCommandOptions& options, const std::vector<Contour>& parts) {
  constexpr std::size_t kMostListed = 20;
  const double radius_mm = 0.5 * options.tool_mm;
  ContourOffset offsetter;
  std::size_t count = 0;
  for (const Contour& part : parts) {
    const auto locus = offsetter.offset(part.view(), -radius_mm);
    const Contour result{{locus.vertices.begin(), locus.vertices.end()},
                         {locus.loop_ends.begin(), locus.loop_ends.end()}};
    for (const Vanished& gone : vanished(part, result, -radius_mm, offsetter)) {
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

ExitStatus mill_file(const PocketCommandOptions& options) {
  const std::vector<Contour> parts = read_contour_file(options.file, options.outline);
  const bool is_incomplete = report_unreached(options, parts);
  if (is_incomplete && !options.anyway) {
    terminal::print(stderr,
                    "kerfline: no program is written; --anyway mills what the tool reaches{}\n",
                    stale_note(options.output));
    return ExitStatus::kFaults;
  }
  pocket::PocketPlanner planner;
  std::vector<PocketPlan> plans;
  Contour walls;
  for (const Contour& part : parts) {
    plans.push_back(planner.plan(part.view(), pocket_options_of(options)));
    for (std::size_t loop = 0; loop < part.loop_ends.size(); ++loop) {
      for (std::uint32_t i = part.view().loop_begin(loop); i < part.loop_ends[loop]; ++i) {
        walls.vertices.push_back(part.vertices[i]);
      }
      walls.end_loop();
    }
  }
  const PocketPlan plan = joined(plans);
  PathLengths lengths;
  std::vector<cnc::pocket::PathPoint<double>> last;
  add_lengths(plan, last, lengths);
  const std::string program =
      program_of(plan.path(),
                 options.mill,
                 cnc::gcode::PrintGrid{static_cast<std::uint8_t>(options.decimals)},
                 heading_of(options, plan));
  terminal::print(options.output.empty() ? stderr : stdout,
                  "{}: {} passes in {} levels, {} rows, {:.1f} mm at feeds\n",
                  options.file,
                  plan.report.passes,
                  plan.report.levels,
                  plan.report.rows,
                  lengths.fed_mm());
  if (options.output.empty()) {
    terminal::write_data(program);
  } else {
    write_file(options.output, program);
  }
  if (!options.svg.empty())
    write_file(options.svg, draw_contours(walls, plan.passes, options.file));
  if (!options.report.empty()) {
    write_file(options.report, dumped(json_of(options, plan, lengths)) + "\n");
  }
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
  command->callback([options, &status] { status = mill_or_tell(*options); });
}

}  // namespace sim
