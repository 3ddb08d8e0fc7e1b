#include "host-sim/cli/cut_outputs.hpp"

#include <nlohmann/json.hpp>

#include "host-sim/cut/cut_account.hpp"
#include "host-sim/plot/cut_animation.hpp"
#include "host-sim/plot/cut_picture.hpp"
#include "host-sim/plot/job_sheet.hpp"
#include "host-sim/plot/pdf.hpp"
#include "host-sim/plot/png.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {

void write_pictures(const CutOutputOptions& options,
                    const cut::CutJob& job,
                    const cut::Timeline& timeline,
                    const cut::EdgeFigures* edges) {
  if (options.svg.empty() && options.png.empty()) return;
  const std::string svg = draw_cuts({job.drawn, job.plan, &timeline}, job.drawn.file, edges);
  if (!options.svg.empty()) write_file(options.svg, svg);
  if (!options.png.empty()) write_png(options.png, svg);
}

void account_for(const CutOutputOptions& options,
                 const cut::CutJob& job,
                 const cut::Timeline& timeline,
                 double job_time_s,
                 std::FILE* told,
                 nlohmann::ordered_json& report) {
  const cut::CutAccount account =
      account_of(job.drawn, job.plan, timeline, job_time_s, options.prices);
  for (const std::string& line : lines_of(account, job.drawn)) {
    terminal::print(told, "{}\n", line);
  }
  add_to_report(report, account, job.drawn);
  const CutScene scene{job.drawn, job.plan, &account.timeline};
  if (!options.animation.empty()) {
    write_file(options.animation, animate_cuts(scene, job.drawn.file, {options.animation_s}));
  }
  if (!options.job_sheet.empty()) {
    write_pdf(options.job_sheet, job_sheet(job, figures_of(job.plan), account), job.drawn.file);
  }
}

}  // namespace sim
