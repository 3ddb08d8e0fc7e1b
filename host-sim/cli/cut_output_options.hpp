#pragma once

#include <string>

#include "host-sim/cut/price.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Files that `kerfline cut` writes, and the prices for the cost of a job. A file without a name is
/// not written, except for the program.
struct CutOutputOptions {
  std::string program;  ///< File for the program; empty for the standard output.
  std::string report;
  std::string svg;
  std::string png;
  std::string animation;
  double animation_s = 30.0;  ///< Greatest duration of the animation; longer jobs are shown faster.
  std::string job_sheet;
  cut::PriceList prices{};
};

/// Adds the options to the command.
/// @param options outlives the command
void add_cut_output_options(CLI::App& command, CutOutputOptions& options);

}  // namespace sim
