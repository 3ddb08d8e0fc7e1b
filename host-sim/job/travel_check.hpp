#pragma once

#include <string>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Which axes need more room than they have ($130…$135; 0 is endless).
///
/// Where a job starts within the machine is known only at the machine, so what
/// counts is the extent of the motion: a job that is no larger than the travel
/// fits somewhere. One fault an axis, at the line that first goes too far, with
/// the column of the axis word where there is one.
[[nodiscard]] std::vector<Fault> check_travel(const ProgrammedPath& path,
                                              const cnc::Settings& settings,
                                              const std::string& file,
                                              const std::string& text);

}  // namespace sim
