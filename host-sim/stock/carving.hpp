#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/stock/carver.hpp"
#include "host-sim/stock/engagement.hpp"
#include "host-sim/stock/step_stretches.hpp"
#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// Stock that motions of one line removed.
struct LineCut {
  int line = 0;
  double least_mm3 = 0.0;  ///< The volume that they surely removed.
  double at_s = 0.0;       ///< End of the first such stretch…
  Pose at;                 ///< …and its place.
};

struct LineCuts {
  static constexpr std::size_t kMostListed = 100;
  std::vector<LineCut> lines;  ///< The first of them, as they are driven.
  std::size_t count = 0;       ///< Of all; a line that comes back counts again.
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

/// The findings of carving a program.
struct CarvingFigures {
  VolumeBounds removed;
  /// At equal distances of time, or a little more, at most kMostTimes of them; the end is last.
  static constexpr std::size_t kMostTimes = 256;
  std::vector<RemovedAt> over_time;
  LineCuts rapids;   ///< Rapids in stock.
  LineCuts plunges;  ///< Feeds in stock, steeper than 45 degrees downwards.
  /// Of a flat tool, of all feeds that are not plunges; where the middle of its bounds is greatest.
  std::optional<PeakEngagement> engagement;
};

/// Carves a stock along a driven path and keeps figures.
class Carving {
 public:
  /// @param trail_mm how far behind the tool the program's line may be; thinner skins are not
  /// reported as cut by a rapid or a plunge. The stock must outlive this.
  /// @pre fault_of(cutter) is empty
  Carving(Stock& stock, const Cutter& cutter, double trail_mm);

  /// Throws as Carver::sweep() does.
  void take(const DrivenStretch& driven);
  /// No more stretches; the job ended at this time.
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
