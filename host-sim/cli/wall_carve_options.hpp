#pragma once

#include <string>
#include <vector>

#include "host-sim/wall/carve/section.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline wall carve`: names of files, empty for none, and numbers.
struct CarveOptions {
  std::string file;
  double unit_mm = 1.0;
  std::string beams;
  std::string beside;
  double half_angle_deg = 0.0;
  double heat_deg = 0.0;
  double waist_mm = 0.0;
  double depth_mm = 0.0;
  double cell_mm = 0.007;
  double around_mm = 0.0;
  std::vector<double> section{};  ///< X and Y of both ends of the section; empty for none.
  std::string picture;
  std::string carved;
  std::string output;

  /// Returns the line of the section.
  /// @pre there is a section
  [[nodiscard]] wall::SectionLine section_line() const {
    return {{section[0], section[1]}, {section[2], section[3]}};
  }
};

/// Adds the options, and the text that `--help` prints below them.
void add_carve_options(CLI::App& command, CarveOptions& options);

/// Checks the options. Throws std::invalid_argument for options that exclude each other.
void check_carve_options(const CarveOptions& options);

}  // namespace sim
