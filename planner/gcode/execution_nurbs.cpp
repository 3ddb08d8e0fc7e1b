#include "planner/gcode/execution.hpp"

namespace cnc::gcode {

/// Checks a line while a NURBS is open. Such a line may only give a control point or end the NURBS.
/// All other words would have an effect in the middle of a curve that is not complete yet.
Refusal Execution::check_open_nurbs() {
  if (!nurbs_is_open()) return std::nullopt;
  for (std::size_t index = 0; index < kModalGroupCount; ++index) {
    const auto group = static_cast<ModalGroup>(index);
    if (!block_.has(group) || group == ModalGroup::kUnits || group == ModalGroup::kDistance) {
      continue;
    }
    const MotionMode mode = next_.modal.motion;
    const bool goes_on =
        group == ModalGroup::kMotion &&
        (mode == MotionMode::kNurbs || mode == MotionMode::kNurbsEnd || mode == MotionMode::kNone);
    if (!goes_on) return block_.blame(FaultDetail::kNotInANurbs, group);
  }
  for (const char letter : {'S', 'T'}) {
    if (block_.has(letter)) return block_.blame(FaultDetail::kNotInANurbs, letter);
  }
  return std::nullopt;
}

/// Handles G5.2 and the lines after it. The present position is the first control point. A P
/// without X and Y is the weight of the first point. In G91 all points are relative to the first
/// one, as in LinuxCNC.
Refusal Execution::take_control_point() {
  if (next_.modal.plane != Plane::kXY) return blame_motion(FaultDetail::kSplineNeedsG17);
  if (next_.modal.feed_mode == FeedMode::kUnitsPerMinute) {
    if (const auto fault = check_feed()) return fault;
  }
  if (nurbs_is_open() && next_.position != store_.start) {
    return blame_motion(FaultDetail::kMovedInANurbs);
  }
  NurbsLine line{.begins = !nurbs_is_open()};
  if (const auto fault = take_order(line.order)) return fault;
  const auto fault = block_.has_axis_word() ? read_control_point(line) : weigh_first_point(line);
  if (fault) return fault;
  nurbs_line_ = line;
  return std::nullopt;
}

/// Reads the weight of the first control point, if the line has a P. After the second control
/// point, a P without X and Y is an unused word.
Refusal Execution::weigh_first_point(NurbsLine& line) {
  const bool alone = line.begins || store_.spline.size() == 1;
  if (!alone || !block_.has('P')) return std::nullopt;
  float weight = 1.0F;
  if (const auto fault = take_weight(weight)) return fault;
  line.first_weight = weight;
  return std::nullopt;
}

Refusal Execution::read_control_point(NurbsLine& line) {
  Position target = next_.position;
  if (const auto fault = read_spline_end(target)) return fault;
  if (!block_.has('X')) return missing_in_motion('X');
  if (!block_.has('Y')) return missing_in_motion('Y');
  const PlaneVector offset = from_here(target);
  ControlPoint point{.place = {offset.first, offset.second}};
  if (const auto fault = take_weight(point.weight)) return fault;
  if (const auto fault = check_control_point(point.place, 'X')) return fault;
  if (!line.begins && store_.spline.full()) {
    Fault fault = block_.blame(FaultDetail::kTooManyControlPoints, 'X');
    fault.limit = static_cast<float>(Spline::kMaxPoints);
    return fault;
  }
  line.point = point;
  return std::nullopt;
}

Refusal Execution::take_order(std::size_t& order) {
  const Decimal* const number = block_.take('L');
  if (number == nullptr) return std::nullopt;
  if (number->whole < Spline::kLowestOrder || number->whole > Spline::kHighestOrder ||
      number->is_negative()) {
    return block_.blame(FaultDetail::kNotAnOrder, 'L');
  }
  order = number->whole;
  return std::nullopt;
}

Refusal Execution::take_weight(float& weight) {
  const Decimal* const number = block_.take('P');
  if (number == nullptr) return std::nullopt;
  weight = number->to_float();
  if (weight >= Spline::kMinWeight && weight <= Spline::kMaxWeight) return std::nullopt;
  return block_.blame(FaultDetail::kNotAWeight, 'P');
}

/// Handles G5.3: appends the action for the curve, which ends at the last control point.
Refusal Execution::end_nurbs() {
  if (!nurbs_is_open()) return blame_motion(FaultDetail::kNurbsNotOpen);
  if (next_.position != store_.start) return blame_motion(FaultDetail::kMovedInANurbs);
  const Spline& spline = store_.spline;
  if (!spline.complete()) {
    Fault fault = blame_motion(FaultDetail::kTooFewControlPoints);
    fault.limit = static_cast<float>(spline.order());
    return fault;
  }
  const PlanePlace& last = spline.point(spline.size() - 1).place;
  Position end = store_.start;
  end[0] += Coordinate{last.x};
  end[1] += Coordinate{last.y};
  next_.modal.motion = MotionMode::kNone;
  return append_spline(end);
}

void Execution::commit_nurbs() {
  if (!nurbs_line_) return;
  Spline& spline = store_.spline;
  if (nurbs_line_->begins) {
    store_.start = context_.position;
    spline.clear();
    spline.set_order(Spline::kLowestOrder);
    spline.append({});
  }
  if (nurbs_line_->order != 0) spline.set_order(nurbs_line_->order);
  if (nurbs_line_->first_weight) spline.set_first_weight(*nurbs_line_->first_weight);
  if (nurbs_line_->point) spline.append(*nurbs_line_->point);
}

}  // namespace cnc::gcode
