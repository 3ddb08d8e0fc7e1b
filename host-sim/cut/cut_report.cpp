#include "host-sim/cut/cut_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "host-sim/cut/burnt_pictures.hpp"
#include "host-sim/cut/kerf_notes.hpp"
#include "host-sim/cut/order_report.hpp"
#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/cut/safety.hpp"
#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/report/duration_text.hpp"

namespace sim::cut {
namespace {

using Json = nlohmann::ordered_json;

bool is_cut(const CutPlan& plan, std::size_t layer) {
  return std::ranges::any_of(plan.cuts, [layer](const Cut& cut) { return cut.layer == layer; });
}

std::string name_of_drawing(const drawing::Drawing& drawn) {
  return std::filesystem::path{drawn.file}.filename().string();
}

Json json_of(const std::vector<drawing::Fault>& faults, const std::string& file) {
  Json rows = Json::array();
  for (const drawing::Fault& fault : faults) {
    Json row;
    row["kind"] = name_of(fault.kind);
    row["entity"] = fault.entity.name;
    row["line"] = fault.entity.line;
    row["column"] = fault.entity.column;
    row["place_mm"] =
        fault.place_mm ? Json{fault.place_mm->x(), fault.place_mm->y()} : Json(nullptr);
    row["message"] = to_string(fault, file);
    rows.push_back(row);
  }
  return rows;
}

std::string line_of(const SharedLineFigures& shared) {
  return fmt::format(
      "{} lines between parts cut once, {:.1f} mm; gaps exceed the kerf by {:.3f} mm",
      shared.lines,
      shared.length_mm,
      shared.max_off_mm);
}

/// Returns `1800 W at 4000 mm/min`, with `percent` instead of `W` if the power in watts is not
/// known.
std::string condition_text(const Condition& condition, const Beam& beam) {
  return fmt::format("{:g} {} at {:g} mm/min",
                     from_thousandths(condition.cut.power_mw),
                     beam.knows_watts ? "W" : "percent",
                     from_thousandths(condition.cut.speed_um_min));
}

/// Returns the line about a layer: `layer "cut" red: CSP 1N, 2 mm; 1800 W at 4000 mm/min; kerf
/// 0.5617 mm`.
std::string layer_line(const CutJob& job, std::size_t index) {
  const LayerPlan& plan = job.plan.layers[index];
  const drawing::Layer& layer = job.drawn.layers[index];
  std::string line = fmt::format("layer \"{}\" {}: ", layer.name, layer.colour);
  if (!job.record.name.empty()) {
    line += fmt::format(
        "{}, {:g} mm; ", job.record.name, from_thousandths(plan.condition.cut.thickness_um));
  }
  line += fmt::format("{}; {}", condition_text(plan.condition, job.beam), width_text(plan));
  if (job.is_kerf_given && !is_engraved(plan.settings.side)) line += ", given";
  const LayerSettings& settings = plan.settings;
  if (settings.passes > 1) line += fmt::format("; {} passes", settings.passes);
  if (settings.passes > 1 && settings.z_step_mm > 0.0) {
    line += fmt::format(", Z {:g} mm lower each", settings.z_step_mm);
  }
  return line;
}

/// Returns a text with the power at the greatest S. It also says whether the power follows the
/// speed.
std::string full_power_text(const Beam& beam) {
  const std::string power =
      beam.knows_watts ? fmt::format("{:g} W", beam.full_power_w) : "full power, 100 percent";
  return fmt::format("S{:g} is {}; {}",
                     beam.full_power_s,
                     power,
                     beam.follows_speed ? "power follows the speed" : "power is constant");
}

Json json_of(const LayerPlan& layer, const drawing::Layer& drawn, const Beam& beam) {
  Json row;
  row["layer"] = drawn.name;
  row["colour"] = drawn.colour;
  const double watts = from_thousandths(layer.condition.cut.power_mw);
  row["power_w"] = beam.knows_watts ? Json(watts) : Json(nullptr);
  row["power_percent"] = 100.0 * watts / beam.full_power_w;
  row["feed_mm_min"] = from_thousandths(layer.condition.cut.speed_um_min);
  row["kerf_mm"] = layer.condition.kerf_mm;
  row["kerf_half_interval_mm"] = layer.condition.half_interval_mm;
  row["passes"] = layer.settings.passes;
  return row;
}

Json pictures_json(const CutPlan& plan) {
  Json rows = Json::array();
  for (const Cut& cut : plan.cuts) {
    if (!cut.picture) continue;
    const engrave::BurnRaster& raster = cut.picture->raster;
    rows.push_back({{"entity", cut.picture->entity.name},
                    {"columns", raster.columns},
                    {"rows", raster.rows},
                    {"pixel_mm", raster.pixel_mm},
                    {"interval_mm", raster.interval_mm},
                    {"at_mm", {cut.picture->at_mm.x(), cut.picture->at_mm.y()}},
                    {"burnt_rows", cut.picture->rows.figures.rows},
                    {"burnt_mm", cut.picture->rows.figures.burnt_mm},
                    {"pass", cut.pass}});
  }
  return rows;
}

Json json_of(const Recipes& recipes, const drawing::Drawing& drawn) {
  Json rows = Json::array();
  for (const AppliedRule& applied : recipes.applied) {
    Json row{{"rule", applied.rule.text}, {"place", applied.rule.place}};
    row["contours"] = Json::array();
    for (const std::size_t contour : applied.contours) {
      row["contours"].push_back(drawn.contours[contour].entity.name);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Returns the number of free-form curves of the drawing that are cut as arcs.
std::size_t curves_of(const CutJob& job) {
  std::set<std::size_t> contours;
  for (const Cut& cut : job.plan.cuts) {
    if (cut.contour != kNoContour) contours.insert(cut.contour);
  }
  std::size_t curves = 0;
  for (const std::size_t contour : contours) {
    const auto& shapes = job.drawn.contours[contour].shapes;
    curves += static_cast<std::size_t>(std::ranges::count_if(shapes, is_free_form));
  }
  return curves;
}

/// Adds the corners of a cut to the figures. A loop replaces the arc around its corner, so the
/// length of this arc is subtracted.
void add_corners(const Cut& cut, const LayerPlan& layer, CutFigures& figures) {
  figures.corners += cut.corners.size();
  for (const Stroke& stroke : cut.strokes) {
    if (stroke.dwell_s > 0.0) {
      ++figures.corner_dwells;
      figures.corner_dwell_s += stroke.dwell_s;
    }
    if (stroke.purpose != Purpose::kCornerLoop) continue;
    figures.corner_loop_mm += length_of(stroke);
    if (stroke.bulge == 0.0) continue;
    ++figures.corner_loops;
    const double turn = 2.0 * std::numbers::pi - 4.0 * std::atan(-stroke.bulge);
    figures.corner_loop_mm -= 0.5 * layer.condition.kerf_mm * turn;
  }
}

std::string line_of_corners(const CutFigures& figures) {
  return fmt::format("{} corners: {} loops, {:.1f} mm longer; {} dwells, {:g} s",
                     figures.corners,
                     figures.corner_loops,
                     figures.corner_loop_mm,
                     figures.corner_dwells,
                     figures.corner_dwell_s);
}

/// Breaks lines that would be longer than Grbl accepts as comments of a program.
std::vector<std::string> none_too_long(const std::vector<std::string>& lines) {
  constexpr std::size_t kLineWidth = 76;
  std::vector<std::string> result;
  for (const std::string& line : lines) {
    if (line.size() <= kLineWidth) {
      result.push_back(line);
      continue;
    }
    const std::string margin = line.substr(0, line.find_first_not_of(' '));
    for (const std::string& part : wrapped(line, kLineWidth - margin.size())) {
      result.push_back(margin + part);
    }
  }
  return result;
}

}  // namespace

CutFigures figures_of(const CutPlan& plan) {
  CutFigures figures{.rapid_length_mm = rapid_length(plan)};
  for (const Cut& cut : plan.cuts) {
    if (cut.picture) {
      ++figures.pictures;
      figures.burnt_mm += cut.picture->rows.figures.burnt_mm;
      continue;
    }
    ++figures.cuts;
    for (const Stroke& stroke : cut.strokes) {
      ++(stroke.bulge == 0.0 ? figures.lines : figures.arcs);
      if (has_beam(stroke.purpose)) figures.cut_length_mm += length_of(stroke);
    }
    add_corners(cut, plan.plan_of(cut), figures);
  }
  return figures;
}

std::vector<std::string> lines_of(const CutJob& job, const CutFigures& figures) {
  std::vector<std::string> lines;
  lines.push_back(fmt::format("kerfline cut: {}", name_of_drawing(job.drawn)));
  for (std::size_t i = 0; i < job.plan.layers.size(); ++i) {
    if (!is_cut(job.plan, i)) continue;
    lines.push_back(layer_line(job, i));
  }
  lines.insert(lines.end(), job.offered.begin(), job.offered.end());
  lines.insert(lines.end(), job.origins.begin(), job.origins.end());
  for (const std::string& rule : lines_of(job.plan.recipes)) {
    lines.push_back(rule);
  }
  if (!job.placing.empty()) lines.push_back(job.placing);
  for (const std::string& note : job.notes) {
    lines.push_back("warning: " + note);
  }
  lines.push_back(full_power_text(job.beam));
  if (const std::size_t curves = curves_of(job); curves != 0) {
    lines.push_back(fmt::format("{} curves as arcs within {:g} mm, fit {}",
                                curves,
                                job.plan.curves.tolerance_mm,
                                name_of(job.plan.curves.method)));
  }
  if (figures.corner_loops + figures.corner_dwells != 0) {
    lines.push_back(line_of_corners(figures));
  }
  for (std::string& line : picture_lines(job.plan)) lines.push_back(std::move(line));
  if (job.plan.shared.is_asked) lines.push_back(line_of(job.plan.shared));
  for (const std::string& line : lines_of(job.plan.safety)) lines.push_back(line);
  lines.push_back(fmt::format("{} cuts, {} lines, {} arcs; {:.1f} mm cut, {:.1f} mm rapid; {}{}",
                              figures.cuts,
                              figures.lines,
                              figures.arcs,
                              figures.cut_length_mm,
                              figures.rapid_length_mm,
                              duration_text(figures.job_time_s),
                              figures.is_simulated ? "" : ", predicted"));
  for (std::string& line : lines_of(job.plan.order, figures.cuts)) {
    lines.push_back(std::move(line));
  }
  return none_too_long(lines);
}

std::vector<std::string> heading_of(const CutJob& job, const CutFigures& figures) {
  std::vector<std::string> lines = lines_of(job, figures);
  for (const ProgramDigest& digest : job.digests) lines.push_back(text_of(digest));
  return lines;
}

Json json_of(const CutJob& job, const CutFigures& figures) {
  Json json;
  json["drawing"] = name_of_drawing(job.drawn);
  const bool has_material = !job.record.name.empty();
  json["material"] = has_material ? Json(job.record.name) : Json(nullptr);
  json["layers"] = Json::array();
  for (std::size_t i = 0; i < job.plan.layers.size(); ++i) {
    if (!is_cut(job.plan, i)) continue;
    json["layers"].push_back(json_of(job.plan.layers[i], job.drawn.layers[i], job.beam));
    const std::uint32_t thickness_um = job.plan.layers[i].condition.cut.thickness_um;
    json["thickness_mm"] = thickness_um > 0 ? Json(from_thousandths(thickness_um)) : Json(nullptr);
  }
  json["kerf"] = {{"unit", name_of(job.record.unit)},
                  {"laser", job.record.laser},
                  {"this_laser", job.laser},
                  {"measured_on_this_machine", is_measured_here(job.record, job.laser)},
                  {"given", job.is_kerf_given},
                  {"provenance", job.record.provenance},
                  {"warnings", job.notes}};
  json["full_power_w"] = job.beam.knows_watts ? Json(job.beam.full_power_w) : Json(nullptr);
  json["offered"] = job.offered;
  json["placing"] = job.placing.empty() ? Json(nullptr) : Json(job.placing);
  json["curves"] = curves_of(job);
  json["tolerance_mm"] = job.plan.curves.tolerance_mm;
  json["fit"] = name_of(job.plan.curves.method);
  json["cuts"] = figures.cuts;
  json["lines"] = figures.lines;
  json["arcs"] = figures.arcs;
  json["cut_length_mm"] = figures.cut_length_mm;
  json["rapid_length_mm"] = figures.rapid_length_mm;
  if (figures.pictures != 0) json["pictures"] = pictures_json(job.plan);
  json["corners"] = {{"count", figures.corners},
                     {"loops", figures.corner_loops},
                     {"loops_longer_mm", figures.corner_loop_mm},
                     {"dwells", figures.corner_dwells},
                     {"dwells_s", figures.corner_dwell_s}};
  if (const SharedLineFigures& shared = job.plan.shared; shared.is_asked) {
    json["common_lines"] = {{"count", shared.lines},
                            {"length_mm", shared.length_mm},
                            {"most_off_mm", shared.max_off_mm}};
  }
  if (job.plan.safety.is_asked()) json["safety"] = json_of(job.plan.safety);
  json["job_time_s"] = figures.job_time_s;
  json["job_time_is"] = figures.is_simulated ? "simulated" : "predicted";
  json["rules"] = json_of(job.plan.recipes, job.drawn);
  json["digests"] = json_of(job.digests);
  json["order"] = json_of(job.plan.order, figures.cuts);
  json["warnings"] = json_of(job.plan.warnings, job.drawn.file);
  json["faults"] = json_of(job.plan.faults, job.drawn.file);
  return json;
}

}  // namespace sim::cut
