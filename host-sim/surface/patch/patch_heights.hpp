#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/surface/box_tree.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// The heights of a composite surface over points in plan, mm. All threads may call the const
/// functions at once.
class PatchHeights {
 public:
  /// Row and column of the surface at which the search for a height starts, taken from a point near
  /// by. They change the result by rounding alone.
  struct Hint {
    double row = 0.0;
    double column = 0.0;
  };

  /// Throws std::invalid_argument, with row and column, for a surface that folds in plan.
  /// @pre the ends of all patches are whole rows and columns, as those of fitted_surface()
  explicit PatchHeights(PatchSurface surface);

  [[nodiscard]] const PatchSurface& surface() const { return surface_; }

  /// Returns the height of the surface over a point in plan. Beyond its rim the surface continues
  /// straight, so that heights have no step there. Returns nothing if no search converges, for
  /// example far outside a curved rim.
  [[nodiscard]] std::optional<double> height(const Eigen::Vector2d& place, Hint& hint) const;

 private:
  /// A point of the surface and its derivatives by row and by column.
  struct Jet {
    Eigen::Vector3d point;
    Eigen::Vector3d by_row;
    Eigen::Vector3d by_column;

    /// Returns the signed area in plan that the two derivatives span.
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
  Hint last_;                           ///< The last row and column.
  BoxTree tree_;                        ///< Boxes of the patches in plan.
  std::vector<Hint> rim_;               ///< Rows and columns of the points of the grid's rim.
  BoxTree rim_tree_;                    ///< Boxes of the points of the rim in plan.
};

}  // namespace sim::surface::patch
