#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/knowledge/experiment.hpp"

namespace sim {

/// The header of a file of test cuts, units in the names. Columns may be in any order.
inline constexpr std::string_view kExperimentHeader =
    "material,laser,gas_pressure_mpa,thickness_mm,power_w,speed_mm_min,"
    "kerf_top_mm,kerf_bottom_mm,dross_area_mm2,straightness_mm";

/// What a file of test cuts holds.
struct ExperimentFile {
  std::vector<Experiment> cuts;
  std::size_t unmeasured = 0;  ///< Lines of a form with no measurement in them.
};

/// Reads a CSV file of test cuts: the header, then one line each; fields may be quoted, lines
/// that are blank or begin with # do not count. Fields are separated by commas, or by the
/// semicolons or tabs of the header; then numbers may have a decimal comma. Empty columns at the
/// end of a line, and lines of separators alone, do not count either. Dross and straightness may be
/// empty, and are not judged then; a line in which nothing was measured is left out. Throws
/// std::invalid_argument saying `FILE:LINE: column NAME: reason` for the first thing that is wrong,
/// and where no line has a measurement.
/// @param laser the name that cuts without one get
[[nodiscard]] ExperimentFile read_experiment_file(std::string_view text,
                                                  const std::string& file,
                                                  const std::string& laser = {});

/// The cuts alone.
[[nodiscard]] std::vector<Experiment> read_experiments(std::string_view text,
                                                       const std::string& file);

}  // namespace sim
