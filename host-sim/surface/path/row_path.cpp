#include "host-sim/surface/path/row_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "host-sim/surface/path/row_frame.hpp"
#include "host-sim/surface/path/scallop_rows.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// Greatest length of a link over the surface, in steps; a farther row begins with a lift.
constexpr double kMostLinkSteps = 4.0;

/// Returns the distance of rows: asked for, or by which a level surface has no higher scallops.
double step_of(const RowOptions& options) {
  if (options.scallop_mm == 0.0) return options.step_mm;
  const double level = level_step(options.tool, options.scallop_mm - options.tolerance_mm);
  return options.step_mm > 0.0 ? std::min(options.step_mm, level) : level;
}

/// Lays rows over a surface and links them.
class RowPlanner {
 public:
  RowPlanner(const Mesh& mesh, const RowOptions& options)
      : options_{options},
        step_mm_{step_of(options)},
        frame_{mesh, options.angle_rad, options.margin_mm},
        tracer_{mesh, options},
        stock_top_mm_{options.stock_top_mm.value_or(top_of(mesh))} {
    if (options.scallop_mm == 0.0 || options.layer_mm > 0.0) return;
    // A path is above its exact place by the tolerance and as much again at most.
    between_.emplace(tracer_, frame_, options.tool, options.scallop_mm - options.tolerance_mm);
  }

  SurfacePath plan() {
    if (options_.layer_mm > 0.0) {
      add_layers();
    } else {
      add_rows();
    }
    if (path_.stretches.empty()) {
      throw std::invalid_argument{options_.layer_mm > 0.0
                                      ? "nothing of it is below the top of the stock"
                                      : "nothing of it is under the tool"};
    }
    end_run();
    path_.without_arcs = tracer_.without_arcs();
    return std::move(path_);
  }

 private:
  /// Adds layers from the top of the stock on, until one has nothing to mill.
  void add_layers() {
    constexpr int kMostLayers = 10'000;
    for (int layer = 0; layer < kMostLayers; ++layer) {
      const std::size_t before = path_.stretches.size();
      const double bottom = stock_top_mm_ - options_.layer_mm;
      tracer_.set_layer(stock_top_mm_, bottom);
      add_rows();
      if (path_.stretches.size() == before) return;
      end_run();
      stock_top_mm_ = bottom;
    }
  }

  void add_rows() {
    const double width = frame_.last_row() - frame_.first_row();
    const auto steps = std::max(1.0, std::ceil(width / step_mm_ - 1.0e-9));
    for (double i = 0.0; i <= steps; i += 1.0) {
      const double row = frame_.first_row() + width * i / steps;
      if (between_ && i > 0.0) add_between(row - width / steps, row);
      add_row(row);
      if (options_.progress) options_.progress((i + 1.0) / (steps + 1.0));
    }
  }

  void add_row(double row) {
    if (add_part(frame_.whole(row), goes_back_) && options_.order == RowOrder::kZigzag) {
      goes_back_ = !goes_back_;
    }
  }

  /// Adds parts of rows between two rows, the nearest next.
  void add_between(double low_row, double high_row) {
    std::vector<RowPart> parts = between_->between(low_row, high_row);
    while (!parts.empty()) {
      const auto distance = [this](const RowPart& part, bool goes_back) {
        return (frame_.slice(part, goes_back).from - here_).norm();
      };
      const bool may_go_back = options_.order == RowOrder::kZigzag;
      const auto nearest = std::ranges::min_element(parts, {}, [&](const RowPart& part) {
        return may_go_back ? std::min(distance(part, false), distance(part, true))
                           : distance(part, false);
      });
      const bool goes_back = may_go_back && distance(*nearest, true) < distance(*nearest, false);
      add_part(*nearest, goes_back);
      parts.erase(nearest);
    }
  }

  /// Adds those parts of a row that are over the surface; false if there are none.
  bool add_part(const RowPart& part, bool goes_back) {
    const Slice slice = frame_.slice(part, goes_back);
    bool has_any = false;
    for (const auto& [begin, end] : tracer_.parts_over(slice)) {
      lead_to(slice.at(begin));
      path_.stretches.push_back(tracer_.trace(slice, begin, end, StretchUse::kRow));
      here_ = slice.at(end);
      has_any = true;
    }
    return has_any;
  }

  /// Leads to the next stretch over the surface, where it is near and the surface goes on.
  void lead_to(const Vector2d& place) {
    if (path_.stretches.empty()) return;
    const double distance = (place - here_).norm();
    const bool is_near = distance <= kMostLinkSteps * step_mm_;
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

  void end_run() {
    const std::size_t begin = path_.runs.empty() ? 0 : path_.runs.back().end;
    if (begin == path_.stretches.size()) return;
    path_.runs.push_back({path_.stretches.size(), stock_top_mm_});
  }

  const RowOptions& options_;
  double step_mm_;
  RowFrame frame_;
  SurfaceTracer tracer_;
  std::optional<ScallopRows> between_;
  double stock_top_mm_;  ///< Of the stock that no layer has milled yet.
  SurfacePath path_;
  Vector2d here_ = Vector2d::Zero();
  bool goes_back_ = false;
};

}  // namespace

SurfacePath row_path(const Mesh& mesh, const RowOptions& options) {
  return RowPlanner{mesh, options}.plan();
}

}  // namespace sim::surface
