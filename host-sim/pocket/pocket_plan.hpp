#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "planner/pocket/pocket_path.hpp"

namespace sim::pocket {

/// Thrown if a pocket has no path: the options do not fit the pocket, or its contours cross.
class NoPocketPath : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;  ///< The text has the form `reason; remedy`.
};

/// A path that clears a pocket, with its passes. Each pass is a contour.
struct PocketPlan : PathRows {
  std::vector<Contour> passes;
  /// For each pass, the number of the pass around it; kNone at the wall.
  std::vector<std::uint32_t> parents;
  cnc::pocket::PocketReport report;
};

/// Makes the planner's pocket paths. Its storage grows until it is large enough. The next pocket
/// reuses the storage.
class PocketPlanner {
 public:
  /// Greatest number of elements in the storage for one pass. An element requires about 3 KiB.
  static constexpr std::size_t kMaxElements = 1'000'000;
  /// Greatest number of points of a path, and of vertices of all passes. Each requires 44 bytes.
  static constexpr std::size_t kMaxPoints = 20'000'000;

  PocketPlanner() = default;

  /// Makes the path of a pocket. Throws NoPocketPath.
  /// @param pocket closed contours that do not cross, with the pocket on their left
  [[nodiscard]] PocketPlan plan(const cnc::contour::ContourView<double>& pocket,
                                const cnc::pocket::PocketOptions<double>& options);

 private:
  using Vertices = std::vector<ContourVertex>;
  using Indices = std::vector<std::uint32_t>;

  struct Loops {
    Vertices vertices;
    Indices loop_ends;

    void resize(std::size_t size);
    [[nodiscard]] cnc::pocket::LoopSpace<double> slices();
  };
  struct Areas {
    Vertices vertices;
    Indices loop_ends;
    std::vector<cnc::pocket::AreaRange> ranges;

    void resize(std::size_t size);
    [[nodiscard]] cnc::pocket::AreaSpace<double> slices();
  };

  void grow(std::size_t elements);
  void grow_passes(std::size_t elements);
  void grow_path(std::size_t points);
  /// Grows the storage that `error` reports as too small. Throws for every other error.
  void grow_or_refuse(const cnc::pocket::PocketError& error, const ContourVertex& begin);
  [[nodiscard]] cnc::pocket::PocketPathSpace<double> space();

  std::size_t elements_ = 0;
  OwnedOffsetSpace offset_;
  Loops loops_;
  Loops inner_;
  Loops grown_;
  Areas left_;
  Areas goals_;
  std::vector<cnc::pocket::LoopNote<double>> notes_;
  Areas passes_;
  std::vector<cnc::pocket::PassNote<double>> pass_notes_;
  std::vector<cnc::pocket::PassState> states_;
  // An array, because std::vector<bool> does not store its items as bool.
  std::unique_ptr<bool[]> driven_loops_;  // NOLINT(modernize-avoid-c-arrays)
  std::vector<cnc::contour::Curve<double>> locus_;
  std::vector<cnc::contour::FlatBox<double>> locus_boxes_;
  std::vector<cnc::pocket::PathPoint<double>> points_;
  std::vector<std::uint32_t> row_ends_;
};

}  // namespace sim::pocket
