#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/stock/carver.hpp"
#include "host-sim/stock/engagement.hpp"
#include "host-sim/stock/step_stretches.hpp"
#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// Stock that the motions of one line of the program removed.
struct LineCut {
  int line = 0;
  double min_mm3 = 0.0;  ///< The volume that these motions surely removed.
  double at_s = 0.0;     ///< End of the first stretch that removed stock…
  Pose at;               ///< …and the tool's position there.
};

struct LineCuts {
  static constexpr std::size_t kMaxListed = 100;
  std::vector<LineCut> lines;  ///< The first lines with cuts, in the order of driving.
  /// Number of all lines with cuts; a line that is driven a second time counts again.
  std::size_t count = 0;
  int last_line = 0;

  void add(const DrivenStretch& driven, double removed_mm3);
};

struct RemovedAt {
  double time_s = 0.0;
  VolumeBounds removed;
};

struct PeakEngagement {
  Engagement engagement;
  int line = 0;
  double at_s = 0.0;
  Pose at;
};

/// Results of carving a program.
struct CarvingFigures {
  VolumeBounds removed;
  /// Removed volume at equal intervals of time or slightly longer ones, at most kMaxTimes entries;
  /// the last entry is the end.
  static constexpr std::size_t kMaxTimes = 256;
  std::vector<RemovedAt> over_time;
  LineCuts rapids;   ///< Rapids that cut stock.
  LineCuts plunges;  ///< Feeds that cut stock and descend more steeply than 45 degrees.
  /// Peak engagement of a flat tool over all feeds that are not plunges: that with the greatest
  /// middle of its bounds.
  std::optional<PeakEngagement> engagement;
};

/// Carves a stock along a driven path and collects figures.
class Carving {
 public:
  /// @param stock must outlive this object
  /// @param trail_mm greatest distance of the program's line behind the tool; thinner skins are not
  /// reported as cut by a rapid or a plunge
  /// @pre fault_of(cutter) is empty
  Carving(Stock& stock, const Cutter& cutter, double trail_mm);

  /// Carves one stretch. Throws the exceptions of Carver::sweep().
  void take(const DrivenStretch& driven);
  /// Ends the carving: no further stretch comes, and the job ended at `time_s`.
  void end(double time_s);

  [[nodiscard]] const CarvingFigures& figures() const { return figures_; }

 private:
  void measure_engagement(const DrivenStretch& driven);
  void note_volume(double time_s);

  Stock& stock_;
  Cutter cutter_;
  double trail_mm_;
  Carver carver_;
  CarvingFigures figures_;
  double time_step_s_ = 0.01;
};

}  // namespace sim::stock
