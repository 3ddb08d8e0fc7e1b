#include "host-sim/cut/fill_paths.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/fill_area.hpp"
#include "host-sim/cut/fill_contours.hpp"

namespace sim::cut {
namespace {

using drawing::Fault;
using drawing::FaultKind;

/// Fills one area, or reports why it is not filled.
class AreaFiller {
 public:
  AreaFiller(const std::vector<std::vector<Stroke>>& outlines,
             const FillSettings& fill,
             const drawing::Entity& entity)
      : outlines_{outlines}, fill_{fill}, entity_{entity} {}

  FillPaths with_lines(double overscan_mm) {
    auto path = fill_path(outlines_, fill_, overscan_mm);
    if (!path) {
      fail(FaultKind::kTooMuch,
           fmt::format("requires more than {} lines to fill", kMaxFillStrokes),
           "give its layer a greater interval");
    } else if (path->empty()) {
      fail(FaultKind::kTooSmall,
           fmt::format(
               "is so narrow that no line of its fill crosses it; these lines are {:g} mm apart",
               fill_.interval_mm),
           "give its layer a smaller interval, or skip it");
    } else {
      filled_.paths.push_back(*std::move(path));
    }
    return std::move(filled_);
  }

  FillPaths with_contours() {
    try {
      take(contour_fill(outlines_, fill_.interval_mm));
    } catch (const NoOffset& failure) {
      filled_.faults.push_back(
          {FaultKind::kTooMuch, entity_, failure.place(), failure.reason(), failure.remedy()});
    } catch (const std::runtime_error& failure) {
      fail(FaultKind::kCrossing,
           fmt::format("is not filled along its outline: {}", failure.what()),
           "separate its contours there, or fill it with pattern=lines");
    }
    return std::move(filled_);
  }

 private:
  void take(ContourFill fill) {
    if (fill.too_much) {
      return fail(FaultKind::kTooMuch,
                  fmt::format("requires more than {} rows, or {} lines and arcs, to fill",
                              kMaxFillLevels,
                              kMaxRowStrokes),
                  "give its layer a greater interval");
    }
    if (fill.paths.empty()) {
      return fail(
          FaultKind::kTooSmall,
          fmt::format("is narrower than the interval of its fill, {:g} mm", fill_.interval_mm),
          "give its layer a smaller interval, or skip it");
    }
    filled_.paths = std::move(fill.paths);
    if (fill.thin.count == 0) return;
    filled_.warnings.push_back(
        {FaultKind::kTooSmall,
         entity_,
         fill.thin.place,
         fmt::format("has {} part{} narrower than the interval of its fill, {:g} mm, with {:.1f} "
                     "mm of length in all; the longest, {:.1f} mm, is here",
                     fill.thin.count,
                     fill.thin.count == 1 ? "" : "s",
                     fill_.interval_mm,
                     fill.thin.length_mm,
                     fill.thin.longest_mm),
         "they are not filled; a smaller interval fills them"});
  }

  void fail(FaultKind kind, std::string reason, std::string remedy) {
    filled_.faults.push_back(
        {kind, entity_, outlines_.front().front().from, std::move(reason), std::move(remedy)});
  }

  const std::vector<std::vector<Stroke>>& outlines_;
  const FillSettings& fill_;
  const drawing::Entity& entity_;
  FillPaths filled_;
};

}  // namespace

FillPaths fill_paths(const std::vector<std::vector<Stroke>>& outlines,
                     const FillSettings& fill,
                     double overscan_mm,
                     const drawing::Entity& entity) {
  AreaFiller filler{outlines, fill, entity};
  return fill.pattern == FillPattern::kLines ? filler.with_lines(overscan_mm)
                                             : filler.with_contours();
}

}  // namespace sim::cut
