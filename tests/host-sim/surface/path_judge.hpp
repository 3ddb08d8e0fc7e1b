#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "host-sim/cut/stroke.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_program.hpp"
#include "planner/surface/grown.hpp"

namespace sim::surface {

inline constexpr double kSafeMm = 50.0;

inline pocket::MillSettings mill_settings() {
  return {.feed_mm_min = 1'500.0, .plunge_mm_min = 400.0, .safe_mm = kSafeMm};
}

inline std::string text_of(const SurfacePath& path, const RowOptions& options) {
  const auto decimals = static_cast<std::uint8_t>(std::lround(-std::log10(options.digit_mm)));
  return program_of(path, mill_settings(), cnc::gcode::PrintGrid{decimals}, {});
}

/// Calls a function with positions of the tip along all feeds of a program, as an independent
/// reader interprets it. Of descents, it passes only the lowest position, even if no feed follows.
template <typename Function>
void for_places(const std::string& program, double every_mm, const Function& function) {
  for (const PathPiece& piece : read_program(program).pieces) {
    if (piece.travel != Travel::kFeed) continue;
    const Point& from = piece.curve.start();
    const Point& to = piece.curve.end();
    if (from[0] == to[0] && from[1] == to[1] && to[2] < from[2] - 0.9) {
      function(Eigen::Vector3d{to[0], to[1], to[2]});
      continue;
    }
    const int count = 2 + static_cast<int>(piece.curve.length() / every_mm);
    for (int i = 0; i <= count; ++i) {
      const Point at = piece.curve.point_at(static_cast<double>(i) / count);
      function(Eigen::Vector3d{at[0], at[1], at[2]});
    }
  }
}

/// Calls a function with positions of the tip along the level lines of a path.
template <typename Function>
void for_level_places(const SurfacePath& path, double every_mm, const Function& function) {
  for (const SurfaceStretch& stretch : path.stretches) {
    if (stretch.use != StretchUse::kRow) continue;
    for (std::size_t i = 0; i + 1 < stretch.vertices.size(); ++i) {
      const ContourVertex& from = stretch.vertices[i];
      const ContourVertex& to = stretch.vertices[i + 1];
      const cut::Stroke stroke{.from = {from.x, from.y}, .to = {to.x, to.y}, .bulge = from.bulge};
      const int count = 1 + static_cast<int>(cut::length_of(stroke) / every_mm);
      for (int k = 0; k < count; ++k) {
        const Eigen::Vector2d place = cut::place_at(stroke, (k + 0.5) / count);
        function(Eigen::Vector3d{place.x(), place.y(), stretch.start().z()});
      }
    }
  }
}

/// Checks positions of the tip with the exact heights of the tool and the allowed air.
class Judge {
 public:
  /// @param smooth_mm band of a smooth surface that the path follows
  Judge(const Mesh& mesh, const RowOptions& options, double smooth_mm = 0.0)
      : options_{options},
        exact_{mesh, tool_of(options)},
        max_air_{2.0 * options.tolerance_mm + smooth_mm} {
    double lowest = 1.0e9;
    for (const Eigen::Vector3d& point : mesh.points) lowest = std::min(lowest, point.z());
    floor_ = options.floor_mm.value_or(lowest) + options.allowance_mm;
  }

  /// Returns the depth by which the tip gouges the surface, vertically; negative above the surface.
  [[nodiscard]] double gouge(const Eigen::Vector3d& tip) const {
    return height(tip.head<2>()) - tip.z();
  }

  /// Returns whether the tool does not touch at any point within the allowed air, so that there is
  /// too much air.
  [[nodiscard]] bool is_too_high(const Eigen::Vector3d& tip) const {
    const double most = max_air_ + 1.0e-9;
    if (tip.z() - height(tip.head<2>()) <= most) return false;
    constexpr int kDirections = 32;
    for (int ring = 1; ring <= 16; ++ring) {
      const double out = most * ring / 16.0;
      const double down = std::sqrt(std::max(0.0, most * most - out * out));
      for (int i = 0; i < kDirections; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kDirections;
        const Eigen::Vector2d beside{out * std::cos(angle), out * std::sin(angle)};
        if (tip.z() - down <= height(tip.head<2>() + beside)) return false;
      }
    }
    return true;
  }

 private:
  static cnc::surface::Profile tool_of(const RowOptions& options) {
    cnc::surface::Profile tool = options.tool;
    if (options.allowance_mm == 0.0) return tool;
    return cnc::surface::grown(tool, options.allowance_mm).profile;
  }
  [[nodiscard]] double height(const Eigen::Vector2d& place) const {
    return std::max(floor_, exact_.tip_height(place) + options_.allowance_mm);
  }

  RowOptions options_;
  DropCutter exact_;
  double max_air_;
  double floor_ = 0.0;
};

}  // namespace sim::surface
