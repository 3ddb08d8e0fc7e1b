#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Grbl's error number for a target beyond the travel.
inline constexpr int kTravelExceeded = 15;

/// Checks the path of a program against the travel of each axis ($130…$135; 0 stands for an endless
/// axis), even if soft limits ($20) are off.
///
/// The ends of a homed axis are known, and the path must stay between them. For any other axis,
/// only the extent of the path is checked: a job that is no larger than the travel fits at some
/// position. Each axis has at most one fault. The fault is at the line that first goes too far, and
/// at the column of the axis word if this line has an axis word.
class TravelCheck {
 public:
  /// Begins a check.
  /// @param homed axes that are homed, bit i for axis i
  /// @param start position before the program, machine coordinates
  explicit TravelCheck(const cnc::Settings& settings,
                       std::uint8_t homed = 0,
                       const Point& start = {});

  void put(const PathPiece& piece);
  /// Records a homing cycle of the program that homes the given axes and ends at the given
  /// positions.
  void home(std::uint8_t axes, const Point& at);
  /// Records a change of settings by the program, which may change the travel.
  void configure(const cnc::Settings& settings);

  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  /// Returns the faults.
  /// @param file name of the program's file
  /// @param text text of the program, from which the columns of faults are found
  [[nodiscard]] std::vector<Fault> faults(const std::string& file, std::string_view text) const;

 private:
  struct Overrun {
    int line = 0;  ///< Line at which the axis first goes too far; 0 for none.
    /// True if `value` is a position beyond an end of a homed axis; false if it is an extent that
    /// exceeds the travel.
    bool of_ends = false;
    double value = 0.0;  ///< Position or extent that goes too far.
    double least = 0.0;
    double most = 0.0;  ///< Upper end of the axis, or the travel.
  };
  struct Axis {
    double travel = 0.0;  ///< Travel in mm or degrees; 0 for an endless axis.
    double least = 0.0;   ///< Lower end of the axis, machine coordinates.
    double most = 0.0;
    /// Lowest position of the path since the axis was homed, or since the start of the program.
    double low = 0.0;
    double high = 0.0;
    bool homed = false;
    Overrun overrun{};
  };

  void check(std::size_t number, int line);
  [[nodiscard]] std::string text_of(std::size_t axis) const;

  cnc::AxisArray<Axis> axes_{};
  Bounds bounds_{};
};

/// Returns the axes that `$H` homes ($44…$49), bit i for axis i.
[[nodiscard]] std::uint8_t homed_by_cycle(const cnc::Settings& settings);
/// Returns the position of an axis after it was homed, in mm or degrees, machine coordinates.
[[nodiscard]] double homed_position(const cnc::Settings& settings, std::size_t axis);

}  // namespace sim
