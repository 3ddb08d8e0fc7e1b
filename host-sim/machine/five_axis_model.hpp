#pragma once

#include <Eigen/Geometry>
#include <array>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim {

/// Pose of a five-axis machine's tool relative to the part.
struct ToolPose {
  /// Position of the tip in the program's coordinates under G43.4, mm.
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Unit vector from the tip into the tool.
};

/// Computes the pose of a five-axis machine's tool from the positions of its axes. It multiplies
/// the rigid motions from the part to the tip in double precision. The model shares no formula with
/// the controller, so that each can check the other.
class FiveAxisModel {
 public:
  /// Builds the model.
  /// @param settings $900 to $917 describe the machine
  /// @param tool_length_mm distance from the machine's gauge point to the tip, mm
  FiveAxisModel(const cnc::Settings& settings, double tool_length_mm);

  /// Returns whether the machine has rotary axes that tilt the tool.
  [[nodiscard]] bool leans() const { return kind_ != Kind::kNone; }

  /// Returns the pose of the tool.
  /// @param axes X Y Z in mm, A B C in degrees, machine coordinates
  [[nodiscard]] ToolPose tool_at(const Point& axes) const;

  /// Returns the program's position for positions of the axes: X Y Z of the tip, and the rotary
  /// axes unchanged.
  [[nodiscard]] Point program_for(const Point& axes) const;
  /// Returns the positions of the axes for a program's position.
  [[nodiscard]] Point axes_for(const Point& program) const;

 private:
  enum class Kind { kNone, kTables, kHeads, kHeadAndTable };

  /// Motion of the part by tables, and motion of the head. The motion of the head is relative to
  /// the carrier of the head.
  struct Turned {
    Eigen::Isometry3d part = Eigen::Isometry3d::Identity();
    Eigen::Isometry3d head = Eigen::Isometry3d::Identity();
  };

  [[nodiscard]] Turned turned_to(const Point& axes) const;
  [[nodiscard]] Eigen::Vector3d tool() const { return {0.0, 0.0, -tool_length_mm_}; }
  [[nodiscard]] Eigen::Isometry3d tilt(double degrees) const;
  [[nodiscard]] Eigen::Isometry3d turn(double degrees) const;

  Kind kind_ = Kind::kNone;
  std::size_t tilting_ = 3;  ///< Index of the tilting axis, A or B.
  bool tilt_reversed_ = false;
  bool turn_reversed_ = false;
  Eigen::Vector3d tilt_point_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_point_ = Eigen::Vector3d::Zero();
  double tool_length_mm_ = 0.0;
};

}  // namespace sim
