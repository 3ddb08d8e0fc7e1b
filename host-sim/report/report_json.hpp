#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "host-sim/report/report.hpp"

namespace sim {

/// Returns the report as a JSON object. Keys are in this order, with the unit in the name:
///
/// | key                                                    | value                       |
/// |--------------------------------------------------------|-----------------------------|
/// | `job`                                                  | name of the file            |
/// | `version`                                              | Kerfline's, with its commit |
/// | `job_time_s`                                           | number                      |
/// | `path_length_mm`, `cut_length_mm`                      | number                      |
/// | `lines`, `refused_lines`, `blocks`                     | integer; the other figures  |
/// |                                                        | leave out refused lines     |
/// | `max_speed_mm_s`, `max_speed_mm_min`,                  | object with a number        |
/// | `max_acceleration_mm_s2`, `max_jerk_mm_s3`             | for each axis X Y Z A B C   |
/// | `bounds_mm`                                            | per axis `[least, greatest]`|
/// | `steps`                                                | per axis integer            |
/// | `max_speed_deg_s`, `max_speed_deg_min`,                | same kinds, for A B C only  |
/// | `max_acceleration_deg_s2`, `max_jerk_deg_s3`,          |                             |
/// | `bounds_deg`                                           |                             |
/// | `measuring_error`: `max_speed`, `max_acceleration`,    | object, per axis number:    |
/// | `max_jerk`, `bounds`                                   | error of reading steps, in  |
/// |                                                        | the figure's own unit       |
/// | `max_path_deviation_mm`, `max_path_deviation_at_s`     | number                      |
/// | `energy_per_mm_ratio`: `least`, `mean`, `greatest`     | object: beam energy per mm  |
/// |                                                        | divided by that of S and F, |
/// |                                                        | windows of 0.05 mm; null if |
/// |                                                        | no beam or $855…$857 set    |
/// | `warnings`                                             | array of strings            |
/// | `faults`: `file`, `line`, `column`, `number`, `message`| array of objects            |
///
/// Keys in mm have A, B and C, too, in degrees, as in earlier versions. Numbers have at most six
/// decimals. A number that is not finite is null.
[[nodiscard]] nlohmann::ordered_json to_json(const Report& report);

/// Returns JSON as text, with numbers rounded to six decimals. In text that is not UTF-8, U+FFFD
/// replaces the bad bytes.
/// @param indent spaces for each level
[[nodiscard]] std::string dumped(nlohmann::ordered_json json, int indent = 2);

/// Writes one report as an object, several as an array of objects. In text that is not UTF-8,
/// U+FFFD replaces the bad bytes. Throws std::system_error naming the file.
void write_json(const std::string& file, std::span<const Report> reports);

}  // namespace sim
