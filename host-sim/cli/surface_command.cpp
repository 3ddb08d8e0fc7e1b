#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "firmware/protocol/identity.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/cutter_text.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cli/surface_commands.hpp"
#include "host-sim/cli/surface_options.hpp"
#include "host-sim/cli/surface_regions.hpp"
#include "host-sim/report/progress_bar.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/approach.hpp"
#include "host-sim/surface/path/parallel_path.hpp"
#include "host-sim/surface/path/rough_path.hpp"
#include "host-sim/surface/path/surface_program.hpp"
#include "host-sim/surface/path/waterline_path.hpp"
#include "host-sim/surface/tip_heights.hpp"
#include "host-sim/surface/triangle_file.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

constexpr const char* kSurfaceFooter =
    "FILE is XYZ text or CSV of a measured grid, STL, PLY, or a height map as ESRI ASCII grid,\n"
    "GeoTIFF, TIFF, PGM, PNG or JSON. Four neighbours of a grid are two triangles, which share\n"
    "the diagonal from the first point of a row to the second of the next row; --mesh writes "
    "these\n"
    "triangles. The tool runs over the surface in straight rows, or in lines of constant height "
    "or\n"
    "at constant distance from the border. It touches points, edges and facets and never cuts in.\n"
    "Arcs are kept: in G18 along X, in G19 along Y, and in G17 at constant height.\n"
    "\n"
    "Examples:\n"
    "  kerfline surface scan.xyz --tool ball:4 --step 0.3 --feed 1500 --plunge-feed 500 \\\n"
    "    --spindle 18000 -o scan.nc\n"
    "  kerfline surface relief.stl --tool 6,bull,1 --step 2 --allowance 0.5 --floor -20 \\\n"
    "    --feed 2000 --plunge-feed 400 -o rough.nc\n"
    "\n"
    "  kerfline surface probe-grid --x 0:60 --y 0:40 --pitch 2 --safe 5 --depth -8 --feed 60 \\\n"
    "    -o probe.nc\n"
    "\n"
    "Exit status: 0 fine, 2 the call or FILE is wrong.";

/// Rotates points so that --approach points down, then moves them by --move.
void place(std::vector<Eigen::Vector3d>& points, const SurfaceCommandOptions& options) {
  if (const auto& approach = options.approach; !approach.empty()) {
    const Eigen::Matrix3d turn =
        surface::turn_for_approach({approach[0], approach[1], approach[2]});
    for (Eigen::Vector3d& point : points) point = turn * point;
  }
  if (options.move_mm.empty()) return;
  const Eigen::Vector3d way{options.move_mm[0], options.move_mm[1], options.move_mm[2]};
  for (Eigen::Vector3d& point : points) point += way;
}

/// Returns the height of rapids. Throws std::invalid_argument for a height that is not above the
/// path and the surface.
double safe_height_of(const SurfaceCommandOptions& options, double top_mm) {
  constexpr double kAboveAll = 5.0;
  if (!options.safe_mm) return std::ceil(top_mm) + kAboveAll;
  if (*options.safe_mm > top_mm) return *options.safe_mm;
  throw std::invalid_argument{
      fmt::format("--safe: {:g} mm is not above the path and the surface, which reach {:.3f} mm",
                  *options.safe_mm,
                  top_mm)};
}

PatchOptions patches_of(const SurfaceCommandOptions& options) {
  constexpr double kFitOfPaper = 1.0;
  PatchOptions patches = options.patches;
  if (patches.fit_mm == 0.0)
    patches.fit_mm = patches.like_paper ? kFitOfPaper : options.tolerance_mm;
  return patches;
}

/// Returns a text on the kind of path, for the program's heading.
std::string manner_of(const SurfaceCommandOptions& options) {
  if (options.pencil.is_wanted) {
    return fmt::format("along valleys sharper than {:g} degrees", options.pencil.angle_deg);
  }
  if (options.paths == SurfacePaths::kWaterline) return "finishing in waterlines";
  if (options.paths == SurfacePaths::kContour) return "finishing along contours";
  if (options.paths == SurfacePaths::kRough) {
    return fmt::format("roughing in levels of {:g} mm", options.levels.depth_mm);
  }
  const std::string kind = options.levels.depth_mm > 0.0
                               ? fmt::format("layers of {:g} mm", options.levels.depth_mm)
                               : std::string{"finishing"};
  return fmt::format("{} in rows at {:g} degrees", kind, options.angle_deg.value_or(0.0));
}

std::vector<std::string> heading_of(const SurfaceCommandOptions& options,
                                    const surface::SurfaceProgramFigures& figures,
                                    const InputFiles& inputs) {
  const std::string name =
      options.file == "-" ? options.file : std::filesystem::path{options.file}.filename().string();
  std::vector<std::string> lines{
      fmt::format("kerfline {} surface: {}", cnc::identity::version(), name),
      fmt::format("tool {}, tolerance {:g} mm, {} elements",
                  options.tool,
                  options.tolerance_mm,
                  figures.arcs + figures.lines),
      fmt::format("{}, {:g} mm of stock stay", manner_of(options), options.allowance_mm)};
  if (options.patches.smooth) {
    lines.push_back(fmt::format("along smooth patches within {:g} mm", patches_of(options).fit_mm));
  }
  for (const ProgramDigest& digest : inputs.digests()) lines.push_back(text_of(digest));
  return lines;
}

std::string report_of(const SurfaceCommandOptions& options,
                      const surface::SurfacePath& path,
                      const surface::SurfaceProgramFigures& figures,
                      const InputFiles& inputs) {
  nlohmann::ordered_json report;
  report["surface"] = options.file;
  report["version"] = cnc::identity::version();
  report["tool"] = options.tool;
  report["tolerance_mm"] = options.tolerance_mm;
  report["allowance_mm"] = options.allowance_mm;
  if (options.patches.smooth) report["fit_tolerance_mm"] = patches_of(options).fit_mm;
  report["arcs"] = figures.arcs;
  report["lines"] = figures.lines;
  report["lifts"] = figures.lifts;
  report["stretches_without_arcs"] = path.without_arcs;
  report["row_length_mm"] = figures.row_mm;
  report["link_length_mm"] = figures.link_mm;
  report["lowest_mm"] = figures.lowest_mm;
  report["highest_mm"] = figures.highest_mm;
  report["digests"] = json_of(inputs.digests());
  return dumped(report) + "\n";
}

/// Returns the path of a surface along lines or in levels.
/// @param rough stock and limits of the tip, used for levels only
surface::SurfacePath path_with_progress(const surface::Mesh& mesh,
                                        surface::RowOptions rows,
                                        const surface::RoughOptions& rough,
                                        SurfacePaths paths) {
  using Clock = std::chrono::steady_clock;
  ProgressBar bar{stderr, is_terminal(stderr), Clock::now()};
  rows.progress = [&bar](double share) { bar.update(share, "lines", Clock::now()); };
  if (paths == SurfacePaths::kRough) return rough_path(mesh, rows, rough);
  if (paths == SurfacePaths::kWaterline) return waterline_path(mesh, rows);
  if (paths == SurfacePaths::kContour) return parallel_path(mesh, rows);
  return row_path(mesh, rows);
}

/// Returns the path along valleys, and prints the number of valleys that were too short for a path.
surface::SurfacePath valleys_of(const SurfaceCommandOptions& options,
                                const surface::Mesh& mesh,
                                const stock::Cutter& cutter,
                                const surface::RowOptions& rows) {
  const surface::PencilOptions pencil = pencil_options_of(options, cutter);
  surface::PencilPath found = pencil_path(mesh, rows, pencil);
  if (found.left_out > 0) {
    terminal::print(stderr,
                    "{}: {} valleys shorter than {:g} mm are left out\n",
                    options.file,
                    found.left_out,
                    pencil.min_mm);
  }
  return std::move(found.path);
}

void write_path(const SurfaceCommandOptions& options,
                const surface::Mesh& mesh,
                const stock::Cutter& cutter,
                InputFiles& inputs,
                const std::shared_ptr<const surface::SmoothTips>& smooth) {
  surface::RowOptions rows = row_options_of(options, cutter);
  rows.smooth = smooth;
  surface::RoughOptions rough{.boundary = {}, .stock_margin_mm = options.stock.margin_mm};
  if (options.paths == SurfacePaths::kRough) {
    rough.boundary = boundary_areas_of(options.regions, rows, inputs);
  } else {
    rows.regions = regions_of(options.regions, mesh, rows, inputs);
  }
  const surface::SurfacePath path =
      options.pencil.is_wanted ? valleys_of(options, mesh, cutter, rows)
                               : path_with_progress(mesh, std::move(rows), rough, options.paths);
  const surface::SurfaceProgramFigures figures = figures_of(path);
  pocket::MillSettings mill = options.mill;
  mill.safe_mm = safe_height_of(
      options,
      std::max({figures.highest_mm, top_of(mesh), options.stock.top_mm.value_or(top_of(mesh))}));
  const cnc::gcode::PrintGrid grid{static_cast<std::uint8_t>(options.decimals)};
  std::optional<double> ramp_slope;
  if (options.levels.ramp_deg > 0.0)
    ramp_slope = std::tan(options.levels.ramp_deg * std::numbers::pi / 180.0);
  const std::string program = options.post.applied_to(
      program_of(path, mill, grid, heading_of(options, figures, inputs), ramp_slope));
  terminal::print(
      options.output.empty() ? stderr : stdout,
      "{}: {} arcs, {} lines, {:.1f} mm of rows and {:.1f} mm of links, Z {:.3f} to {:.3f}\n",
      options.file,
      figures.arcs,
      figures.lines,
      figures.row_mm,
      figures.link_mm,
      figures.lowest_mm,
      figures.highest_mm);
  if (options.output.empty()) {
    terminal::write_data(program);
  } else {
    write_file(options.output, program);
  }
  if (!options.report.empty()) {
    write_file(options.report, report_of(options, path, figures, inputs));
  }
  draw_path(options.pictures,
            mesh,
            {.path = path, .safe_mm = mill.safe_mm, .stock_top_mm = options.stock.top_mm},
            cutter);
}

void write_heights(const SurfaceCommandOptions& options,
                   const surface::Mesh& mesh,
                   const stock::Cutter& cutter,
                   const std::string& places) {
  const std::string heights =
      surface::tip_heights(mesh, profile_of(cutter), places, options.query.points);
  if (options.query.heights.empty()) {
    terminal::write_data(heights);
  } else {
    write_file(options.query.heights, heights);
  }
}

/// Returns the grid of an input, rotated and moved as the options require. Throws
/// std::invalid_argument for a mesh.
surface::PointGrid grid_of(const surface::SurfaceInput& input,
                           const SurfaceCommandOptions& options) {
  if (!input.grid) {
    throw std::invalid_argument{fmt::format(
        "{}: patches fit a grid of points, and this is a mesh; give a grid or a height map",
        options.file)};
  }
  surface::PointGrid grid = *input.grid;
  place(grid.points, options);
  return grid;
}

/// Returns whether the controller has arcs in all planes of the path. Rows and the links between
/// them have arcs in G18 and G19, lines of constant height in G17.
bool knows_arcs_of_path(const SurfaceCommandOptions& options) {
  const bool is_level =
      options.paths == SurfacePaths::kWaterline || options.paths == SurfacePaths::kRough;
  if (is_level) return options.post.knows_arcs(cnc::Plane::kXY);
  return options.post.knows_arcs(cnc::Plane::kZX) && options.post.knows_arcs(cnc::Plane::kYZ);
}

ExitStatus run_surface(const SurfaceCommandOptions& options, InputFiles& inputs) {
  const stock::Cutter cutter = cutter_of("--tool", options.tool);
  const std::string bytes = read_bytes(options.file);
  inputs.add("surface", options.file, bytes);
  surface::SurfaceInput input = surface::read_surface(bytes, options.file, options.reading);
  for (const std::string& note : input.notes) {
    terminal::print(stderr, "{}\n", note);
  }
  place(input.mesh.points, options);
  // All checks that may refuse the call come first, so that nothing is written if it is refused.
  const std::string places = options.wants_heights() ? InputFiles::read(options.query.points) : "";
  surface::PointGrid grid;
  if (options.wants_patches()) grid = grid_of(input, options);
  if (options.wants_heights()) write_heights(options, input.mesh, cutter, places);
  std::shared_ptr<const surface::SmoothTips> smooth;
  const PatchOptions patches = patches_of(options);
  if (patches.smooth) smooth = smooth_tips(grid, row_options_of(options, cutter), patches);
  if (options.wants_program()) write_path(options, input.mesh, cutter, inputs, smooth);
  if (smooth) {
    draw_patches(options.pictures, reported_patches(*smooth, patches));
  } else if (options.wants_patches()) {
    draw_patches(options.pictures, fit_patches(grid, cutter, patches));
  }
  draw_surface(options.pictures, input, cutter);
  if (!options.mesh.empty()) write_file(options.mesh, surface::ply_of(input.mesh));
  return ExitStatus::kFine;
}

}  // namespace

void add_surface_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command =
      app.add_subcommand("surface", "Mill a measured or modelled surface, or measure one.");
  command->footer(kSurfaceFooter);
  const auto options = std::make_shared<SurfaceCommandOptions>();
  add_surface_options(*command, *options);
  add_probe_grid_command(*command, status);
  command->callback([options, command, &status] {
    if (!command->get_subcommands().empty()) return;
    check_surface_options(*options);
    InputFiles inputs{options->output};
    options->post.read(*command, inputs, options->decimals);
    if (!knows_arcs_of_path(*options)) {
      options->lines_only = true;
    }
    status = run_surface(*options, inputs);
  });
}

}  // namespace sim
