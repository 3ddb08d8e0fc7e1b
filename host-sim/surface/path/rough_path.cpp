#include "host-sim/surface/path/rough_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "host-sim/cut/stroke.hpp"
#include "host-sim/pocket/open_pocket.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/surface/path/level_areas.hpp"
#include "host-sim/surface/path/rough_areas.hpp"
#include "host-sim/surface/path/slot_finder.hpp"

namespace sim::surface {
namespace {

using pocket::StockBox;

/// Nominal depth with which the rows of areas are planned, mm.
constexpr double kRowDepthMm = 1.0;
/// Corner radius of passes, relative to the clearing radius. It does not apply to passes at the
/// border.
constexpr double kCornerShare = 0.1;
/// Heights, in tolerances, by which a level is raised on successive attempts if its lines have no
/// closed contour.
constexpr std::array kLifts{0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

StockBox box_of(const Mesh& mesh) {
  const Eigen::Vector3d& first = mesh.points.front();
  StockBox box{first.x(), first.y(), first.x(), first.y()};
  for (const Eigen::Vector3d& point : mesh.points) {
    box.include({point.x(), point.y(), point.x(), point.y()});
  }
  return box;
}

/// Rectangles of the stock and of the tip in plan.
struct RoughBoxes {
  /// The surface's box. If the end of the stock is known, the box is widened by the stock's margin.
  StockBox stock;
  StockBox tip;  ///< Rectangle in which the tip may be.
};

RoughBoxes boxes_of(const Mesh& mesh, const RowOptions& options, const RoughOptions& rough) {
  const double radius = options.tool.radius_mm;
  if (rough.stock_margin_mm) {
    const StockBox stock = pocket::widened(box_of(mesh), *rough.stock_margin_mm);
    return {stock, pocket::widened(stock, pocket::margin_around(stock, radius))};
  }
  const double margin = options.margin_mm > 0.0 ? options.margin_mm : radius;
  const StockBox tip = pocket::widened(box_of(mesh), margin);
  return {pocket::widened(tip, radius), tip};
}

/// Returns the rows of a path without its other data.
pocket::PathRows rows_of(const pocket::PathRows& path) { return path; }

/// Finds the areas of all levels and their rows, and plans the path through all areas.
class RoughPlanner {
 public:
  RoughPlanner(const Mesh& mesh, const RowOptions& options, const RoughOptions& rough)
      : options_{options},
        is_open_{rough.stock_margin_mm.has_value()},
        boxes_{boxes_of(mesh, options, rough)},
        clearing_mm_{clearing_radius(options.tool, options.layer_mm)},
        tracer_{mesh, options},
        flat_mm_{kFlatDigits * options.digit_mm},
        // Without arcs, half of the band is reserved for the lines that replace arcs.
        band_mm_{(options.lines_only ? 0.5 : 1.0) * (tracer_.band_mm() - flat_mm_)},
        border_{boxes_.tip, rough.boundary, tracer_.band_mm()},
        tips_{tracer_, grid_over(mesh), [this](double share) { report(0.4 * share); }},
        areas_{tracer_, tips_, border_, band_mm_},
        stock_top_mm_{options.stock_top_mm.value_or(top_of(mesh))} {}

  SurfacePath plan() {
    find_areas();
    constexpr double kNearTolerances = 4.0;
    const RoughOrder order{
        found_, {stock_top_mm_, cusp_mm()}, kNearTolerances * options_.tolerance_mm};
    for (const std::size_t next : order.order()) add_area(found_[next]);
    return std::move(path_);
  }

 private:
  [[nodiscard]] PlanGrid grid_over(const Mesh& mesh) const {
    const double pitch = level_pitch(tracer_);
    const double margin = box_of(mesh).x0 - boxes_.tip.x0;
    return {mesh, margin + 3.0 * pitch, pitch};
  }

  void report(double share) const {
    if (options_.progress) options_.progress(share);
  }

  void find_areas() {
    const std::optional<double> lowest = areas_.lowest_mm();
    if (!lowest) {
      throw std::invalid_argument{
          "no part of the surface is under the tool within its border; check whether the tool is "
          "larger than the stock"};
    }
    const double depth = stock_top_mm_ - *lowest - tracer_.lift_mm();
    if (depth <= options_.digit_mm) {
      throw std::invalid_argument{
          "no part of the surface with its allowance is below the top of the stock; check "
          "--stock-top"};
    }
    const double levels = std::ceil(depth / options_.layer_mm - 1.0e-9);
    for (double level = 1.0; level <= levels; level += 1.0) {
      const double tip = stock_top_mm_ - depth * level / levels;
      add_level(static_cast<std::size_t>(level), tip);
      report(0.4 + 0.6 * level / levels);
    }
    if (!found_.empty()) return;
    throw std::invalid_argument{
        "the tool fits into no level within its border; choose a smaller tool"};
  }

  /// Returns the height above a level up to which the shape of the tool leaves stock.
  [[nodiscard]] double cusp_mm() const {
    return height_at(options_.tool, clearing_mm_) - options_.tool.tip_mm;
  }

  /// Adds the areas of a level. Raises the level by a few tolerances if its lines have no closed
  /// contour.
  void add_level(std::size_t level, double tip_mm) {
    std::string reason = "its lines are not closed";
    for (const double tolerances : kLifts) {
      const double lifted = tip_mm + tolerances * options_.tolerance_mm;
      try {
        if (add_areas({level, lifted, {}, {}, {}})) return;
      } catch (const pocket::NoPocketPath& error) {
        reason = error.what();
      } catch (const NoOffset& error) {
        reason = error.what();
      }
    }
    throw std::invalid_argument{fmt::format(
        "the level at Z{:.3f} has no path: {}; change --layers, or increase --tolerance",
        tip_mm,
        reason)};
  }

  /// Adds the areas of a level that have rows. Returns false if the level has no closed contours.
  /// Throws the exceptions of the pocket planner.
  [[nodiscard]] bool add_areas(const RoughArea& level) {
    auto areas = areas_.areas_at(level.tip_mm - tracer_.lift_mm() + flat_mm_);
    if (!areas) return false;
    std::vector<RoughArea> added;
    for (Contour& locus : *areas) {
      RoughArea area = level;
      area.locus = std::move(locus);
      area.rows = rows_over(area.locus);
      if (!area.rows.row_ends.empty()) added.push_back(std::move(area));
    }
    std::ranges::move(added, std::back_inserter(found_));
    return true;
  }

  [[nodiscard]] pocket::PathRows rows_over(const Contour& locus) {
    const auto milling = options_.direction.value_or(cnc::pocket::Milling::kClimb);
    pocket::PocketPlan plan =
        planner_.plan(locus.view(),
                      {.clearing = {.tool_radius = clearing_mm_,
                                    .corner_radius = kCornerShare * clearing_mm_,
                                    .stepover = options_.step_mm,
                                    .is_locus = true},
                       .entry = {.kind = cnc::pocket::EntryKind::kPlunge},
                       .milling = milling,
                       .depth = kRowDepthMm,
                       .depth_step = kRowDepthMm});
    if (!is_open_ || !pocket::is_around(locus.view(), boxes_.stock)) return rows_of(plan);
    // Without islands, the passes are around the middle of the stock. The reversed order begins at
    // the stock's edge.
    if (locus.loop_ends.size() == 1) std::ranges::reverse(plan.passes);
    return rows_of(pocket::open_path_within(
        locus.view(),
        boxes_.stock,
        plan.passes,
        {.tool_radius_mm = options_.tool.radius_mm,
         .drive = {.depth_mm = kRowDepthMm, .plunges = true, .milling = milling}}));
  }

  void add_area(const RoughArea& area) {
    SlotFinder slots{boxes_.stock, options_.tool.radius_mm};
    for (std::size_t row = 0; row < area.rows.row_ends.size(); ++row) {
      add_row(area, row, slots);
      slots.end_run();
    }
  }

  /// Adds the part of a row that is at the level, without entry and exit.
  void add_row(const RoughArea& area, std::size_t row, SlotFinder& slots) {
    constexpr double kMinMm = 1.0e-9;
    const std::size_t first = path_.stretches.size();
    const auto rows = area.rows.path();
    for (std::uint32_t i = rows.row_begin(row); i + 1 < rows.row_ends[row]; ++i) {
      const auto& from = area.rows.points[i];
      const auto& to = area.rows.points[i + 1];
      const bool is_level = std::max(from.z, to.z) < -0.5 * kRowDepthMm;
      if (!is_level || (to.point() - from.point()).norm() < kMinMm) continue;
      const ContourVertex start{from.x, from.y, from.bulge};
      const ContourVertex stop{to.x, to.y, 0.0};
      const StretchUse use = slots.use_of(start, stop);
      const bool goes_on = path_.stretches.size() > first && path_.stretches.back().use == use;
      if (!goes_on) {
        path_.stretches.push_back(
            {.plane = LevelPlane{area.tip_mm}, .use = use, .vertices = {start}});
      }
      append(start, stop, path_.stretches.back().vertices);
    }
    if (path_.stretches.size() == first) return;
    const Eigen::Vector3d start = path_.stretches[first].start();
    const bool is_beside =
        is_open_ && pocket::is_beside(boxes_.stock, start.head<2>(), options_.tool.radius_mm);
    path_.runs.push_back({path_.stretches.size(), is_beside ? area.tip_mm : area.stock_mm[row]});
  }

  /// Appends the element between two vertices. If arcs are not allowed, an arc is replaced by
  /// lines.
  void append(const ContourVertex& from,
              const ContourVertex& to,
              std::vector<ContourVertex>& vertices) const {
    vertices.back().bulge = options_.lines_only ? 0.0 : from.bulge;
    if (options_.lines_only && from.bulge != 0.0) {
      const cut::Stroke arc{.from = {from.x, from.y}, .to = {to.x, to.y}, .bulge = from.bulge};
      const double sweep = 4.0 * std::atan(std::abs(from.bulge));
      // The deviation of a chord from its arc is at most an eighth of the chord's length times the
      // arc's sweep.
      const double parts = std::ceil(std::sqrt(cut::length_of(arc) * sweep / (8.0 * band_mm_)));
      for (double part = 1.0; part < parts; part += 1.0) {
        const cut::Place place = cut::place_at(arc, part / parts);
        vertices.push_back({place.x(), place.y(), 0.0});
      }
    }
    vertices.push_back(to);
  }

  const RowOptions& options_;
  bool is_open_;
  RoughBoxes boxes_;
  double clearing_mm_;
  SurfaceTracer tracer_;
  double flat_mm_;
  double band_mm_;  ///< Greatest deviation of the lines of areas from the level set.
  LevelBorder border_;
  TipGrid tips_;
  LevelAreas areas_;
  double stock_top_mm_;
  pocket::PocketPlanner planner_;
  std::vector<RoughArea> found_;
  SurfacePath path_;
};

}  // namespace

double clearing_radius(const cnc::surface::Profile& tool, double layer_mm) {
  return std::min(tool.radius_mm, radius_below(tool, tool.tip_mm + 0.5 * layer_mm));
}

SurfacePath rough_path(const Mesh& mesh, const RowOptions& options, const RoughOptions& rough) {
  return RoughPlanner{mesh, options, rough}.plan();
}

}  // namespace sim::surface
