#include "host-sim/surface/patch/patch_heights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace sim::surface::patch {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Returns, for each quadrilateral of the grid, the number of the patch that covers it.
std::vector<std::uint32_t> numbers_of(const PatchSurface& surface) {
  const std::size_t width = surface.columns - 1;
  std::vector<std::uint32_t> numbers((surface.rows - 1) * width, 0);
  for (std::uint32_t number = 0; number < surface.patches.size(); ++number) {
    const GridPatch& patch = surface.patches[number];
    const auto end_row = static_cast<std::size_t>(patch.u.to);
    const auto end_column = static_cast<std::size_t>(patch.v.to);
    for (auto row = static_cast<std::size_t>(patch.u.from); row < end_row; ++row) {
      for (auto column = static_cast<std::size_t>(patch.v.from); column < end_column; ++column) {
        numbers[row * width + column] = number;
      }
    }
  }
  return numbers;
}

/// Returns the bounding boxes of the patches in plan; Z is 0.
std::vector<Eigen::AlignedBox3d> boxes_of(const PatchSurface& surface) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(surface.patches.size());
  for (const GridPatch& patch : surface.patches) {
    Eigen::AlignedBox3d box;
    for (const BezierCurve& row : patch.shape.rows) {
      for (const Vector3d& control : row.controls) {
        box.extend(Vector3d{control.x(), control.y(), 0.0});
      }
    }
    boxes.push_back(box);
  }
  return boxes;
}

}  // namespace

PatchHeights::PatchHeights(PatchSurface surface)
    : surface_{std::move(surface)},
      numbers_{numbers_of(surface_)},
      last_{static_cast<double>(surface_.rows - 1), static_cast<double>(surface_.columns - 1)},
      tree_{boxes_of(surface_)} {
  take_rim();
  require_no_fold();
}

void PatchHeights::take_rim() {
  for (double row = 0.0; row <= last_.row; row += 1.0) {
    rim_.push_back({row, 0.0});
    rim_.push_back({row, last_.column});
  }
  for (double column = 0.0; column <= last_.column; column += 1.0) {
    rim_.push_back({0.0, column});
    rim_.push_back({last_.row, column});
  }
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Hint& at : rim_) {
    const Vector3d point = jet_at(at).point;
    boxes.emplace_back(Vector3d{point.x(), point.y(), 0.0});
  }
  rim_tree_ = BoxTree{boxes};
}

void PatchHeights::require_no_fold() const {
  constexpr int kLooks = 4;
  const double sign = jet_at({0.0, 0.0}).area();
  for (const GridPatch& patch : surface_.patches) {
    for (int i = 0; i <= kLooks; ++i) {
      for (int j = 0; j <= kLooks; ++j) {
        const Hint at{patch.u.from + (patch.u.to - patch.u.from) * i / kLooks,
                      patch.v.from + (patch.v.to - patch.v.from) * j / kLooks};
        if (sign * jet_at(at).area() > 0.0) continue;
        throw std::invalid_argument{fmt::format(
            "the smooth patches fold near row {:.0f} column {:.0f}, where the points are too "
            "uneven; choose a smaller --fit-tolerance, or measure these points again",
            std::floor(at.row) + 1.0,
            std::floor(at.column) + 1.0)};
      }
    }
  }
}

/// Returns the point and derivatives at a row and column. Beyond the rim, the surface continues
/// straight in the direction of its derivatives there.
PatchHeights::Jet PatchHeights::jet_at(const Hint& at) const {
  const double on_row = std::clamp(at.row, 0.0, last_.row);
  const double on_column = std::clamp(at.column, 0.0, last_.column);
  const auto row = std::min(static_cast<std::size_t>(on_row), surface_.rows - 2);
  const auto column = std::min(static_cast<std::size_t>(on_column), surface_.columns - 2);
  const GridPatch& patch = surface_.patches[numbers_[row * (surface_.columns - 1) + column]];
  const double height = patch.u.to - patch.u.from;
  const double width = patch.v.to - patch.v.from;
  const PatchJet jet =
      patch.shape.jet((on_row - patch.u.from) / height, (on_column - patch.v.from) / width);
  Jet result{jet.point, jet.along_u / height, jet.along_v / width};
  const double rows = at.row - on_row;
  const double columns = at.column - on_column;
  if (rows == 0.0 && columns == 0.0) return result;
  const Vector3d twist = jet.twist / (height * width);
  result.point += rows * result.by_row + columns * result.by_column + rows * columns * twist;
  result.by_row += columns * twist;
  result.by_column += rows * twist;
  return result;
}

std::optional<double> PatchHeights::height_from(const Vector2d& place,
                                                const Hint& most,
                                                Hint& at) const {
  constexpr int kMaxSteps = 24;
  // Step, in rows or columns, at which the search ends. The error of the height is of the order of
  // the square of the last step.
  constexpr double kLastStep = 1.0e-7;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Jet jet = jet_at(at);
    const Vector2d off = place - jet.point.head<2>();
    const double area = jet.area();
    const Hint step{(off.x() * jet.by_column.y() - off.y() * jet.by_column.x()) / area,
                    (off.y() * jet.by_row.x() - off.x() * jet.by_row.y()) / area};
    if (!std::isfinite(step.row) || !std::isfinite(step.column)) return std::nullopt;
    if (std::abs(step.row) <= kLastStep && std::abs(step.column) <= kLastStep) {
      return jet.point.z() + step.row * jet.by_row.z() + step.column * jet.by_column.z();
    }
    at.row += std::clamp(step.row, -most.row, most.row);
    at.column += std::clamp(step.column, -most.column, most.column);
  }
  return std::nullopt;
}

bool PatchHeights::is_on(const Hint& at) const {
  return at.row >= 0.0 && at.row <= last_.row && at.column >= 0.0 && at.column <= last_.column;
}

/// Searches for the height in all patches whose bounding box in plan contains `place`. Sets `at` if
/// it finds the height.
std::optional<double> PatchHeights::height_within(const Vector2d& place, Hint& at) const {
  constexpr std::array<double, 3> kStarts{0.5, 0.1, 0.9};
  std::optional<double> found;
  const auto try_patch = [&](std::uint32_t number) {
    const GridPatch& patch = surface_.patches[number];
    const Hint size{patch.u.to - patch.u.from, patch.v.to - patch.v.from};
    for (const double u : kStarts) {
      for (const double v : kStarts) {
        if (found) return;
        Hint start{patch.u.from + u * size.row, patch.v.from + v * size.column};
        const std::optional<double> height = height_from(place, size, start);
        if (!height || !is_on(start)) continue;
        found = height;
        at = start;
      }
    }
  };
  tree_.visit_near(
      {place.x(), place.y(), 0.0}, [&found] { return found ? -1.0 : 0.0; }, try_patch);
  return found;
}

PatchHeights::Hint PatchHeights::nearest_of_rim(const Vector2d& place) const {
  const Vector3d level{place.x(), place.y(), 0.0};
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::max();
  rim_tree_.visit_near(
      level,
      [&least] { return least; },
      [&](std::uint32_t number) {
        const double distance = (jet_at(rim_[number]).point.head<2>() - place).norm();
        if (distance > least || (distance == least && number > nearest)) return;
        least = distance;
        nearest = number;
      });
  return rim_[nearest];
}

std::optional<double> PatchHeights::height(const Vector2d& place, Hint& hint) const {
  Hint at = hint;
  std::optional<double> found = height_from(place, last_, at);
  if (!found || !is_on(at)) found = height_within(place, at);
  if (!found) {
    // Outside a curved rim, several points of the continued surface may be over `place`. The search
    // starts at a point that depends only on `place`, so that the result does not depend on the
    // hint.
    at = nearest_of_rim(place);
    found = height_from(place, last_, at);
  }
  if (found) hint = at;
  return found;
}

}  // namespace sim::surface::patch
