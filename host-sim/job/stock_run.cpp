#include "host-sim/job/stock_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "host-sim/job/axis_scale.hpp"
#include "host-sim/plot/deviation_picture.hpp"
#include "host-sim/plot/picture_file.hpp"
#include "host-sim/plot/png.hpp"
#include "host-sim/plot/stock_picture.hpp"
#include "host-sim/report/stock_text.hpp"
#include "host-sim/stock/mesh_file.hpp"

namespace sim {
namespace {

constexpr std::size_t kStockAxes = 3;

/// Returns the distance, in mm, of a simultaneous step of X, Y and Z.
double step_diagonal(const cnc::Settings& settings) {
  const auto steps = steps_per_mm<double>(settings);
  double square = 0.0;
  for (std::size_t axis = 0; axis < kStockAxes; ++axis) square += 1.0 / (steps[axis] * steps[axis]);
  return std::sqrt(square);
}

double tolerance_of(const StockWish& wish, const cnc::Settings& settings) {
  // The points of a staircase of steps are up to one step away from its slope.
  constexpr double kStaircase = 1.25;
  return std::max(StockRun::kToleranceCells * wish.cell_mm, kStaircase * step_diagonal(settings));
}

stock::Stock stock_of(const StockWish& wish) {
  for (const std::string& fault : {fault_of(wish.box, wish.cell_mm), fault_of(wish.cutter)}) {
    if (!fault.empty()) throw std::invalid_argument(fault);
  }
  return stock::Stock{wish.box, wish.cell_mm};
}

double linear_distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

StockRun::StockRun(const StockWish& wish,
                   const ProgrammedPath& path,
                   const PathDeviation& follower,
                   const cnc::Settings& settings)
    : wish_{wish},
      path_{path},
      follower_{follower},
      trail_mm_{4.0 * step_diagonal(settings)},
      stock_{stock_of(wish)},
      carving_{stock_, wish.cutter, trail_mm_},
      stretches_{tolerance_of(wish, settings),
                 [this](const stock::DrivenStretch& driven) { carving_.take(driven); }} {
  const auto steps = steps_per_mm<double>(settings);
  for (std::size_t axis = 0; axis < step_mm_.size(); ++axis) step_mm_[axis] = 1.0 / steps[axis];
}

bool StockRun::is_near(const Point& place, const Point& end, const PathPiece& piece) const {
  const ProgramTolerance& tolerance = piece.tolerance;
  const double margin =
      trail_mm_ + tolerance.corner + tolerance.weld + tolerance.spline + tolerance.motors;
  return linear_distance(place, end) <= margin;
}

stock::StretchOrigin StockRun::origin_at(const Point& place) const {
  const PathPiece* piece = follower_.present_piece();
  if (piece == nullptr) return {};
  if (piece->travel != Travel::kRapid) return {piece->line, stock::Drive::kFeed};
  const PathPiece* const first = path_.pieces.data();
  const PathPiece* const last = first + path_.pieces.size() - 1;
  const PathPiece* before = piece == first ? nullptr : piece - 1;
  const PathPiece* after = piece == last ? nullptr : piece + 1;
  const bool is_joint = (before != nullptr && before->travel != Travel::kRapid &&
                         is_near(place, piece->curve.start(), *before)) ||
                        (after != nullptr && after->travel != Travel::kRapid &&
                         is_near(place, piece->curve.end(), *after));
  return {piece->line, is_joint ? stock::Drive::kJoint : stock::Drive::kRapid};
}

void StockRun::on_row(const TraceRow& row) {
  Point place{};
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    place[axis] = row.position[axis] * step_mm_[axis];
  }
  const double time_s = static_cast<double>(row.time_ns) * 1.0e-9;
  stretches_.go_to({place[0], place[1], place[2]}, origin_at(place), time_s);
}

void StockRun::on_end(std::uint64_t time_ns) {
  stretches_.finish();
  carving_.end(static_cast<double>(time_ns) * 1.0e-9);
  if (wish_.surface) comparison_ = compared(stock_, wish_.cutter, *wish_.surface);
}

void StockRun::add_to(Report& report, const std::string& file) const {
  report.stock = stock::StockReport{.box = wish_.box,
                                    .has_bottom = wish_.has_bottom,
                                    .cell_x_mm = stock_.cell_x_mm(),
                                    .cell_y_mm = stock_.cell_y_mm(),
                                    .cutter = wish_.cutter,
                                    .carved_bytes = stock_.carved_bytes(),
                                    .figures = carving_.figures()};
  if (wish_.target) report.stock->pocket = compared(stock_, wish_.cutter, *wish_.target);
  if (comparison_) report.stock->surface = comparison_->figures;
  for (std::string& warning : warnings_of(*report.stock, file)) {
    report.warnings.push_back(std::move(warning));
  }
}

void StockRun::write_files(const std::string& title) const {
  if (!wish_.png.empty()) {
    const stock::VolumeBounds removed = stock_.removed();
    const std::string facts = fmt::format("{:.1f} to {:.1f} mm³ removed  ·  {}",
                                          removed.min_mm3,
                                          removed.max_mm3,
                                          to_string(wish_.cutter));
    write_png(wish_.png, draw_stock(wish_.png, stock_, title, facts));
  }
  if (!wish_.map.empty() && comparison_) {
    const std::string facts = to_string(wish_.cutter);
    write_picture(wish_.map, draw_deviation(wish_.map, *comparison_, title, facts));
  }
  if (!wish_.stl.empty()) write_stl(wish_.stl, stock_);
  if (!wish_.ply.empty()) write_ply(wish_.ply, stock_);
}

}  // namespace sim
