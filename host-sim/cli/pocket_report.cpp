#include "host-sim/cli/pocket_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "firmware/protocol/identity.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/report/report_json.hpp"

namespace sim {
namespace {

using PathPoint = cnc::pocket::PathPoint<double>;
using cnc::pocket::Use;

/// Lengths of a path by the use of its elements, mm.
struct PathLengths {
  double pass_mm = 0.0;
  double link_mm = 0.0;
  double return_mm = 0.0;  ///< Length of rapids at depth.
  double entry_mm = 0.0;
  double between_rows_mm = 0.0;  ///< Length of rapids in plan.

  [[nodiscard]] double fed_mm() const { return pass_mm + link_mm + entry_mm; }

  void add(const PathPoint& from, const PathPoint& to) {
    const cut::Stroke stroke{.from = from.point(), .to = to.point(), .bulge = from.bulge};
    const double length_mm = std::hypot(cut::length_of(stroke), to.z - from.z);
    switch (from.use) {
      case Use::kPass:
      case Use::kLight:
        pass_mm += length_mm;
        break;
      case Use::kLink:
      case Use::kLeadIn:
      case Use::kLeadOut:
        link_mm += length_mm;
        break;
      case Use::kReturn:
        return_mm += length_mm;
        break;
      case Use::kEntry:
        entry_mm += length_mm;
        break;
    }
  }
};

PathLengths lengths_of(const cnc::pocket::ToolPathView<double>& path) {
  PathLengths lengths;
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    const std::uint32_t begin = path.row_begin(row);
    if (row > 0) {
      lengths.between_rows_mm +=
          (path.points[begin].point() - path.points[begin - 1].point()).norm();
    }
    for (std::uint32_t i = begin; i + 1 < path.row_ends[row]; ++i) {
      lengths.add(path.points[i], path.points[i + 1]);
    }
  }
  return lengths;
}

const char* name_of(pocket::Strategy strategy) {
  using pocket::Strategy;
  switch (strategy) {
    case Strategy::kContour:
      return "contour";
    case Strategy::kSpiral:
      return "spiral";
    case Strategy::kAdaptive:
      return "adaptive";
    case Strategy::kZigzag:
      return "zigzag";
    case Strategy::kPaper:
      return "paper";
  }
  return "";
}

/// Returns the word for the passes of a strategy.
const char* passes_of(pocket::Strategy strategy) {
  using pocket::Strategy;
  return strategy == Strategy::kZigzag  ? "lines"
         : strategy == Strategy::kPaper ? "loops"
                                        : "passes";
}

nlohmann::ordered_json json_of(const pocket::NarrowStretch& stretch) {
  const auto place = [](const cnc::WideVec2& at) {
    return nlohmann::ordered_json::array({at.x(), at.y()});
  };
  nlohmann::ordered_json json;
  json["from"] = place(stretch.places.front());
  json["to"] = place(stretch.places.back());
  json["width_mm"] = stretch.width_mm;
  json["length_mm"] = stretch.length_mm;
  return json;
}

std::string title_of(const PocketCommandOptions& options) {
  const std::string name =
      options.file == "-" ? options.file : std::filesystem::path{options.file}.filename().string();
  return fmt::format("kerfline {} pocket: {}", cnc::identity::version(), name);
}

void add_digests(const MilledDrawing& milled, std::vector<std::string>& lines) {
  for (const ProgramDigest& digest : milled.digests) lines.push_back(text_of(digest));
}

}  // namespace

std::vector<std::string> pocket_heading(const PocketCommandOptions& options,
                                        const MilledDrawing& milled) {
  std::vector<std::string> lines{title_of(options)};
  if (options.is_v_carving()) {
    lines.push_back(fmt::format("V tool {:g} mm of {:g} degrees, {:.3f} mm at the deepest",
                                options.tool_mm,
                                options.v_angle_deg,
                                milled.carved_depth_mm));
  } else if (options.strategy == pocket::Strategy::kAdaptive) {
    lines.push_back(fmt::format("tool {:g} mm, {:g} mm deep in {} levels, adaptive: {:g} degrees",
                                options.tool_mm,
                                milled.floors_mm.back(),
                                milled.levels,
                                options.engagement_deg));
  } else {
    lines.push_back(fmt::format("tool {:g} mm, {:g} mm deep in {} levels, {} {} in each",
                                options.tool_mm,
                                milled.floors_mm.back(),
                                milled.levels,
                                milled.passes,
                                passes_of(options.strategy)));
  }
  add_digests(milled, lines);
  return lines;
}

std::vector<std::string> holes_heading(const PocketCommandOptions& options,
                                       const MilledDrawing& milled) {
  std::vector<std::string> lines{
      title_of(options),
      fmt::format("drill of up to {:g} mm: holes into which the tool plunges", options.tool_mm)};
  add_digests(milled, lines);
  return lines;
}

std::string pocket_summary(const PocketCommandOptions& options, const MilledDrawing& milled) {
  const double fed_mm = lengths_of(milled.path()).fed_mm();
  const std::size_t rows = milled.row_ends.size();
  if (options.is_v_carving()) {
    return fmt::format(
        "{}: {} shapes carved, {:.3f} mm at the deepest, {} rows, {:.1f} mm at feeds",
        options.file,
        milled.pockets,
        milled.carved_depth_mm,
        rows,
        fed_mm);
  }
  if (options.strategy == pocket::Strategy::kAdaptive) {
    return fmt::format("{}: {} levels, {} rows, {:.1f} mm at feeds; {} narrow stretches",
                       options.file,
                       milled.levels,
                       rows,
                       fed_mm,
                       milled.narrow.size());
  }
  return fmt::format("{}: {} {} in {} levels, {} rows, {:.1f} mm at feeds",
                     options.file,
                     milled.passes,
                     passes_of(options.strategy),
                     milled.levels,
                     rows,
                     fed_mm);
}

std::string pocket_report(const PocketCommandOptions& options, const MilledDrawing& milled) {
  const PathLengths lengths = lengths_of(milled.path());
  nlohmann::ordered_json report;
  report["drawing"] = options.file;
  report["version"] = cnc::identity::version();
  report["tool_mm"] = options.tool_mm;
  report["depth_mm"] = options.depth_mm;
  report["pockets"] = milled.pockets;
  if (options.is_v_carving()) {
    report["v_angle_deg"] = options.v_angle_deg;
    report["carved_depth_mm"] = milled.carved_depth_mm;
    report["wide_area_mm2"] = milled.wide_area_mm2;
  } else {
    report["floors_mm"] = milled.floors_mm;
    report["strategy"] = name_of(options.strategy);
    report["levels"] = milled.levels;
    report["passes"] = milled.passes;
    report["links"] = milled.links;
    if (options.finish_mm > 0.0) report["finish_mm"] = options.finish_mm;
    if (options.floor_mm > 0.0) report["finish_floor_mm"] = options.floor_mm;
    if (options.rest_of_mm > 0.0) report["rest_of_mm"] = options.rest_of_mm;
  }
  if (options.strategy == pocket::Strategy::kAdaptive) {
    report["engagement_deg"] = options.engagement_deg;
    report["narrow"] = nlohmann::ordered_json::array();
    for (const auto& stretch : milled.narrow) report["narrow"].push_back(json_of(stretch));
  }
  report["rows"] = milled.row_ends.size();
  report["pass_length_mm"] = lengths.pass_mm;
  report["link_length_mm"] = lengths.link_mm;
  report["return_length_mm"] = lengths.return_mm;
  report["entry_length_mm"] = lengths.entry_mm;
  report["rapid_length_mm"] = lengths.between_rows_mm;
  report["digests"] = json_of(milled.digests);
  return dumped(report) + "\n";
}

}  // namespace sim
