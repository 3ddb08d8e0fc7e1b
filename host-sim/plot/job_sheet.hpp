#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/cut_account.hpp"
#include "host-sim/cut/cut_report.hpp"

namespace sim {

/// Returns the pages of a job's sheet as SVG documents of A4 (see write_pdf()): what is cut from
/// which material, under which conditions, the picture with the numbers of the cuts, a table of the
/// parts, what the job costs, notes and warnings. It has no date and no names but those of drawing
/// and material, so that the same job has the same sheet.
[[nodiscard]] std::vector<std::string> job_sheet(const cut::CutJob& job,
                                                 const cut::CutFigures& figures,
                                                 const cut::CutAccount& account);

}  // namespace sim
