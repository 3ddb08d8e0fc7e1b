#include "host-sim/report/stock_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace sim {
namespace {

using StockJson = nlohmann::ordered_json;

constexpr std::size_t kMaxRapidWarnings = 10;

StockJson bounds_json(const stock::VolumeBounds& bounds) {
  return {{"least", bounds.min_mm3}, {"most", bounds.max_mm3}};
}

StockJson place_json(const stock::Pose& pose) {
  return StockJson::array({pose.x_mm, pose.y_mm, pose.z_mm});
}

StockJson tool_json(const stock::Cutter& cutter) {
  StockJson tool{{"diameter_mm", cutter.diameter_mm}};
  switch (cutter.kind) {
    case stock::CutterKind::kFlat:
      tool["kind"] = "flat";
      break;
    case stock::CutterKind::kBall:
      tool["kind"] = "ball";
      break;
    case stock::CutterKind::kBull:
      tool["kind"] = "bull";
      tool["corner_radius_mm"] = cutter.corner_radius_mm;
      break;
    case stock::CutterKind::kV:
      tool["kind"] = "v";
      tool["included_angle_deg"] = cutter.included_angle_deg;
      tool["tip_diameter_mm"] = cutter.tip_diameter_mm;
      break;
  }
  return tool;
}

StockJson lines_json(const stock::LineCuts& cuts) {
  StockJson lines = StockJson::array();
  for (const stock::LineCut& cut : cuts.lines) {
    lines.push_back({{"line", cut.line},
                     {"least_mm3", cut.min_mm3},
                     {"at_s", cut.at_s},
                     {"at_mm", place_json(cut.at)}});
  }
  return {{"count", cuts.count}, {"lines", lines}};
}

StockJson engagement_json(const std::optional<stock::PeakEngagement>& peak) {
  if (!peak) return nullptr;
  return {{"least", peak->engagement.min_deg},
          {"most", peak->engagement.max_deg},
          {"line", peak->line},
          {"at_s", peak->at_s},
          {"at_mm", place_json(peak->at)}};
}

StockJson peak_json(const stock::HeightPeak& peak) {
  return {{"least_mm", peak.min_mm},
          {"most_mm", peak.max_mm},
          {"at_mm", StockJson::array({peak.x_mm, peak.y_mm})}};
}

StockJson pocket_json(const stock::PocketFigures& pocket) {
  return {{"gouge_mm3", bounds_json(pocket.gouge)},
          {"deepest_gouge", peak_json(pocket.deepest_gouge)},
          {"rest_mm3", bounds_json(pocket.rest)},
          {"tallest_rest", peak_json(pocket.tallest_rest)},
          {"tallest_scallop", peak_json(pocket.tallest_scallop)}};
}

StockJson worst_json(const std::vector<stock::WorstPlace>& places) {
  StockJson list = StockJson::array();
  for (const stock::WorstPlace& place : places) {
    list.push_back({{"off_mm", place.off_mm},
                    {"unreachable_mm", place.unreachable_mm},
                    {"at_mm", StockJson::array({place.x_mm, place.y_mm})}});
  }
  return list;
}

StockJson surface_json(const stock::SurfaceFigures& figures) {
  return {{"cells", figures.cells},
          {"gouge_mm3", bounds_json(figures.gouge)},
          {"deepest_gouge", peak_json(figures.deepest_gouge)},
          {"rest_mm3", bounds_json(figures.rest)},
          {"tallest_rest", peak_json(figures.tallest_rest)},
          {"worst_gouges", worst_json(figures.worst_gouges)},
          {"worst_rests", worst_json(figures.worst_rests)}};
}

/// Returns a text with the deviation at a point and its position. If the tool cannot reach the
/// surface at this point, the text also contains the height that it cannot reach.
std::string worst_text(const stock::WorstPlace& place) {
  std::string text =
      fmt::format("{:+.4f} mm at X{:.3f} Y{:.3f}", place.off_mm, place.x_mm, place.y_mm);
  if (place.unreachable_mm > 0.0) {
    text += fmt::format(", of which the tool cannot reach {:.4f} mm", place.unreachable_mm);
  }
  return text;
}

/// Returns a text with the range of a volume. It also contains the greatest certain difference and
/// its position, if a difference is certain.
std::string difference_text(const stock::VolumeBounds& volume, const stock::HeightPeak& peak) {
  std::string text = fmt::format("{:.2f} to {:.2f} mm³", volume.min_mm3, volume.max_mm3);
  if (peak.min_mm > 0.0) {
    text +=
        fmt::format(", at least {:.4f} mm at X{:.3f} Y{:.3f}", peak.min_mm, peak.x_mm, peak.y_mm);
  }
  return text;
}

/// Returns a text such as `lines 3, 5 and 12 more`.
std::string lines_text(const stock::LineCuts& cuts) {
  constexpr std::size_t kMaxShown = 8;
  std::string text = cuts.count == 1 ? "line" : "lines";
  const std::size_t shown = std::min(kMaxShown, cuts.lines.size());
  for (std::size_t i = 0; i < shown; ++i) {
    text += fmt::format("{} {}", i == 0 ? "" : ",", cuts.lines[i].line);
  }
  if (cuts.count > shown) text += fmt::format(" and {} more", cuts.count - shown);
  return text;
}

}  // namespace

std::string to_string(const stock::Cutter& cutter) {
  switch (cutter.kind) {
    case stock::CutterKind::kFlat:
      break;
    case stock::CutterKind::kBall:
      return fmt::format("ball {:g} mm", cutter.diameter_mm);
    case stock::CutterKind::kBull:
      return fmt::format(
          "bull nose {:g} mm with corners of {:g} mm", cutter.diameter_mm, cutter.corner_radius_mm);
    case stock::CutterKind::kV:
      return fmt::format("V {:g} mm of {:g} degrees, tip {:g} mm",
                         cutter.diameter_mm,
                         cutter.included_angle_deg,
                         cutter.tip_diameter_mm);
  }
  return fmt::format("flat {:g} mm", cutter.diameter_mm);
}

nlohmann::ordered_json to_json(const stock::StockReport& report) {
  const stock::CarvingFigures& figures = report.figures;
  StockJson times = StockJson::array();
  for (const stock::RemovedAt& at : figures.over_time) {
    times.push_back(StockJson::array({at.time_s, at.removed.min_mm3, at.removed.max_mm3}));
  }
  const stock::StockBox& box = report.box;
  StockJson bottom;
  StockJson pocket;
  StockJson surface;
  if (report.pocket) pocket = pocket_json(*report.pocket);
  if (report.surface) surface = surface_json(*report.surface);
  if (report.has_bottom) bottom = box.bottom;
  return {{"x_mm", StockJson::array({box.x_min, box.x_max})},
          {"y_mm", StockJson::array({box.y_min, box.y_max})},
          {"top_mm", box.top},
          {"bottom_mm", bottom},
          {"cell_mm", StockJson::array({report.cell_x_mm, report.cell_y_mm})},
          {"memory_bytes", report.carved_bytes},
          {"tool", tool_json(report.cutter)},
          {"removed_mm3", bounds_json(figures.removed)},
          {"removed_over_time", times},
          {"rapids_in_stock", lines_json(figures.rapids)},
          {"plunges_in_stock", lines_json(figures.plunges)},
          {"greatest_engagement_deg", engagement_json(figures.engagement)},
          {"pocket", pocket},
          {"surface", surface}};
}

std::vector<std::pair<std::string, std::string>> stock_facts(const stock::StockReport& report) {
  const stock::CarvingFigures& figures = report.figures;
  std::vector<std::pair<std::string, std::string>> facts;
  facts.emplace_back("stock",
                     fmt::format("{:.1f} to {:.1f} mm³ removed by {}, cells of {:g} mm",
                                 figures.removed.min_mm3,
                                 figures.removed.max_mm3,
                                 to_string(report.cutter),
                                 std::max(report.cell_x_mm, report.cell_y_mm)));
  if (figures.engagement) {
    facts.emplace_back("engagement",
                       fmt::format("greatest between {:.1f} and {:.1f} degrees, at line {}",
                                   figures.engagement->engagement.min_deg,
                                   figures.engagement->engagement.max_deg,
                                   figures.engagement->line));
  }
  if (figures.plunges.count > 0) {
    facts.emplace_back("plunges", "into stock at " + lines_text(figures.plunges));
  }
  if (report.pocket) {
    facts.emplace_back("gouge",
                       difference_text(report.pocket->gouge, report.pocket->deepest_gouge));
    facts.emplace_back("rest", difference_text(report.pocket->rest, report.pocket->tallest_rest));
  }
  if (report.surface) {
    for (auto& fact : surface_facts(*report.surface)) facts.push_back(std::move(fact));
  }
  return facts;
}

std::vector<std::pair<std::string, std::string>> surface_facts(
    const stock::SurfaceFigures& figures) {
  std::vector<std::pair<std::string, std::string>> facts{
      {"gouge", difference_text(figures.gouge, figures.deepest_gouge)},
      {"rest", difference_text(figures.rest, figures.tallest_rest)}};
  for (std::size_t i = 0; i < figures.worst_gouges.size(); ++i) {
    facts.emplace_back(fmt::format("gouge G{}", i + 1), worst_text(figures.worst_gouges[i]));
  }
  for (std::size_t i = 0; i < figures.worst_rests.size(); ++i) {
    facts.emplace_back(fmt::format("rest R{}", i + 1), worst_text(figures.worst_rests[i]));
  }
  return facts;
}

std::vector<std::string> warnings_of(const stock::StockReport& report, const std::string& file) {
  const stock::LineCuts& rapids = report.figures.rapids;
  std::vector<std::string> warnings;
  for (const stock::LineCut& cut : rapids.lines) {
    if (warnings.size() == kMaxRapidWarnings) break;
    warnings.push_back(fmt::format(
        "{}:{}: a rapid cuts stock, at least {:.3g} mm³, first near X{:.3f} Y{:.3f} Z{:.3f}",
        file,
        cut.line,
        cut.min_mm3,
        cut.at.x_mm,
        cut.at.y_mm,
        cut.at.z_mm));
  }
  if (rapids.count > warnings.size()) {
    warnings.push_back(
        fmt::format("{}: rapids cut stock {} more times", file, rapids.count - warnings.size()));
  }
  if (report.pocket && report.pocket->gouge.min_mm3 > 0.0) {
    warnings.push_back(
        fmt::format("{}: the pocket is gouged: {}",
                    file,
                    difference_text(report.pocket->gouge, report.pocket->deepest_gouge)));
  }
  if (report.surface && report.surface->gouge.min_mm3 > 0.0) {
    warnings.push_back(
        fmt::format("{}: the surface is gouged: {}",
                    file,
                    difference_text(report.surface->gouge, report.surface->deepest_gouge)));
  }
  return warnings;
}

}  // namespace sim
