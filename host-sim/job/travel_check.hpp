#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Grbl's number for a target beyond the travel.
inline constexpr int kTravelExceeded = 15;

/// Checks the path of a program against the travel of each axis ($130…$135; 0 is endless), whether
/// or not soft limits ($20) are on.
///
/// The ends of a homed axis are known: the path has to stay between them. Of any other axis only
/// the extent counts: a job that is no larger than the travel fits somewhere. Each axis has one
/// fault at most, at the line that first goes too far, with the column of the axis word where there
/// is one.
class TravelCheck {
 public:
  /// @param homed bit i for axis i
  /// @param start position before the program, machine coordinates
  explicit TravelCheck(const cnc::Settings& settings,
                       std::uint8_t homed = 0,
                       const Point& start = {});

  void put(const PathPiece& piece);
  /// The program homes these axes, which ends at these positions.
  void home(std::uint8_t axes, const Point& at);
  /// The program changes settings: the travel is another from here on.
  void configure(const cnc::Settings& settings);

  [[nodiscard]] const Bounds& bounds() const { return bounds_; }
  /// @param file its name @param text the program itself, for the columns
  [[nodiscard]] std::vector<Fault> faults(const std::string& file, std::string_view text) const;

 private:
  struct Overrun {
    int line = 0;          ///< 0 for none.
    bool of_ends = false;  ///< Of a homed axis; else of the extent.
    double value = 0.0;    ///< Position or extent.
    double least = 0.0;
    double most = 0.0;  ///< End or travel.
  };
  struct Axis {
    double travel = 0.0;  ///< mm or degrees; 0 for an endless one.
    double least = 0.0;   ///< Its ends, machine coordinates.
    double most = 0.0;
    double low = 0.0;  ///< Of the path since the axis was homed, or since the start.
    double high = 0.0;
    bool homed = false;
    Overrun overrun{};
  };

  void check(std::size_t number, int line);
  [[nodiscard]] std::string text_of(std::size_t axis) const;

  cnc::AxisArray<Axis> axes_{};
  Bounds bounds_{};
};

/// Axes that `$H` homes ($44…$49), bit i for axis i.
[[nodiscard]] std::uint8_t homed_by_cycle(const cnc::Settings& settings);
/// The position of an axis after it was homed, mm or degrees in machine coordinates.
[[nodiscard]] double homed_position(const cnc::Settings& settings, std::size_t axis);

}  // namespace sim
