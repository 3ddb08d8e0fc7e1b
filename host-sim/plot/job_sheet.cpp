#include "host-sim/plot/job_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/plot/cut_layers.hpp"
#include "host-sim/plot/grid.hpp"
#include "host-sim/plot/sheet_pages.hpp"
#include "host-sim/report/duration_text.hpp"

namespace sim {
namespace {

using cut::CutAccount;
using cut::CutFigures;
using cut::CutJob;
using cut::PartRow;
using Cells = std::vector<std::string>;

constexpr std::size_t kMaxNotes = 60;

/// Returns the material as a text such as `CSP 1N, 2 mm. `; empty if the job names no material.
std::string material_text(const CutJob& job) {
  if (job.record.name.empty()) return {};
  const cut::LayerPlan& layer = job.plan.layers[job.plan.cuts.front().layer];
  return fmt::format(
      "{}, {:g} mm. ", job.record.name, from_thousandths(layer.condition.cut.thickness_um));
}

std::string name_of_file(const CutJob& job) {
  return std::filesystem::path{job.drawn.file}.filename().string();
}

std::string lead_text(const cut::Lead& lead) {
  switch (lead.kind) {
    case cut::LeadKind::kLine:
      return fmt::format("line {:g}", lead.length_mm);
    case cut::LeadKind::kArc:
      return fmt::format("arc {:g}", lead.length_mm);
    default:
      return "none";
  }
}

void add_figures(SheetPages& pages,
                 const CutJob& job,
                 const CutFigures& figures,
                 const CutAccount& account) {
  const Extent extent = extent_of({job.drawn, job.plan});
  pages.add_text(fmt::format("{}Power: S{:g} is {:g} {}, {}.",
                             material_text(job),
                             job.beam.full_power_s,
                             job.beam.full_power_w,
                             job.beam.knows_watts ? "W" : "%",
                             job.beam.follows_speed ? "it follows the speed" : "constant"));
  pages.add_text(
      fmt::format("{:.1f} × {:.1f} mm with leads; {} cuts, {:.1f} mm cut, {:.1f} mm rapid; {}.",
                  extent.width_mm(),
                  extent.height_mm(),
                  figures.cuts,
                  figures.cut_length_mm,
                  figures.rapid_length_mm,
                  duration_text(account.timeline.total_s())));
}

void add_conditions(SheetPages& pages, const CutJob& job, const CutAccount& account) {
  const double rest = SheetPages::width_pt() - 385.0;
  const std::vector<SheetColumn> columns{{"Layer", 0.6 * rest},
                                         {"Colour", 0.4 * rest},
                                         {"Cuts", 40.0, true},
                                         {job.beam.knows_watts ? "W" : "%", 50.0, true},
                                         {"mm/min", 55.0, true},
                                         {"Kerf mm", 60.0, true},
                                         {"Pierce s", 60.0, true},
                                         {"Lead in", 60.0, true},
                                         {"Out", 60.0, true}};
  std::vector<Cells> rows;
  for (std::size_t i = 0; i < job.plan.layers.size(); ++i) {
    if (account.cuts_of_layers[i] == 0) continue;
    const cut::LayerPlan& layer = job.plan.layers[i];
    const std::string& name = job.drawn.layers[i].name;
    rows.push_back(
        {name.empty() ? "(no name)" : name,
         job.drawn.layers[i].colour,
         fmt::format("{}", account.cuts_of_layers[i]),
         fmt::format("{:g}", from_thousandths(layer.condition.cut.power_mw)),
         fmt::format("{:g}", from_thousandths(layer.condition.cut.speed_um_min)),
         is_engraved(layer.settings.side) ? "-" : fmt::format("{:.4f}", layer.condition.kerf_mm),
         fmt::format("{:g}", layer.settings.pierce_s),
         lead_text(layer.settings.lead_in),
         lead_text(layer.settings.lead_out)});
  }
  pages.add_heading("Conditions");
  pages.add_table(columns, rows);
}

/// Appends the picture of the sheet. It is drawn at a larger size and then reduced to the page, so
/// that its lines and letters are fine.
void add_sheet_picture(SheetPages& pages, const CutJob& job, const CutAccount& account) {
  constexpr double kFineness = 2.0;
  constexpr double kLabelsPx = 64.0;
  constexpr double kTallestPt = 430.0;
  const CutScene scene{job.drawn, job.plan, &account.timeline};
  const Extent framed = framed_cuts(extent_of(scene));
  const double inner_pt = SheetPages::width_pt() - 1.5 * kLabelsPx / kFineness;
  const double natural_pt = inner_pt * framed.height_mm() / framed.width_mm();
  const Box box = pages.take_box(std::clamp(natural_pt, 90.0, kTallestPt) + kLabelsPx / kFineness);
  const double width_px = kFineness * box.width_px;
  const double height_px = kFineness * box.height_px;
  std::string& out = pages.page();
  fmt::format_to(std::back_inserter(out),
                 "<svg x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" viewBox=\"0 0 "
                 "{:.2f} {:.2f}\">\n",
                 box.left_px,
                 box.top_px,
                 box.width_px,
                 box.height_px,
                 width_px,
                 height_px);
  const View view{framed, {kLabelsPx, 0.0, width_px - 1.5 * kLabelsPx, height_px - kLabelsPx}};
  add_grid(out, view);
  add_cut_layers(out, scene, view);
  out += "</svg>\n";
  pages.add_text(
      "Dots with the numbers of the cuts are pierces, and dashed arrows are rapids. At a coloured "
      "pierce the sheet is warm, because other pierces were close to it shortly before.");
}

void add_times(SheetPages& pages, const CutAccount& account) {
  std::string text;
  const auto sums = account.timeline.by_kind();
  for (std::size_t i = 0; i < cut::kTimeKinds; ++i) {
    if (!(sums[i] > 0.0)) continue;
    text += fmt::format("{}{} {}",
                        text.empty() ? "" : ", ",
                        title_of(static_cast<cut::TimeKind>(i)),
                        duration_text(sums[i]));
  }
  pages.add_heading("Time");
  pages.add_text(fmt::format("{} in all: {}.", duration_text(account.timeline.total_s()), text));
  if (!account.prices.is_given()) return;
  pages.add_heading("Cost");
  pages.add_text(fmt::format("{} in all: machine {} at {} an hour, sheet {}.",
                             amount_text(account.cost.total(), account.prices),
                             amount_text(account.cost.machine, account.prices),
                             amount_text(account.prices.per_hour, account.prices),
                             amount_text(account.cost.material, account.prices)));
}

Cells cells_of(const PartRow& part, const cut::PriceList& prices) {
  const auto copies = static_cast<double>(part.copies);
  Cells cells{fmt::format("{}", part.number),
              part.name,
              fmt::format("{}", part.copies),
              fmt::format("{:g}", static_cast<double>(part.pierces) / copies),
              fmt::format("{:.1f}", part.cut_length_mm / copies),
              duration_text(part.time_s / copies)};
  if (prices.is_given()) {
    cells.push_back(fmt::format("{:.2f}", part.cost.total() / copies));
    cells.push_back(fmt::format("{:.2f}", part.cost.total()));
  }
  return cells;
}

Cells totals_of(const CutAccount& account) {
  PartRow sum;
  for (const PartRow& part : account.parts) {
    sum.copies += part.copies;
    sum.pierces += part.pierces;
    sum.cut_length_mm += part.cut_length_mm;
  }
  Cells cells{"",
              "in all",
              fmt::format("{}", sum.copies),
              fmt::format("{}", sum.pierces),
              fmt::format("{:.1f}", sum.cut_length_mm),
              duration_text(account.timeline.total_s())};
  if (account.prices.is_given()) {
    cells.emplace_back("");
    cells.push_back(fmt::format("{:.2f}", account.cost.total()));
  }
  return cells;
}

void add_parts_table(SheetPages& pages, const CutAccount& account) {
  const bool has_price = account.prices.is_given();
  const std::string money = account.prices.currency;
  std::vector<SheetColumn> columns{{"No.", 34.0},
                                   {"Part", 0.0},
                                   {"Copies", 48.0, true},
                                   {"Pierces", 50.0, true},
                                   {"Cut mm", 62.0, true},
                                   {"Time", 76.0, true}};
  if (has_price) {
    columns.push_back({money.empty() ? "each" : money + " each", 66.0, true});
    columns.push_back({"in all", 62.0, true});
  }
  double fixed_pt = 0.0;
  for (const SheetColumn& column : columns) fixed_pt += column.width_pt;
  columns[1].width_pt = SheetPages::width_pt() - fixed_pt;
  std::vector<Cells> rows;
  for (const PartRow& part : account.parts) rows.push_back(cells_of(part, account.prices));
  rows.push_back(totals_of(account));
  pages.add_heading("Parts", 50.0);
  pages.add_text(
      "No. is the number of the last cut of the first copy in the picture. Pierces, length and "
      "time are those of one copy, including the rapids to it.");
  pages.add_table(columns, rows);
}

void add_notes(SheetPages& pages, const CutJob& job) {
  std::vector<std::string> notes = job.notes;
  for (const auto* faults : {&job.plan.faults, &job.plan.warnings}) {
    for (const drawing::Fault& fault : *faults) {
      notes.push_back(to_string(fault, name_of_file(job)));
    }
  }
  if (notes.empty()) return;
  pages.add_heading("Notes and warnings");
  for (std::size_t i = 0; i < std::min(notes.size(), kMaxNotes); ++i) {
    pages.add_text("• " + notes[i]);
  }
  if (notes.size() > kMaxNotes) {
    pages.add_text(fmt::format("and {} more; the report of the job lists all of them",
                               notes.size() - kMaxNotes));
  }
}

}  // namespace

std::vector<std::string> job_sheet(const CutJob& job,
                                   const CutFigures& figures,
                                   const CutAccount& account) {
  SheetPages pages{"kerfline cut: " + name_of_file(job)};
  pages.add_title("Job sheet: " + name_of_file(job));
  add_figures(pages, job, figures, account);
  add_conditions(pages, job, account);
  add_sheet_picture(pages, job, account);
  add_times(pages, account);
  add_parts_table(pages, account);
  add_notes(pages, job);
  return pages.finish();
}

}  // namespace sim
