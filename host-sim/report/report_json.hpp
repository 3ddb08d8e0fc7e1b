#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "host-sim/report/report.hpp"

namespace sim {

/// The report as a JSON object. Keys are in this order, with the unit in the name:
///
/// | key                                                    | value                       |
/// |--------------------------------------------------------|-----------------------------|
/// | `job`                                                  | name of the file            |
/// | `version`                                              | that of Kerfline, and commit|
/// | `job_time_s`                                           | number                      |
/// | `path_length_mm`, `cut_length_mm`                      | number                      |
/// | `lines`, `refused_lines`, `blocks`                     | integer; no figure counts   |
/// |                                                        | refused lines               |
/// | `max_speed_mm_s`, `max_speed_mm_min`,                  | object with a number        |
/// | `max_acceleration_mm_s2`, `max_jerk_mm_s3`             | for each axis X Y Z A B C   |
/// | `bounds_mm`                                            | per axis `[least, greatest]`|
/// | `steps`                                                | per axis integer            |
/// | `max_path_deviation_mm`, `max_path_deviation_at_s`     | number                      |
/// | `energy_per_mm_ratio`: `least`, `mean`, `greatest`     | object: beam energy per mm  |
/// |                                                        | over S and F's, in windows  |
/// |                                                        | of 0.05 mm; null if no beam |
/// |                                                        | or $855…$857 are set        |
/// | `warnings`                                             | array of strings            |
/// | `faults`: `file`, `line`, `column`, `number`, `message`| array of objects            |
///
/// A, B and C are in degrees where a name says mm. A number that is not finite is null.
[[nodiscard]] nlohmann::ordered_json to_json(const Report& report);

/// Writes one report as an object, several as an array of them. Text that is not
/// UTF-8 gets U+FFFD in place of the bad bytes. Throws std::system_error naming the file.
void write_json(const std::string& file, std::span<const Report> reports);

}  // namespace sim
