#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/stock/carver.hpp"
#include "host-sim/stock/engagement.hpp"
#include "host-sim/stock/step_stretches.hpp"
#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// Volume of stock that the motions of one program line removed.
struct LineCut {
  int line = 0;
  double min_mm3 = 0.0;  ///< Lower bound of the removed volume.
  double at_s = 0.0;     ///< Time at the end of the first stretch that removed stock.
  Pose at;               ///< Position of the tool at that time.
};

struct LineCuts {
  static constexpr std::size_t kMaxListed = 100;
  /// The first kMaxListed lines that removed stock, in the order of driving.
  std::vector<LineCut> lines;
  /// Number of all lines that removed stock. A line that is driven several times counts several
  /// times.
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
  /// Removed volume over time, at intervals of at least a fixed length. It has at most kMaxTimes
  /// entries; the last entry is at the end of the job.
  static constexpr std::size_t kMaxTimes = 256;
  std::vector<RemovedAt> over_time;
  LineCuts rapids;  ///< Program lines whose rapids cut stock.
  /// Program lines whose feeds cut stock and descend more steeply than 45 degrees.
  LineCuts plunges;
  /// Greatest engagement of a flat tool over all feeds that are not plunges. Engagements are
  /// compared by the mean of their bounds.
  std::optional<PeakEngagement> engagement;
};

/// Carves a stock along a driven path and measures the cuts.
class Carving {
 public:
  /// @param stock must outlive this object
  /// @param trail_mm greatest distance by which the program line that is assigned to the tool's
  /// position lags behind the tool. Material up to this thickness is not reported as cut by a rapid
  /// or a plunge
  /// @pre fault_of(cutter) is empty
  Carving(Stock& stock, const Cutter& cutter, double trail_mm);

  /// Carves one stretch. Throws the exceptions of Carver::sweep().
  void take(const DrivenStretch& driven);
  /// Completes the figures. The job ended at `time_s`; no stretch may follow.
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
