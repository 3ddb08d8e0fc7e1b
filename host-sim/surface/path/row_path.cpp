#include "host-sim/surface/path/row_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// Links lead over the surface up to so many steps; farther ones are lifts.
constexpr double kMostLinkSteps = 4.0;

/// Unit vector of an angle; exact along the axes, so that their rows are.
Vector2d direction_of(double angle_rad) {
  Vector2d direction{std::cos(angle_rad), std::sin(angle_rad)};
  constexpr double kAlongAxis = 1.0e-12;
  for (double& part : direction) {
    if (std::abs(part) < kAlongAxis) part = 0.0;
    if (std::abs(part) > 1.0 - kAlongAxis) part = std::copysign(1.0, part);
  }
  return direction;
}

/// The box of a surface in the plan, seen along its rows.
struct RowFrame {
  Vector2d along;
  Vector2d across;
  Vector2d least;  ///< Along and across.
  Vector2d most;

  RowFrame(const Mesh& mesh, const RowOptions& options)
      : along{direction_of(options.angle_rad)},
        across{-along.y(), along.x()},
        least{Vector2d::Constant(std::numeric_limits<double>::infinity())},
        most{-least} {
    for (const Eigen::Vector3d& point : mesh.points) {
      const Vector2d seen{along.dot(point.head<2>()), across.dot(point.head<2>())};
      least = least.cwiseMin(seen);
      most = most.cwiseMax(seen);
    }
    least.array() -= options.margin_mm;
    most.array() += options.margin_mm;
  }

  [[nodiscard]] Vector2d at(double way, double row) const { return way * along + row * across; }
};

/// Lays rows over a surface and links them.
class RowPlanner {
 public:
  RowPlanner(const Mesh& mesh, const RowOptions& options)
      : options_{options}, frame_{mesh, options}, tracer_{mesh, options} {}

  SurfacePath plan() {
    const double width = frame_.most.y() - frame_.least.y();
    const auto steps = std::max(1.0, std::ceil(width / options_.step_mm - 1.0e-9));
    for (double i = 0.0; i <= steps; i += 1.0) {
      add_row(frame_.least.y() + width * i / steps);
      if (options_.progress) options_.progress((i + 1.0) / (steps + 1.0));
    }
    if (path_.stretches.empty()) {
      throw std::invalid_argument{"nothing of it is under the tool"};
    }
    end_run();
    path_.without_arcs = tracer_.without_arcs();
    return std::move(path_);
  }

 private:
  void add_row(double row) {
    const double length = frame_.most.x() - frame_.least.x();
    const Vector2d low = frame_.at(frame_.least.x(), row);
    const Vector2d high = frame_.at(frame_.most.x(), row);
    const Slice slice =
        goes_back_ ? Slice{high, -frame_.along, length} : Slice{low, frame_.along, length};
    bool has_part = false;
    for (const auto& [begin, end] : tracer_.parts_over(slice)) {
      lead_to(slice.at(begin));
      path_.stretches.push_back(tracer_.trace(slice, begin, end, StretchUse::kRow));
      here_ = slice.at(end);
      has_part = true;
    }
    if (has_part && options_.order == RowOrder::kZigzag) goes_back_ = !goes_back_;
  }

  /// Leads to the next stretch over the surface, where it is near and the surface goes on.
  void lead_to(const Vector2d& place) {
    if (path_.stretches.empty()) return;
    const double distance = (place - here_).norm();
    const bool is_near = distance <= kMostLinkSteps * options_.step_mm;
    if (options_.order == RowOrder::kZigzag && is_near && distance > 0.0) {
      const Slice slice = slice_between(here_, place);
      const auto parts = tracer_.parts_over(slice);
      if (parts.size() == 1 && parts[0].second - parts[0].first > 0.999 * slice.length) {
        path_.stretches.push_back(tracer_.trace(slice, 0.0, slice.length, StretchUse::kLink));
        return;
      }
    }
    end_run();
  }

  void end_run() { path_.run_ends.push_back(path_.stretches.size()); }

  const RowOptions& options_;
  RowFrame frame_;
  SurfaceTracer tracer_;
  SurfacePath path_;
  Vector2d here_ = Vector2d::Zero();
  bool goes_back_ = false;
};

}  // namespace

SurfacePath row_path(const Mesh& mesh, const RowOptions& options) {
  return RowPlanner{mesh, options}.plan();
}

}  // namespace sim::surface
