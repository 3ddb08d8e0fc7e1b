#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/knowledge/experiment.hpp"

namespace sim {

/// Header of a file of test cuts, with units in the names. Columns may be in any order.
inline constexpr std::string_view kExperimentHeader =
    "material,laser,gas_pressure_mpa,thickness_mm,power_w,speed_mm_min,"
    "kerf_top_mm,kerf_bottom_mm,dross_area_mm2,straightness_mm";

/// Content of a file of test cuts.
struct ExperimentFile {
  std::vector<Experiment> cuts;
  std::size_t unmeasured = 0;  ///< Number of lines without a measurement, which were left out.
};

/// Reads a CSV file of test cuts: the header, then one cut on each line. Fields may be quoted.
/// Blank lines and lines that begin with # are ignored.
///
/// Fields are separated by commas, or by semicolons or tabs if the header has them. In the latter
/// case numbers may have a decimal comma. Empty columns at the end of a line, and lines that
/// consist of separators, are ignored, too. Dross and straightness may be empty; the cut is then
/// accepted or rejected without them. A line without any measurement is left out.
///
/// Throws std::invalid_argument with `FILE:LINE: column NAME: reason` for the first fault, and if
/// no line has a measurement.
/// @param laser name for cuts that do not name their laser
[[nodiscard]] ExperimentFile read_experiment_file(std::string_view text,
                                                  const std::string& file,
                                                  const std::string& laser = {});

/// Returns the cuts of read_experiment_file(), without its other results.
[[nodiscard]] std::vector<Experiment> read_experiments(std::string_view text,
                                                       const std::string& file);

}  // namespace sim
