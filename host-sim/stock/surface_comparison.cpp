#include "host-sim/stock/surface_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "host-sim/surface/drop_cutter.hpp"

namespace sim::stock {
namespace {

using surface::DropCutter;

/// Radius of the ball that stands for a point. It is so small that it hardly widens an upright
/// wall.
constexpr double kPointMm = 1.0e-5;

Profile point_profile() { return {.radius_mm = kPointMm, .corner_mm = kPointMm}; }
Profile disc_profile(double radius_mm) { return {.radius_mm = radius_mm, .flat_mm = radius_mm}; }

/// Heights of a surface over a cell, mm.
struct CellSurface {
  double centre_mm = 0.0;
  double max_mm = 0.0;  ///< Height that no point of the surface in the cell exceeds.
};

/// Returns points that are distributed over a disc of radius 1, including its centre.
std::vector<Eigen::Vector2d> ways_in_disc() {
  constexpr int kRadii = 12;
  constexpr int kAngles = 24;
  std::vector<Eigen::Vector2d> ways;
  for (int i = 0; i < kRadii; ++i) {
    for (int k = 0; k < kAngles; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kAngles;
      const double out = i / (kRadii - 1.0);
      ways.emplace_back(out * std::cos(angle), out * std::sin(angle));
    }
  }
  return ways;
}

/// Returns the lowest height that the tool can cut over a point. The tool may descend at any
/// position whose distance from the point is at most its radius, until it touches the surface.
/// Returns minus infinity if the tool can descend next to the surface.
double lowest_cut(const DropCutter& tool, const Eigen::Vector2d& place) {
  constexpr int kRounds = 6;
  static const std::vector<Eigen::Vector2d> kWays = ways_in_disc();
  const double radius = tool.profile().radius_mm;
  Eigen::Vector2d best = place;
  double lowest = std::numeric_limits<double>::infinity();
  DropCutter::Hint hint;
  double reach = radius;
  Eigen::Vector2d centre = place;
  for (int round = 0; round < kRounds; ++round) {
    for (const Eigen::Vector2d& way : kWays) {
      const Eigen::Vector2d axis = centre + reach * way;
      const double distance = (axis - place).norm();
      if (distance > radius) continue;
      const double cut = tool.tip_height(axis, hint) + height_at(tool.profile(), distance);
      if (cut < lowest) {
        lowest = cut;
        best = axis;
      }
    }
    centre = best;
    reach *= 0.3;
  }
  return lowest;
}

/// Keeps the greatest deviation in each part of the plan, either of gouges or of rests.
class WorstOfParts {
 public:
  static constexpr int kParts = 24;  ///< Number of parts along each side of the plan.

  explicit WorstOfParts(const StockBox& box) : box_{box}, worst_(std::size_t{kParts} * kParts) {}

  void take(const WorstPlace& place) {
    const auto part = [](double value, double from, double to) {
      return std::clamp(static_cast<int>(kParts * (value - from) / (to - from)), 0, kParts - 1);
    };
    const int column = part(place.x_mm, box_.x_min, box_.x_max);
    const int row = part(place.y_mm, box_.y_min, box_.y_max);
    WorstPlace& worst =
        worst_[static_cast<std::size_t>(row) * kParts + static_cast<std::size_t>(column)];
    if (std::abs(place.off_mm) > std::abs(worst.off_mm)) worst = place;
  }

  /// Returns the greatest deviations in descending order. Their distance from each other is at
  /// least `apart_mm`.
  [[nodiscard]] std::vector<WorstPlace> worst(double apart_mm) const {
    std::vector<WorstPlace> sorted = worst_;
    std::ranges::sort(sorted, std::ranges::greater{}, [](const WorstPlace& place) {
      return std::abs(place.off_mm);
    });
    std::vector<WorstPlace> chosen;
    for (const WorstPlace& place : sorted) {
      if (place.off_mm == 0.0 || chosen.size() == kMaxWorstPlaces) break;
      const auto is_near = [&](const WorstPlace& other) {
        return std::hypot(other.x_mm - place.x_mm, other.y_mm - place.y_mm) < apart_mm;
      };
      if (std::ranges::none_of(chosen, is_near)) chosen.push_back(place);
    }
    return chosen;
  }

 private:
  StockBox box_;
  std::vector<WorstPlace> worst_;
};

/// Compares a stock with a surface, cell by cell.
class SurfaceComparer {
 public:
  SurfaceComparer(const Stock& stock, const Cutter& cutter, const surface::Mesh& mesh)
      : stock_{stock},
        half_mm_{0.5 * std::hypot(stock.cell_x_mm(), stock.cell_y_mm())},
        point_{mesh, point_profile()},
        disc_{mesh, disc_profile(half_mm_)},
        tool_{mesh, profile_of(cutter)},
        gouges_{stock.box()},
        rests_{stock.box()} {}

  SurfaceComparison result() {
    result_.map = {
        .columns = stock_.columns(), .rows = stock_.rows(), .box = stock_.box(), .off_mm = {}};
    result_.map.off_mm.reserve(static_cast<std::size_t>(stock_.columns()) *
                               static_cast<std::size_t>(stock_.rows()));
    for (int row = 0; row < stock_.rows(); ++row) {
      for (int column = 0; column < stock_.columns(); ++column) take(column, row);
    }
    const StockBox& box = stock_.box();
    const double apart = std::max(tool_.profile().radius_mm,
                                  0.06 * std::hypot(box.x_max - box.x_min, box.y_max - box.y_min));
    SurfaceFigures& figures = result_.figures;
    figures.cell_mm = std::max(stock_.cell_x_mm(), stock_.cell_y_mm());
    figures.worst_gouges = gouges_.worst(apart);
    figures.worst_rests = rests_.worst(apart);
    for (WorstPlace& place : figures.worst_rests) note_unreachable(place);
    return std::move(result_);
  }

 private:
  /// Returns the greatest slope, up or down, from the surface at a cell's centre to eight points of
  /// the surface at the distance `reach`.
  [[nodiscard]] double rise_around(const CellSurface& surface,
                                   const Eigen::Vector2d& place,
                                   double reach) {
    static const std::array<Eigen::Vector2d, 8> kAround{
        {{1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}}};
    double rise = 0.0;
    for (const Eigen::Vector2d& way : kAround) {
      const double beside = point_.tip_height(place + reach * way, point_hint_);
      if (beside == cnc::surface::kNoContact) continue;
      rise = std::max(rise, std::abs(beside - surface.centre_mm) / reach);
    }
    return rise;
  }

  /// Converts a height above the surface to a distance perpendicular to the surface. For a great
  /// height, also checks the surface around the cell, because the nearest point may be on a wall
  /// next to the cell.
  [[nodiscard]] double square_off(double height_mm,
                                  const CellSurface& surface,
                                  const Eigen::Vector2d& place) {
    double rise = (surface.max_mm - surface.centre_mm) / half_mm_;
    for (double reach = half_mm_; reach < std::abs(height_mm); reach *= 2.0) {
      rise = std::max(rise, rise_around(surface, place, reach));
    }
    return height_mm / std::hypot(1.0, rise);
  }

  [[nodiscard]] std::optional<CellSurface> surface_at(const Eigen::Vector2d& place) {
    const double centre = point_.tip_height(place, point_hint_);
    if (centre == cnc::surface::kNoContact) return std::nullopt;
    return CellSurface{centre, std::max(centre, disc_.tip_height(place, disc_hint_))};
  }

  void take(int column, int row) {
    const Eigen::Vector2d place{stock_.box().x_min + (column + 0.5) * stock_.cell_x_mm(),
                                stock_.box().y_min + (row + 0.5) * stock_.cell_y_mm()};
    const std::optional<CellSurface> surface = surface_at(place);
    if (!surface) {
      result_.map.off_mm.push_back(std::numeric_limits<float>::quiet_NaN());
      return;
    }
    const Cell& cell = stock_.cell(column, row);
    const double lower = stock_.box().top + cell.lower_nm / kNmPerMm;
    const double upper = stock_.box().top + cell.upper_nm / kNmPerMm;
    const double fall = surface->max_mm - surface->centre_mm;
    SurfaceFigures& figures = result_.figures;
    ++figures.cells;
    add(figures.gouge,
        figures.deepest_gouge,
        surface->centre_mm - upper,
        surface->max_mm - lower,
        place);
    add(figures.rest,
        figures.tallest_rest,
        lower - surface->centre_mm,
        upper - surface->centre_mm + fall,
        place);
    const bool is_gouge = upper < surface->centre_mm;
    const double height = is_gouge ? upper : std::max(0.5 * (lower + upper), surface->centre_mm);
    const WorstPlace here{.x_mm = place.x(),
                          .y_mm = place.y(),
                          .off_mm = square_off(height - surface->centre_mm, *surface, place)};
    result_.map.off_mm.push_back(static_cast<float>(here.off_mm));
    (is_gouge ? gouges_ : rests_).take(here);
  }

  void add(VolumeBounds& volume,
           HeightPeak& peak,
           double least,
           double most,
           const Eigen::Vector2d& place) const {
    const double area = stock_.cell_x_mm() * stock_.cell_y_mm();
    const HeightPeak here{.min_mm = std::max(0.0, least),
                          .max_mm = std::max(0.0, most),
                          .x_mm = place.x(),
                          .y_mm = place.y()};
    volume.min_mm3 += here.min_mm * area;
    volume.max_mm3 += here.max_mm * area;
    peak.take(here);
  }

  void note_unreachable(WorstPlace& place) {
    const Eigen::Vector2d at{place.x_mm, place.y_mm};
    const std::optional<CellSurface> surface = surface_at(at);
    if (!surface) return;
    constexpr double kTold = 5.0e-5;
    const double left = square_off(lowest_cut(tool_, at) - surface->centre_mm, *surface, at);
    if (left > kTold) place.unreachable_mm = std::min(left, place.off_mm);
  }

  const Stock& stock_;
  double half_mm_;  ///< Half the diagonal of a cell.
  DropCutter point_;
  DropCutter disc_;
  DropCutter tool_;
  DropCutter::Hint point_hint_;
  DropCutter::Hint disc_hint_;
  WorstOfParts gouges_;
  WorstOfParts rests_;
  SurfaceComparison result_;
};

}  // namespace

std::string fault_of_comparison(const StockBox& box, double cell_mm) {
  const double cells = (box.x_max - box.x_min) * (box.y_max - box.y_min) / (cell_mm * cell_mm);
  if (cells <= kMaxComparedCells) return {};
  return fmt::format(
      "the stock has {:.3g} cells of {} mm; at most {:.3g} can be compared, so choose larger cells",
      cells,
      cell_mm,
      kMaxComparedCells);
}

SurfaceComparison compared(const Stock& stock, const Cutter& cutter, const surface::Mesh& mesh) {
  return SurfaceComparer{stock, cutter, mesh}.result();
}

}  // namespace sim::stock
