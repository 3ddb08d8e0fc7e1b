#include "host-sim/cli/cut_frame_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <vector>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

/// Greatest power along a frame, % of full power. The beam only has to be visible; more power may
/// burn the material.
constexpr double kMaxFramePercent = 5.0;
constexpr double kMaxFrameFeed = 1.0e6;  ///< Greatest feed of a frame, mm/min.

std::vector<std::string> frame_heading(const CutFrameOptions& options, const cut::CutJob& job) {
  const bool is_box = options.shape == cut::FrameShape::kBox;
  return {fmt::format("kerfline cut: frame of {}",
                      std::filesystem::path{job.drawn.file}.filename().string()),
          fmt::format("{} of all cuts, at {:g} mm/min, {}",
                      is_box ? "the box" : "the hull",
                      options.feed_mm_min,
                      options.power_percent > 0.0
                          ? fmt::format("{:g} percent of full power", options.power_percent)
                          : std::string{"beam off"})};
}

}  // namespace

void add_cut_frame_options(CLI::App& command, CutFrameOptions& options) {
  mark_file(
      command
          .add_option("--frame", options.file, "Write a program that traces the border of the job")
          ->type_name("FILE"),
      FileRole::kOutput);
  const std::map<std::string, cut::FrameShape> shapes{{"hull", cut::FrameShape::kHull},
                                                      {"box", cut::FrameShape::kBox}};
  command
      .add_option("--frame-shape",
                  options.shape,
                  "Border of all cuts: their convex hull, or their box along X and Y")
      ->transform(CLI::CheckedTransformer(shapes))
      ->option_text("hull|box [hull]");
  command
      .add_option("--frame-power",
                  options.power_percent,
                  "Power along the frame, % of full power; 0 keeps the beam off, for machines "
                  "without a visible beam")
      ->check(in_range(0.0, kMaxFramePercent, "%"))
      ->type_name("%")
      ->capture_default_str();
  command.add_option("--frame-feed", options.feed_mm_min, "Feed along the frame, mm/min")
      ->check(in_range(1.0, kMaxFrameFeed, "mm/min"))
      ->type_name("MM/MIN")
      ->capture_default_str();
}

void write_frame(const CutFrameOptions& options,
                 const cut::CutJob& job,
                 const CutRun& run,
                 const PostOption& post) {
  if (options.file.empty()) return;
  const cut::FrameSettings settings{
      options.shape, 0.01 * options.power_percent, options.feed_mm_min};
  write_file(options.file,
             post.applied_to(frame_program(frame_of(job.plan, options.shape),
                                           settings,
                                           job.beam,
                                           cnc::gcode::PrintGrid{run.decimals},
                                           frame_heading(options, job))));
}

}  // namespace sim
