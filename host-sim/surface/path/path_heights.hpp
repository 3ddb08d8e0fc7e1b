#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/path/smooth_tips.hpp"

namespace sim::surface {

/// Computes the heights that paths over a surface follow: the heights of a tool's tip or, instead,
/// the heights of a smooth surface.
class PathHeights {
 public:
  /// Results of the last search, from which the search at a nearby point begins.
  struct Hint {
    DropCutter::Hint exact{};
    SmoothTips::Hint smooth{};
  };

  /// @param smooth smooth surface of the same mesh and tool; if empty, the heights of the tip are
  /// used
  PathHeights(const Mesh& mesh,
              const cnc::surface::Profile& tool,
              std::shared_ptr<const SmoothTips> smooth)
      : cutter_{mesh, tool}, smooth_{std::move(smooth)} {}

  /// Returns the height over `place`; cnc::surface::kNoContact if nothing is under the tool.
  [[nodiscard]] double operator()(const Eigen::Vector2d& place, Hint& hint) const {
    const double exact = cutter_.tip_height(place, hint.exact);
    return smooth_ ? smooth_->height(place, exact, hint.smooth) : exact;
  }
  [[nodiscard]] double operator()(const Eigen::Vector2d& place) const {
    const double exact = cutter_.tip_height(place);
    if (!smooth_) return exact;
    SmoothTips::Hint hint;
    return smooth_->height(place, exact, hint);
  }
  /// Returns whether anything is under the tool.
  [[nodiscard]] bool has_contact(const Eigen::Vector2d& place, Hint& hint) const {
    if (!smooth_) return cutter_.has_contact(place, hint.exact);
    return (*this)(place, hint) != cnc::surface::kNoContact;
  }

 private:
  DropCutter cutter_;
  std::shared_ptr<const SmoothTips> smooth_;
};

}  // namespace sim::surface
