#include "host-sim/cli/wall_carving.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/cli/wall_carve_options.hpp"
#include "host-sim/plot/picture_file.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"
#include "host-sim/wall/carve/beam_carver.hpp"
#include "host-sim/wall/carve/beam_strokes.hpp"
#include "host-sim/wall/carve/carved_mesh.hpp"
#include "host-sim/wall/carve/drawn_walls.hpp"
#include "host-sim/wall/carve/section_picture.hpp"
#include "host-sim/wall/carve/taper.hpp"
#include "host-sim/wall/carve/wall_report.hpp"
#include "host-sim/wall/solid_check.hpp"

namespace sim {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
/// Reserve in the limit of the angle between a drawn and a carved wall, degrees. The limit is the
/// sum of the beam's half angle, the angle by heat and this reserve.
constexpr double kBurnReserveDeg = 5.0;

constexpr const char* kTaperFooter =
    "CUTS has a line `drawn carved gain` for each measured wall: its angles from the vertical in\n"
    "degrees, and the --taper-gain with which it was cut.\n"
    "\n"
    "Example:\n"
    "  kerfline wall taper cuts.txt --half-angle 7";

/// Strokes of the beam for one block, with its name.
struct NamedStrokes {
  std::string name;
  std::vector<wall::BeamStroke> strokes;
};

std::vector<NamedStrokes> read_beams(const CarveOptions& options) {
  std::vector<NamedStrokes> beams;
  for (const std::string& file : {options.beams, options.beside}) {
    if (file.empty()) continue;
    beams.push_back({file, wall::read_strokes(InputFiles::read(file), options.depth_mm, file)});
  }
  return beams;
}

/// Returns the box around the part and the tips of all beams.
Eigen::AlignedBox3d box_of(const surface::Mesh& part, const std::vector<NamedStrokes>& beams) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : part.points) box.extend(point);
  const double top = box.max().z();
  for (const NamedStrokes& named : beams) {
    for (const wall::BeamStroke& stroke : named.strokes) {
      for (const wall::BeamPose& pose : stroke) {
        box.extend(Eigen::Vector3d{pose.tip - Eigen::Vector3d{0.0, 0.0, pose.depth_mm}});
      }
    }
  }
  box.max().z() = top;
  return box;
}

stock::StockBox stock_of(const Eigen::AlignedBox3d& box, double around_mm) {
  return {box.min().x() - around_mm,
          box.min().y() - around_mm,
          box.max().x() + around_mm,
          box.max().y() + around_mm,
          box.max().z(),
          box.min().z()};
}

double lowest_tip(const std::vector<NamedStrokes>& beams) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const NamedStrokes& named : beams) {
    for (const wall::BeamStroke& stroke : named.strokes) {
      for (const wall::BeamPose& pose : stroke) {
        lowest = std::min(lowest, pose.tip.z() - pose.depth_mm);
      }
    }
  }
  return lowest;
}

std::vector<wall::Columns> carve_blocks(const CarveOptions& options,
                                        const std::vector<NamedStrokes>& beams,
                                        const stock::StockBox& stock) {
  const std::string fault = wall::Columns::fault_of(stock, options.cell_mm);
  if (!fault.empty()) throw std::invalid_argument("--cell: " + fault);
  std::vector<wall::Columns> blocks;
  for (const NamedStrokes& named : beams) {
    wall::Columns& columns = blocks.emplace_back(stock, options.cell_mm);
    wall::BeamCarver carver{columns,
                            {.half_angle_rad = options.half_angle_deg * kRadiansPerDegree,
                             .heat_rad = options.heat_deg * kRadiansPerDegree,
                             .waist_mm = options.waist_mm}};
    for (const wall::BeamStroke& stroke : named.strokes) carver.carve(stroke);
    terminal::print(stderr,
                    "{}: {} strokes of {} moves in {} by {} columns, {:.1f} MB\n",
                    named.name,
                    named.strokes.size(),
                    carver.moves(),
                    columns.columns(),
                    columns.rows(),
                    static_cast<double>(columns.bytes()) / (1 << 20));
  }
  return blocks;
}

std::string caption_of(const std::string& name, const wall::WallReport::Figures& figures) {
  std::string text = fmt::format("{}: {} walls carved", name, figures.carved);
  if (figures.carved > 0) {
    text += fmt::format(", off the drawn angle by {:+.3f} degrees in the mean, {:.3f} at most",
                        figures.mean_off_deg,
                        figures.max_off_deg);
  }
  if (figures.missing > 0) text += fmt::format("; {} not carved", figures.missing);
  return text;
}

ExitStatus run_carve(const CarveOptions& options) {
  check_carve_options(options);
  const surface::SurfaceInput part =
      surface::read_surface(read_bytes(options.file), options.file, {.unit_mm = options.unit_mm});
  for (const std::string& note : part.notes) terminal::print(stderr, "{}\n", note);
  wall::require_solid(part.mesh, options.file);
  const std::vector<NamedStrokes> beams = read_beams(options);
  const stock::StockBox stock = stock_of(box_of(part.mesh, beams), options.around_mm);
  const std::vector<wall::Columns> blocks = carve_blocks(options, beams, stock);
  const std::vector<wall::DrawnWall> walls =
      wall::drawn_walls(part.mesh,
                        {.low_mm = lowest_tip(beams),
                         .high_mm = stock.top,
                         .cell_mm = options.cell_mm,
                         .burn_deg = options.half_angle_deg + options.heat_deg + kBurnReserveDeg});
  std::vector<const wall::Columns*> shown;
  shown.reserve(blocks.size());
  for (const wall::Columns& block : blocks) shown.push_back(&block);
  const wall::WallReport report = wall::report_walls(walls, shown);
  std::vector<wall::CarvedSection> sections;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    sections.push_back({&blocks[i], caption_of(beams[i].name, report.figures[i])});
    terminal::print(stderr, "{}\n", sections.back().caption);
  }
  if (!options.carved.empty()) wall::write_carved(options.carved, blocks.front());
  if (!options.picture.empty()) {
    write_picture(options.picture,
                  wall::draw_sections(options.file, sections, part.mesh, options.section_line()));
  }
  if (options.output.empty()) {
    terminal::write_data(report.text);
  } else {
    write_file(options.output, report.text);
  }
  return ExitStatus::kFine;
}

struct TaperOptions {
  std::string cuts;
  double half_angle_deg = 0.0;
};

ExitStatus run_taper(const TaperOptions& options) {
  const wall::TaperFit fit =
      wall::fit_taper(InputFiles::read(options.cuts), options.half_angle_deg, options.cuts);
  terminal::print(
      "heat leans walls by {:.3f} degrees; an additional lean of the beam reduces this by {:.3f} "
      "of its angle\n--taper-gain {:.4f}\n",
      fit.heat_deg,
      fit.response,
      fit.gain);
  terminal::print(stderr,
                  "{}: {} cuts, off by {:.3f} degrees (root mean square){}\n",
                  options.cuts,
                  fit.used,
                  fit.rest_deg,
                  fit.passed == 0
                      ? std::string{}
                      : fmt::format("; {} that an upright beam clears are not used", fit.passed));
  return ExitStatus::kFine;
}

}  // namespace

void add_wall_carving_commands(CLI::App& wall_command, ExitStatus& status) {
  CLI::App* carve = wall_command.add_subcommand(
      "carve", "Carve a block as beams burn it, and measure its walls.");
  const auto carving = std::make_shared<CarveOptions>();
  add_carve_options(*carve, *carving);
  carve->callback([carving, &status] { status = run_carve(*carving); });

  CLI::App* taper = wall_command.add_subcommand(
      "taper",
      "Find the --taper-gain that compensates the lean of walls by heat, from measured cuts.");
  taper->footer(kTaperFooter);
  const auto measured = std::make_shared<TaperOptions>();
  mark_file(taper->add_option("CUTS", measured->cuts, "File of measured walls")->required(),
            FileRole::kInput);
  taper
      ->add_option("--half-angle",
                   measured->half_angle_deg,
                   "Angle between the axis and the side of the beam, degrees")
      ->required()
      ->check(in_range(0.5, 80.0, "degrees"))
      ->type_name("DEG");
  taper->callback([measured, &status] { status = run_taper(*measured); });
}

}  // namespace sim
