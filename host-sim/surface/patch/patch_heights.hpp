#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/surface/box_tree.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Computes the heights of a composite surface over points in plan, mm. Several threads may call
/// the const functions at the same time.
class PatchHeights {
 public:
  /// Row and column of the surface at which the search for a height starts, usually the result at a
  /// nearby point. The hint affects the result only by rounding.
  struct Hint {
    double row = 0.0;
    double column = 0.0;
  };

  /// Throws std::invalid_argument, with row and column, for a surface that folds in plan.
  /// @pre the ends of all patches are whole rows and columns, as fitted_surface() makes them
  explicit PatchHeights(PatchSurface surface);

  [[nodiscard]] const PatchSurface& surface() const { return surface_; }

  /// Returns the height of the surface over a point in plan. Beyond the rim the surface continues
  /// straight, so that the heights are continuous. Returns nothing if no search converges, for
  /// example far outside a curved rim.
  [[nodiscard]] std::optional<double> height(const Eigen::Vector2d& place, Hint& hint) const;

 private:
  /// A point of the surface and its derivatives by row and by column.
  struct Jet {
    Eigen::Vector3d point;
    Eigen::Vector3d by_row;
    Eigen::Vector3d by_column;

    /// Returns the signed area in plan of the parallelogram of the two derivatives.
    [[nodiscard]] double area() const {
      return by_row.x() * by_column.y() - by_row.y() * by_column.x();
    }
  };

  [[nodiscard]] Jet jet_at(const Hint& at) const;
  [[nodiscard]] std::optional<double> height_from(const Eigen::Vector2d& place,
                                                  const Hint& most,
                                                  Hint& at) const;
  [[nodiscard]] std::optional<double> height_within(const Eigen::Vector2d& place, Hint& at) const;
  [[nodiscard]] Hint nearest_of_rim(const Eigen::Vector2d& place) const;
  [[nodiscard]] bool is_on(const Hint& at) const;
  void take_rim();
  void require_no_fold() const;

  PatchSurface surface_;
  std::vector<std::uint32_t> numbers_;  ///< Patch number of each quadrilateral, row by row.
  Hint last_;                           ///< Greatest row and column of the grid.
  BoxTree tree_;                        ///< Bounding boxes of the patches in plan.
  std::vector<Hint> rim_;               ///< Rows and columns of the points of the grid's rim.
  BoxTree rim_tree_;                    ///< Positions of the rim's points in plan.
};

}  // namespace sim::surface::patch
