#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "host-sim/report/report.hpp"

namespace sim {

/// Returns the report as a JSON object. The keys are in this order; their names contain the unit:
///
/// | key                                                    | value                       |
/// |--------------------------------------------------------|-----------------------------|
/// | `job`                                                  | name of the file            |
/// | `version`                                              | version of Kerfline, commit |
/// | `job_time_s`                                           | number                      |
/// | `path_length_mm`, `cut_length_mm`                      | number                      |
/// | `lines`, `refused_lines`, `blocks`                     | integer; the other figures  |
/// |                                                        | exclude refused lines       |
/// | `max_speed_mm_s`, `max_speed_mm_min`,                  | object with a number        |
/// | `max_acceleration_mm_s2`, `max_jerk_mm_s3`             | for each axis X Y Z A B C   |
/// | `bounds_mm`                                            | per axis `[least, greatest]`|
/// | `steps`                                                | per axis integer            |
/// | `max_speed_deg_s`, `max_speed_deg_min`,                | as above, for A B C only    |
/// | `max_acceleration_deg_s2`, `max_jerk_deg_s3`,          |                             |
/// | `bounds_deg`                                           |                             |
/// | `measuring_error`: `max_speed`, `max_acceleration`,    | object, per axis number:    |
/// | `max_jerk`, `bounds`                                   | error by reading steps, in  |
/// |                                                        | the unit of the figure      |
/// | `max_path_deviation_mm`, `max_path_deviation_at_s`     | number                      |
/// | `energy_per_mm_ratio`: `least`, `mean`, `greatest`     | object: beam energy per mm  |
/// |                                                        | as a share of the energy by |
/// |                                                        | S and F, in 0.05 mm windows;|
/// |                                                        | null without a beam or with |
/// |                                                        | $855…$857                   |
/// | `warnings`                                             | array of strings            |
/// | `faults`: `file`, `line`, `column`, `number`, `message`| array of objects            |
///
/// Objects whose key has a unit in mm also contain A, B and C, in degrees, for compatibility.
/// Numbers have at most six decimals. A number that is not finite is null.
[[nodiscard]] nlohmann::ordered_json to_json(const Report& report);

/// Returns JSON as text, with numbers rounded to six decimals. Bytes that are not valid UTF-8 are
/// replaced by U+FFFD.
/// @param indent number of spaces for each level
[[nodiscard]] std::string dumped(nlohmann::ordered_json json, int indent = 2);

/// Writes one report as an object, or several reports as an array of objects. Bytes that are not
/// valid UTF-8 are replaced by U+FFFD. Throws std::system_error with the name of the file.
void write_json(const std::string& file, std::span<const Report> reports);

}  // namespace sim
