#include "host-sim/machine/probe_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sim {
namespace {

/// Margin for the error of rounding a height to steps, in steps; greater than this error.
constexpr double kRoundingSteps = 2.0;
constexpr double kMaxSteps = 1.0e9;

}  // namespace

void ProbeModel::place(const cnc::Settings& settings) {
  for (std::size_t axis = 0; axis < steps_per_mm_.size(); ++axis) {
    steps_per_mm_[axis] = settings.get(cnc::setting::kStepsPerMm, axis);
  }
  has_height_ = false;
}

bool ProbeModel::is_closed(const PlayModel::Steps& axes) {
  const double z_mm = static_cast<double>(axes[2]) / static_cast<double>(steps_per_mm_[2]);
  if (z_mm <= model_.probe_plate_z_mm) return true;
  if (model_.probe_surface == nullptr || z_mm > model_.probe_surface->top_mm()) return false;
  return z_mm <= tip_height(axes);
}

double ProbeModel::tip_height(const PlayModel::Steps& axes) {
  if (has_height_ && axes[0] == x_step_ && axes[1] == y_step_) return height_mm_;
  has_height_ = true;
  x_step_ = axes[0];
  y_step_ = axes[1];
  height_mm_ = model_.probe_surface->tip_height(x_step_ / static_cast<double>(steps_per_mm_[0]),
                                                y_step_ / static_cast<double>(steps_per_mm_[1]),
                                                hint_);
  return height_mm_;
}

std::uint64_t ProbeModel::steps_undisturbed(const PlayModel::Steps& axes) const {
  const auto z_steps_per_mm = static_cast<double>(steps_per_mm_[2]);
  double steps = std::abs(axes[2] - model_.probe_plate_z_mm * z_steps_per_mm);
  if (model_.probe_surface != nullptr) {
    // Below the top of the surface, any step along X or Y may reach a wall.
    steps = std::min(steps, axes[2] - model_.probe_surface->top_mm() * z_steps_per_mm);
  }
  return static_cast<std::uint64_t>(std::clamp(steps - kRoundingSteps, 0.0, kMaxSteps));
}

}  // namespace sim
