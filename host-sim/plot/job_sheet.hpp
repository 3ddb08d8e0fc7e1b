#pragma once

#include <string>
#include <vector>

#include "host-sim/cut/cut_account.hpp"
#include "host-sim/cut/cut_report.hpp"

namespace sim {

/// Returns the pages of the sheet of a job as SVG documents of A4 size (see write_pdf()). The sheet
/// states the drawing, the material and the cutting conditions. It contains the picture with the
/// numbers of the cuts, a table of the parts, the costs of the job, notes and warnings. It contains
/// no date and no names except those of drawing and material, so that the same job always has the
/// same sheet.
[[nodiscard]] std::vector<std::string> job_sheet(const cut::CutJob& job,
                                                 const cut::CutFigures& figures,
                                                 const cut::CutAccount& account);

}  // namespace sim
