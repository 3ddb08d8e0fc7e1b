#include "host-sim/surface/path/row_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "host-sim/surface/path/part_queue.hpp"
#include "host-sim/surface/path/row_frame.hpp"
#include "host-sim/surface/path/scallop_rows.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"
#include "host-sim/surface/path/traced_slices.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// Maximum length of a link over the surface, in steps. The path to a row that is farther away
/// begins with a lift.
constexpr double kMaxLinkSteps = 4.0;
/// Share of the reported progress that belongs to the search for the parts of rows.
constexpr double kSearchShare = 0.25;

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
    // The path is between one and two tolerances above its exact position. So the heights of rows
    // may differ by up to a tolerance, which reduces the scallop limit.
    between_.emplace(tracer_, frame_, options.tool, options.scallop_mm - options.tolerance_mm);
  }

  SurfacePath plan() {
    if (options_.layer_mm > 0.0) {
      add_layers();
    } else {
      add_rows();
    }
    if (path_.stretches.empty()) throw std::invalid_argument{reason_for_none()};
    end_run();
    return std::move(path_);
  }

 private:
  [[nodiscard]] const char* reason_for_none() const {
    if (!options_.regions.empty()) {
      return "no row is in the region: check --boundary, --slope and --rest-of, or choose a "
             "smaller --step";
    }
    if (options_.layer_mm > 0.0) return "no part of the surface is below the top of the stock";
    return "the surface is nowhere under the tool";
  }

  /// Adds layers from the top of the stock downwards until a layer is empty.
  void add_layers() {
    constexpr int kMaxLayers = 10'000;
    for (int layer = 0; layer < kMaxLayers; ++layer) {
      const std::size_t before = path_.stretches.size();
      const double bottom = stock_top_mm_ - options_.layer_mm;
      tracer_.set_layer(stock_top_mm_, bottom);
      layer_.clear();
      add_rows();
      if (path_.stretches.size() == before) return;
      end_run();
      stock_top_mm_ = bottom;
    }
  }

  /// Adds all rows. Additional rows between two rows come last, because they mill the stock that
  /// the two rows have left.
  void add_rows() {
    std::vector<RowPart> rows;
    std::vector<RowPart> between;
    const double width = frame_.last_row() - frame_.first_row();
    const auto steps = std::max(1.0, std::ceil(width / step_mm_ - 1.0e-9));
    for (double i = 0.0; i <= steps; i += 1.0) {
      const double row = frame_.first_row() + width * i / steps;
      add_parts(frame_.whole(row), rows);
      report(kSearchShare * (i + 1.0) / (steps + 1.0));
      if (!between_ || i == 0.0) continue;
      for (const RowPart& part : between_->between(row - width / steps, row)) {
        add_parts(part, between);
      }
    }
    if (options_.direction) {
      rows.insert(rows.end(), between.begin(), between.end());
      between.clear();
    }
    mill(std::move(rows));
    mill(std::move(between));
    trace_wanted();
  }

  /// Traces all waiting slices and stores their stretches in the path.
  void trace_wanted() {
    TracedStretches traced = traced_slices(tracer_, wanted_, [this](double share) {
      report(kSearchShare + (1.0 - kSearchShare) * share);
    });
    path_.without_arcs += traced.without_arcs;
    std::ranges::move(traced.stretches,
                      path_.stretches.end() - static_cast<std::ptrdiff_t>(wanted_.size()));
    wanted_.clear();
  }

  /// Adds a placeholder for the stretch over a slice, which trace_wanted() replaces.
  void want(const Slice& slice, StretchUse use) {
    wanted_.push_back({slice, use});
    path_.stretches.emplace_back();
  }

  /// Appends the pieces of a part that are over the surface and in all regions.
  void add_parts(const RowPart& part, std::vector<RowPart>& parts) const {
    constexpr double kMinPart = 1.0e-3;
    const Slice slice = frame_.slice(part, false);
    for (const auto& [begin, end] :
         common_parts(options_.regions, slice, tracer_.parts_over(slice))) {
      if (end - begin >= kMinPart) {
        parts.push_back({part.row, part.begin + begin, part.begin + end});
      }
    }
  }

  /// Mills parts of rows. Without a milling direction, begins at the lowest row and always
  /// continues with the nearest part. With a direction, mills row by row: upwards for conventional
  /// milling, downwards for climb milling.
  void mill(std::vector<RowPart> parts) {
    const bool is_climb = options_.direction == cnc::pocket::Milling::kClimb;
    PartQueue queue{std::move(parts)};
    for (bool is_first = true; !queue.empty(); is_first = false) {
      // The next lower row is on the right of a row. The stock is on this side until the lower row
      // is milled.
      mill(options_.direction || is_first ? queue.take_outermost(is_climb)
                                          : queue.take_nearest(frame_.seen(here_), may_go_back()));
    }
  }

  void mill(const PartQueue::Next& next) {
    const Slice slice = frame_.slice(next.part, next.goes_back);
    lead_to(slice.from);
    want(slice, use_of(next.part));
    layer_.push_back(next.part);
    here_ = slice.at(slice.length);
  }

  /// Returns kSlot if stock is on both sides of a part, else kRow. In a layer, stock is on both
  /// sides unless neighbouring rows on one side were milled along at least half of the part.
  [[nodiscard]] StretchUse use_of(const RowPart& part) const {
    if (options_.layer_mm == 0.0) return StretchUse::kRow;
    double below = 0.0;
    double above = 0.0;
    for (const RowPart& other : layer_) {
      const double beside = other.row - part.row;
      if (std::abs(beside) > 1.01 * step_mm_) continue;
      const double common = std::min(part.end, other.end) - std::max(part.begin, other.begin);
      (beside < 0.0 ? below : above) += std::max(0.0, common);
    }
    const bool is_open = std::max(below, above) >= 0.5 * (part.end - part.begin);
    return is_open ? StretchUse::kRow : StretchUse::kSlot;
  }

  /// Adds a link over the surface to `place` if it is near, the surface continues up to it and no
  /// region bars the link. Otherwise ends the run. The link is straight, or it goes along one of
  /// the two rows and then across, for example next to an island.
  void lead_to(const Vector2d& place) {
    if (path_.stretches.empty()) return;
    if (may_go_back() && place != here_) {
      const Vector2d from = frame_.seen(here_);
      const Vector2d to = frame_.seen(place);
      if (links_over({here_, place}) || links_over({here_, frame_.at(to.x(), from.y()), place}) ||
          links_over({here_, frame_.at(from.x(), to.y()), place})) {
        return;
      }
    }
    end_run();
  }

  /// Adds straight links between successive points if the links are short and allowed. Returns
  /// whether the links were added.
  bool links_over(const std::vector<Vector2d>& places) {
    constexpr double kMinLink = 1.0e-6;
    std::vector<Slice> slices;
    double length = 0.0;
    for (std::size_t i = 1; i < places.size(); ++i) {
      if ((places[i] - places[i - 1]).norm() < kMinLink) continue;
      slices.push_back(slice_between(places[i - 1], places[i]));
      length += slices.back().length;
    }
    if (length > kMaxLinkSteps * step_mm_) return false;
    const auto may_link = [this](const Slice& slice) {
      const SliceParts parts = tracer_.parts_over(slice);
      return parts.size() == 1 && parts[0].second - parts[0].first > 0.999 * slice.length &&
             lets_link_through(options_.regions, slice);
    };
    if (!std::ranges::all_of(slices, may_link)) return false;
    for (const Slice& slice : slices) want(slice, StretchUse::kLink);
    return true;
  }

  [[nodiscard]] bool may_go_back() const {
    return options_.order == RowOrder::kZigzag && !options_.direction;
  }

  void report(double share) const {
    if (options_.progress) options_.progress(share);
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
  double stock_top_mm_;         ///< Top of the remaining stock: the bottom of the last layer.
  std::vector<RowPart> layer_;  ///< Parts of rows that were milled in the current layer.
  SurfacePath path_;
  /// Slices of the last stretches of the path, which are not traced yet.
  std::vector<WantedStretch> wanted_;
  Vector2d here_ = Vector2d::Zero();
};

}  // namespace

SurfacePath row_path(const Mesh& mesh, const RowOptions& options) {
  return RowPlanner{mesh, options}.plan();
}

}  // namespace sim::surface
