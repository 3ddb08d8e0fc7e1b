#include "host-sim/cut/part_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "host-sim/cut/part_finder.hpp"

namespace sim::cut {
namespace {

/// Returns a measure, rounded to hundredths of a millimetre or of a square millimetre. So copies of
/// a part have equal measures.
std::int64_t rounded(double measure) { return std::llround(100.0 * measure); }

/// Rounded measures of a contour, by which copies are recognised: whether it is a mark, its layer,
/// its area and its length.
using Likeness = std::array<std::int64_t, 4>;

/// One copy of a part, with the measures of its contours. All copies of the part have the same
/// measures.
struct Copy {
  PartRow row{.copies = 1};
  std::vector<Likeness> likeness{};
};

double lit_length_of(const Cut& cut) {
  double sum = 0.0;
  for (const Stroke& stroke : cut.strokes) {
    if (has_beam(stroke.purpose)) sum += length_of(stroke);
  }
  return sum;
}

/// Adds up the cuts of each part.
class TableMaker {
 public:
  TableMaker(const drawing::Drawing& drawn, const CutPlan& plan) : drawn_{drawn}, plan_{plan} {
    const PartFinder parts{drawn, plan};
    std::vector<bool> seen(drawn.contours.size(), false);
    for (const Cut& cut : plan.cuts) {
      const std::size_t part = parts.part_of(cut);
      part_of_cut_.push_back(part);
      Copy& copy = copies_[part];
      if (cut.strokes.front().purpose != Purpose::kLink) ++copy.row.pierces;
      copy.row.number = part_of_cut_.size();
      copy.row.cut_length_mm += lit_length_of(cut);
      if (cut.contour == kNoContour || seen[cut.contour]) continue;
      add_contour(cut, copy);
      seen[cut.contour] = true;
    }
  }

  void add_times(const Timeline& timeline) {
    double back_s = 0.0;
    for (const TimeStep& step : timeline.steps) {
      const double seconds = step.end_s - step.begin_s;
      if (step.cut < part_of_cut_.size()) {
        copies_[part_of_cut_[step.cut]].row.time_s += seconds;
      } else {
        back_s += seconds;
      }
    }
    const double sum = timeline.total_s() - back_s;
    for (auto& [part, copy] : copies_) {
      copy.row.time_s += sum > 0.0 ? back_s * copy.row.time_s / sum : 0.0;
    }
  }

  std::vector<PartRow> rows() {
    std::vector<PartRow> rows;
    std::map<std::vector<Likeness>, std::size_t> row_of;
    for (const std::size_t part : parts_as_finished()) {
      Copy& copy = copies_[part];
      const auto [known, is_new] = row_of.try_emplace(copy.likeness, rows.size());
      if (is_new) {
        rows.push_back(copy.row);
        rows.back().name = drawn_.contours[part].entity.name;
        continue;
      }
      add(rows[known->second], copy.row);
    }
    if (const auto rest = copies_.find(kNoPart); rest != copies_.end()) {
      rows.push_back(rest->second.row);
      rows.back().name = "on the sheet";
    }
    return rows;
  }

 private:
  void add_contour(const Cut& cut, Copy& copy) {
    const drawing::DrawnContour& contour = drawn_.contours[cut.contour];
    const bool is_mark = plan_.plan_of(cut).settings.side != Side::kWaste;
    copy.likeness.push_back({is_mark ? 1 : 0,
                             static_cast<std::int64_t>(cut.layer),
                             rounded(std::abs(contour.area_mm2)),
                             rounded(contour.length_mm)});
    if (is_mark) return;
    copy.row.area_mm2 += cut.is_hole ? -std::abs(contour.area_mm2) : std::abs(contour.area_mm2);
  }

  static void add(PartRow& row, const PartRow& more) {
    ++row.copies;
    row.pierces += more.pierces;
    row.cut_length_mm += more.cut_length_mm;
    row.area_mm2 += more.area_mm2;
    row.time_s += more.time_s;
  }

  /// Returns the parts in the order of their last cuts. Also sorts the measures of each part, so
  /// that they can be compared.
  [[nodiscard]] std::vector<std::size_t> parts_as_finished() {
    std::vector<std::size_t> parts;
    std::vector<bool> seen(drawn_.contours.size(), false);
    for (std::size_t i = part_of_cut_.size(); i-- > 0;) {
      const std::size_t part = part_of_cut_[i];
      if (part == kNoPart || seen[part]) continue;
      seen[part] = true;
      std::ranges::sort(copies_[part].likeness);
      parts.push_back(part);
    }
    std::ranges::reverse(parts);
    return parts;
  }

  const drawing::Drawing& drawn_;
  const CutPlan& plan_;
  std::vector<std::size_t> part_of_cut_;
  std::map<std::size_t, Copy> copies_;
};

}  // namespace

std::vector<PartRow> part_table(const drawing::Drawing& drawn,
                                const CutPlan& plan,
                                const Timeline& timeline,
                                const PriceList& prices) {
  TableMaker maker{drawn, plan};
  maker.add_times(timeline);
  std::vector<PartRow> rows = maker.rows();
  double area = 0.0;
  for (const PartRow& row : rows) area += std::max(row.area_mm2, 0.0);
  for (PartRow& row : rows) {
    const double share =
        area > 0.0 ? std::max(row.area_mm2, 0.0) / area : 1.0 / static_cast<double>(rows.size());
    row.cost = cost_of(prices, row.time_s, share);
  }
  return rows;
}

}  // namespace sim::cut
