#include "host-sim/job/tip_trace.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {

FiveAxisMachine described(const cnc::Settings& settings) {
  namespace setting = cnc::setting;
  const auto whole = [&](std::uint16_t number) { return static_cast<int>(settings.get(number)); };
  const auto point = [&](std::uint16_t first) {
    return std::array<double, 3>{
        settings.get(first, 0), settings.get(first, 1), settings.get(first, 2)};
  };
  const int chosen = whole(setting::kRotaryAxes);
  constexpr std::array<const char*, 3> kKinds{"tables", "heads", "head and table"};
  return {.kind = kKinds.at(static_cast<std::size_t>((chosen - 1) / 2)),
          .tilting = chosen % 2 == 0 ? 'B' : 'A',
          .tilt_reversed = whole(setting::kRotaryReversed) % 2 == 1,
          .turn_reversed = whole(setting::kRotaryReversed) / 2 == 1,
          .tilt_point_mm = point(setting::kTiltPoint),
          .turn_point_mm = point(setting::kTurnPoint),
          .min_tilt_deg = settings.get(setting::kMinTilt),
          .greatest_tilt_deg = settings.get(setting::kMaxTilt)};
}

}  // namespace

void TipTrace::on_row(const TraceRow& row) {
  const cnc::kinematics::ToolCentre& centre = machine_.motion().tool_centre();
  // After the end of G43.4, the tool stays leaning until the axes move. Until then, the trace still
  // contains the position of the tip.
  const bool stands = model_ && row.position == last_;
  if (!centre.active() && !stands) {
    model_.reset();
    deviation_.on_row(row);
    for (TraceSink* sink : sinks_) sink->on_row(row);
    return;
  }
  const cnc::Settings& settings = machine_.settings();
  last_ = row.position;
  if (!model_ || (centre.active() && tool_length_ != centre.tool_length())) {
    tool_length_ = centre.tool_length();
    model_.emplace(settings, 1.0e-6 * static_cast<double>(tool_length_.nanometres()));
  }
  Point axes{};
  Point scale{};
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    scale[axis] = static_cast<double>(settings.get(cnc::setting::kStepsPerMm, axis));
    axes[axis] = row.position[axis] / scale[axis];
  }
  const ToolPose tool = model_->tool_at(axes);
  note(tool);
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    axes[axis] = tool.tip[static_cast<Eigen::Index>(axis)];
  }
  deviation_.stand(row.time_ns, axes);
  TraceRow seen = row;
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    seen.position[axis] = static_cast<std::int32_t>(std::lround(axes[axis] * scale[axis]));
  }
  for (TraceSink* sink : sinks_) sink->on_row(seen);
}

void TipTrace::note(const ToolPose& tool) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const double tilt = kDegrees * std::acos(std::clamp(tool.axis.z(), -1.0, 1.0));
  const std::array<double, 3> place{tool.tip.x(), tool.tip.y(), tool.tip.z()};
  if (!tip_) {
    tip_.emplace(TipReport{
        .min_mm = place, .greatest_mm = place, .machine = described(machine_.settings())});
  }
  tip_->tool_length_mm = 1.0e-6 * static_cast<double>(tool_length_.nanometres());
  for (std::size_t i = 0; i < place.size(); ++i) {
    tip_->min_mm[i] = std::min(tip_->min_mm[i], place[i]);
    tip_->greatest_mm[i] = std::max(tip_->greatest_mm[i], place[i]);
  }
  tip_->greatest_tilt_deg = std::max(tip_->greatest_tilt_deg, tilt);
}

}  // namespace sim
