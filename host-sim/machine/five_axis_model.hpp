#pragma once

#include <Eigen/Geometry>
#include <array>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim {

/// The tool of a five-axis machine as the part sees it.
struct ToolPose {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();    ///< A program's place under G43.4, mm.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Unit vector from the tip into the tool.
};

/// Where the tool of a five-axis machine is when its axes are somewhere: the whole chain from the
/// part to the tip as rigid motions in double precision. It shares nothing with the controller's
/// formulas, so that one checks the other.
class FiveAxisModel {
 public:
  /// @param settings $900 to $917
  /// @param tool_length_mm from the machine's gauge point to the tip
  FiveAxisModel(const cnc::Settings& settings, double tool_length_mm);

  /// Returns whether the machine has rotary axes that lean a tool.
  [[nodiscard]] bool leans() const { return kind_ != Kind::kNone; }

  /// @param axes X Y Z in mm, A B C in degrees, machine coordinates
  [[nodiscard]] ToolPose tool_at(const Point& axes) const;

  /// Returns the place of a program for axes: that of the tip, with the rotary axes as they are.
  [[nodiscard]] Point program_for(const Point& axes) const;
  /// Returns the place of the axes for one of a program.
  [[nodiscard]] Point axes_for(const Point& program) const;

 private:
  enum class Kind { kNone, kTables, kHeads, kHeadAndTable };

  /// How the tables and the head have moved, the head as seen from what carries it.
  struct Turned {
    Eigen::Isometry3d part = Eigen::Isometry3d::Identity();
    Eigen::Isometry3d head = Eigen::Isometry3d::Identity();
  };

  [[nodiscard]] Turned turned_to(const Point& axes) const;
  [[nodiscard]] Eigen::Vector3d tool() const { return {0.0, 0.0, -tool_length_mm_}; }
  [[nodiscard]] Eigen::Isometry3d tilt(double degrees) const;
  [[nodiscard]] Eigen::Isometry3d turn(double degrees) const;

  Kind kind_ = Kind::kNone;
  std::size_t tilting_ = 3;  ///< Index of A or B.
  bool tilt_reversed_ = false;
  bool turn_reversed_ = false;
  Eigen::Vector3d tilt_point_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_point_ = Eigen::Vector3d::Zero();
  double tool_length_mm_ = 0.0;
};

}  // namespace sim
