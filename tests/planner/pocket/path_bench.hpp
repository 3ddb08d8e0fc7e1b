#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "planner/pocket/pocket_path.hpp"
#include "tests/planner/pocket/pocket_oracle.hpp"
#include "tests/planner/pocket/random_pocket.hpp"

namespace cnc::pocket {

/// The path of a pocket, with its storage.
class PathBench {
 public:
  static constexpr std::size_t kPoints = 300'000;

  explicit PathBench(PocketBench& pocket) : pocket_{pocket} {}

  Result<PocketReport, PocketError> write(const PocketOptions<double>& options) {
    writer_.clear();
    const PocketPathSpace<double> space{pocket_.space(),
                                        {states_.data(), states_.size()},
                                        {driven_.get(), PocketBench::kLoops},
                                        {locus_.data(), locus_.size()},
                                        {boxes_.data(), boxes_.size()}};
    return write_pocket_path<double>(pocket_.pocket(), options, space, pocket_.passes(), writer_);
  }
  [[nodiscard]] ToolPathView<double> path() const { return writer_.view(); }

 private:
  PocketBench& pocket_;
  std::vector<PassState> states_{PocketBench::kPassElements};
  std::unique_ptr<bool[]> driven_ = std::make_unique<bool[]>(PocketBench::kLoops);
  std::vector<contour::Curve<double>> locus_{PocketBench::kElements};
  std::vector<contour::FlatBox<double>> boxes_ = std::vector<contour::FlatBox<double>>(
      contour::BoxTree<double>::size_for(PocketBench::kElements));
  std::vector<PathPoint<double>> points_{kPoints};
  std::vector<std::uint32_t> row_ends_ = std::vector<std::uint32_t>(kPoints);
  ToolPathWriter<double> writer_{{points_.data(), points_.size()},
                                 {row_ends_.data(), row_ends_.size()}};
};

/// Calls `visit(from, to)` for each element of a path.
template <typename Visit>
void for_each_element(const ToolPathView<double>& path, Visit&& visit) {
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    for (std::uint32_t i = path.row_begin(row); i + 1 < path.row_ends[row]; ++i) {
      visit(path.points[i], path.points[i + 1]);
    }
  }
}

inline contour::exact::ChainArc arc_of(const PathPoint<double>& from, const PathPoint<double>& to) {
  return {from.point(), to.point(), from.bulge};
}

/// Returns the length of an element in the plane, by its angle.
inline double flat_length(const PathPoint<double>& from, const PathPoint<double>& to) {
  const double chord = (to.point() - from.point()).norm();
  const double half_sweep = 2.0 * std::atan(std::abs(from.bulge));
  return half_sweep < 1.0e-7 ? chord : chord * half_sweep / std::sin(half_sweep);
}

/// Returns the degrees between the directions in which one element ends and the next begins. The
/// elements must not be vertical.
inline double kink_between(const PathPoint<double>& a,
                           const PathPoint<double>& b,
                           const PathPoint<double>& c) {
  using contour::exact::BothWays;
  return BothWays::kink(BothWays::arriving(arc_of(a, b)), BothWays::leaving(arc_of(b, c)));
}

/// Returns the usual options of tests: corners are rounded by a tenth of the radius.
inline PocketOptions<double> usual_options(double radius) {
  return {.clearing = {radius, 0.1 * radius, 2.0 * radius},
          .entry = {EntryKind::kHelix, 0.1, 0.8 * radius},
          .milling = Milling::kClimb,
          .depth = radius,
          .depth_step = 0.6 * radius};
}

}  // namespace cnc::pocket
