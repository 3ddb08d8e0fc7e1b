#pragma once

#include <string>

#include "host-sim/cli/cut_runs.hpp"
#include "host-sim/cli/post_option.hpp"
#include "host-sim/cut/cut_report.hpp"
#include "host-sim/cut/frame_program.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline cut` for the frame of a job.
struct CutFrameOptions {
  std::string file;  ///< File to write; empty for none.
  cut::FrameShape shape = cut::FrameShape::kHull;
  double power_percent = 0.0;
  double feed_mm_min = 3000.0;
};

/// Adds `--frame`, `--frame-shape`, `--frame-power` and `--frame-feed`.
void add_cut_frame_options(CLI::App& command, CutFrameOptions& options);

/// Writes the frame program of a job, in the form of a post, if the options name a file.
/// @pre the job has a cut
void write_frame(const CutFrameOptions& options,
                 const cut::CutJob& job,
                 const CutRun& run,
                 const PostOption& post);

}  // namespace sim
