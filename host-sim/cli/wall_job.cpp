#include "host-sim/cli/wall_job.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "firmware/protocol/identity.hpp"
#include "host-sim/report/progress_bar.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/trace/output_file.hpp"
#include "host-sim/wall/layer/falling_shadow.hpp"
#include "host-sim/wall/path/wall_program.hpp"
#include "host-sim/wall/removal_record.hpp"

namespace sim {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
/// Least area of an overhang that is reported, mm²; a smaller area is rounding.
constexpr double kMinUndercutMm2 = 1.0e-3;
/// S word of the full power.
constexpr double kFullS = 1000.0;

/// Layers of a job, with the results of their computation.
struct WallJob {
  wall::LayerOptions layers;
  std::size_t layer_count = 0;
  std::size_t cut_layers = 0;  ///< Number of layers in which material is removed.
  wall::Undercut undercut;
  wall::BurnFigures figures;
  std::string program;
  std::string beams;
};

wall::LayerOptions layers_of(const WallOptions& options,
                             const surface::Mesh& part,
                             InputFiles& inputs) {
  wall::LayerOptions layers = options.job.layers;
  if (!options.job.record.empty()) {
    const wall::RemovalRecord record{inputs.read_and_add("record", options.job.record),
                                     options.job.record};
    layers.layer_mm = record.depth_of_pass(options.job.power_w, options.job.feed_mm_min);
  }
  if (options.job.stock_top_mm) {
    layers.above_mm = *options.job.stock_top_mm - top_of(part);
    if (layers.above_mm < 0.0) {
      throw std::invalid_argument(fmt::format("--stock-top: {:g} mm is below the part's top, {:g}",
                                              *options.job.stock_top_mm,
                                              top_of(part)));
    }
  }
  return layers;
}

std::vector<std::string> heading_of(const WallOptions& options,
                                    const wall::LayerOptions& layers,
                                    const InputFiles& inputs) {
  const WallJobOptions& job = options.job;
  const std::string name =
      options.file == "-" ? options.file : std::filesystem::path{options.file}.filename().string();
  std::vector<std::string> lines{
      fmt::format("kerfline {} wall: {}", cnc::identity::version(), name),
      fmt::format("layers of {:g} mm, hatch {:g} mm from {:g} degrees, turning by {:g}",
                  layers.layer_mm,
                  job.strokes.hatch_mm,
                  job.strokes.angle_deg,
                  job.strokes.turn_deg),
      fmt::format("beam of {:g} degrees half angle and {:g} mm waist, {}",
                  options.half_angle_deg,
                  job.strokes.waist_mm,
                  job.avoids ? fmt::format("clear of the part by {:g} degrees, tilt up to {:g}",
                                           options.clear_deg() - options.half_angle_deg,
                                           options.max_tilt_deg)
                             : std::string{"upright everywhere"}),
      fmt::format("turns up to {:g} degrees/mm, {:g} W at {:g} mm/min",
                  job.turn_rate_deg_per_mm,
                  job.power_w,
                  job.feed_mm_min)};
  for (const ProgramDigest& digest : inputs.digests()) lines.push_back(text_of(digest));
  return lines;
}

wall::BurnSettings burn_of(const WallJobOptions& job, double top_mm) {
  const double full = job.full_power_w > 0.0 ? job.full_power_w : job.power_w;
  return {.axes = job.axes,
          .feed_mm_min = job.feed_mm_min,
          .power_s = kFullS * job.power_w / full,
          .follows_speed = !job.constant_power,
          .turn_rate_rad_per_mm = job.turn_rate_deg_per_mm * kDegree,
          .safe_mm = std::ceil(top_mm) + job.safe_above_mm,
          .decimals = job.decimals};
}

WallJob job_of(const WallOptions& options, const surface::Mesh& part, InputFiles& inputs) {
  using Clock = std::chrono::steady_clock;
  const WallJobOptions& asked = options.job;
  WallJob job;
  job.layers = layers_of(options, part, inputs);
  const wall::Obstacles obstacles{part};
  // A tip that is no farther from a wall than `waist_mm` counts as touching the wall, because the
  // waist of the beam touches it.
  const wall::Obstacles touched{part, wall::kTouchMm + asked.strokes.waist_mm};
  const wall::BeamFinder finder{obstacles,
                                touched,
                                {.tilt = {.half_angle_rad = options.clear_deg() * kDegree,
                                          .max_rad = options.max_tilt_deg * kDegree},
                                 .waist_mm = asked.strokes.waist_mm,
                                 .avoids = asked.avoids,
                                 .allows_overlap = asked.allows_lean}};
  const wall::StrokeTracer tracer{finder,
                                  {.axes = asked.axes,
                                   .step_mm = asked.step_mm,
                                   .turn_rate_rad_per_mm = asked.turn_rate_deg_per_mm * kDegree,
                                   .swing_rad = asked.swing_deg * kDegree}};
  wall::LayerRegions regions{part, job.layers};
  wall::StrokeOptions strokes = asked.strokes;
  strokes.has_contour = !asked.without_contour;
  wall::LayerStrokes laid{regions.stock(), strokes};
  wall::WallProgram program{burn_of(asked, regions.top_mm()),
                            heading_of(options, job.layers, inputs)};
  ProgressBar bar{stderr, is_terminal(stderr), Clock::now()};
  job.layer_count = regions.count();
  for (std::size_t i = 0; i < regions.count(); ++i) {
    const wall::Layer layer = regions.next();
    job.cut_layers += layer.areas.empty() ? 0 : 1;
    for (const wall::Stroke& stroke : laid.strokes_of(layer, i)) {
      const std::vector<wall::BeamRun> runs = tracer.runs_of(stroke, layer.height_mm);
      program.add(runs);
      if (!asked.beams.empty()) append_beam_lines(runs, job.beams);
    }
    bar.update(
        static_cast<double>(i + 1) / static_cast<double>(regions.count()), "layers", Clock::now());
  }
  job.undercut = regions.undercut();
  job.figures = program.figures();
  job.program = program.take_text();
  return job;
}

double mean_tilt_deg(const wall::BurnFigures& figures) {
  return figures.burnt_mm > 0.0 ? figures.tilt_mm / figures.burnt_mm / kDegree : 0.0;
}

std::string report_of(const WallOptions& options, const WallJob& job, const InputFiles& inputs) {
  const wall::BurnFigures& figures = job.figures;
  const Eigen::Vector3d& place = job.undercut.place;
  nlohmann::ordered_json report;
  report["wall"] = options.file;
  report["version"] = cnc::identity::version();
  report["half_angle_deg"] = options.half_angle_deg;
  report["layer_mm"] = job.layers.layer_mm;
  report["layers"] = job.layer_count;
  report["layers_cut"] = job.cut_layers;
  report["strokes"] = figures.runs;
  report["beams"] = figures.beams;
  report["burnt_length_mm"] = figures.burnt_mm;
  report["dark_length_mm"] = figures.dark_mm;
  report["mean_tilt_deg"] = mean_tilt_deg(figures);
  report["greatest_tilt_deg"] = figures.max_tilt_rad / kDegree;
  report["greatest_turn_deg_per_mm"] = figures.max_turn_rad_per_mm / kDegree;
  report["slowed_length_mm"] = figures.slowed_mm;
  report["tips_out_of_reach"] = figures.lost;
  report["beams_in_part"] = figures.overlaps;
  report["greatest_angle_in_part_deg"] = figures.max_overlap_rad / kDegree;
  report["undercut_mm2"] = job.undercut.area_mm2;
  if (job.undercut.area_mm2 > kMinUndercutMm2) {
    report["undercut_at"] = {place.x(), place.y(), place.z()};
  }
  report["digests"] = json_of(inputs.digests());
  return dumped(report) + "\n";
}

void print_figures(const WallOptions& options, const WallJob& job) {
  const wall::BurnFigures& figures = job.figures;
  std::FILE* stream = options.output.empty() ? stderr : stdout;
  terminal::print(stream,
                  "{}: {} layers of {:g} mm, {} strokes, {} beams, {:.1f} mm burnt and {:.1f} mm "
                  "with the beam off; tilt {:.3f} degrees at most, {:.3f} in the mean\n",
                  options.file,
                  job.cut_layers,
                  job.layers.layer_mm,
                  figures.runs,
                  figures.beams,
                  figures.burnt_mm,
                  figures.dark_mm,
                  figures.max_tilt_rad / kDegree,
                  mean_tilt_deg(figures));
  if (figures.lost > 0) {
    terminal::print(stderr,
                    "{}: {} tips are out of reach; --beams lists them, --allow-lean burns them\n",
                    options.file,
                    figures.lost);
  }
  if (figures.overlaps > 0) {
    terminal::print(stderr,
                    "{}: {} beams enter the part, by up to {:.3f} degrees\n",
                    options.file,
                    figures.overlaps,
                    figures.max_overlap_rad / kDegree);
  }
  if (job.undercut.area_mm2 > kMinUndercutMm2) {
    const Eigen::Vector3d& place = job.undercut.place;
    terminal::print(
        stderr,
        "{}: the part overhangs {:.3f} mm2, most at {:.3f} {:.3f} {:.3f}; the stock below stays\n",
        options.file,
        job.undercut.area_mm2,
        place.x(),
        place.y(),
        place.z());
  }
}

}  // namespace

ExitStatus write_wall_job(const WallOptions& options,
                          const surface::Mesh& part,
                          InputFiles& inputs) {
  const WallJob job = job_of(options, part, inputs);
  if (job.cut_layers == 0) {
    surface::refuse(options.file,
                    0,
                    fmt::format("leaves nothing to remove in {} layers of {:g} mm",
                                job.layer_count,
                                job.layers.layer_mm),
                    "decrease --layer, increase --depth or give a --stock-margin");
  }
  if (job.figures.runs == 0 && options.job.avoids) {
    surface::refuse(options.file,
                    0,
                    fmt::format("all {} tips are out of reach", job.figures.lost),
                    "increase --max-tilt, or give --allow-lean");
  }
  print_figures(options, job);
  if (options.output.empty()) {
    terminal::write_data(job.program);
  } else {
    write_file(options.output, job.program);
  }
  if (!options.job.beams.empty()) write_file(options.job.beams, job.beams);
  if (!options.job.report.empty()) {
    write_file(options.job.report, report_of(options, job, inputs));
  }
  return job.figures.lost == 0 ? ExitStatus::kFine : ExitStatus::kFaults;
}

}  // namespace sim
