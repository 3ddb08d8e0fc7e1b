#include "host-sim/cut/edge_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/planned_area.hpp"
#include "host-sim/cut/swept_area.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "host-sim/machine/machine_reading.hpp"
#include "host-sim/measure/course_heat.hpp"
#include "host-sim/measure/driven_path.hpp"
#include "host-sim/measure/energy_meter.hpp"
#include "planner/kerf/kerf_lookup.hpp"

namespace sim::cut {
namespace {

/// Distance between the points of drawn edges that are checked, mm.
constexpr double kEdgeEvery = 0.02;
/// Greatest deviation of the chords that replace drawn edges, mm. Drawn edges are the curves of the
/// drawing, not the arcs that replace these curves in the cut.
constexpr double kEdgeChord = 1.0e-5;
/// Distance within which the plan's beam touches an edge, mm. For a curve that is cut as arcs, the
/// tolerance of these arcs is added. For a line that two parts share, the line's own tolerance is
/// added.
constexpr double kTouches = 1.0e-3;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
/// Distance from the edge of the beam within which drawn edges count as cut under unknown
/// conditions, mm. It applies where no test cut covers the condition of the beam.
constexpr double kAroundUnknown = 0.1;
/// Distance from a pierce within which cuts do not count in the swept area, mm. The beam is wider
/// during a pierce and shortly afterwards.
constexpr double kAroundPierce = 0.1;

cnc::AxisArray<double> scales_of(const cnc::Settings& settings) {
  cnc::AxisArray<double> steps{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    steps[axis] = static_cast<double>(settings.get(cnc::setting::kStepsPerMm, axis));
  }
  return steps;
}

/// Returns the kerf at a heat input, from the laws of the rows around the thickness. The heat input
/// may be beyond all test cuts. Returns nothing if one of these rows has a measured kerf instead of
/// a law.
std::optional<double> kerf_of_heat(const cnc::kerf::TableView<double>& table,
                                   std::uint32_t thickness_um,
                                   double heat) {
  using cnc::kerf::Row;
  const auto around =
      cnc::kerf::detail::neighbours(table.rows, &Row<double>::thickness_um, thickness_um);
  const Row<double>& low = table.rows[around.low];
  const Row<double>& high = table.rows[around.high];
  if (low.measured || high.measured) return std::nullopt;
  return cnc::kerf::detail::between(
      low.law.slope * heat + low.law.intercept,
      high.law.slope * heat + high.law.intercept,
      cnc::kerf::detail::share<double>(low.thickness_um, high.thickness_um, thickness_um));
}

void note(EdgePeak& peak, double mm, const Place& place) {
  if (std::abs(mm) > std::abs(peak.mm)) peak = {mm, place};
}

}  // namespace

class EdgeCheck::Sweep final : public TraceSink {
 public:
  Sweep(const CutJob& job, const std::string& program, Simulator& simulator)
      : job_{job},
        table_{table_of<double>(job.record)},
        scale_{scales_of(simulator.settings())},
        path_{driven_path(read_for_machine(program, simulator.settings()),
                          cnc::limits_from(simulator.settings()))},
        deviation_{path_, scale_, kNoLimit},
        energy_{path_, deviation_, scale_, options_of(job, simulator)},
        heat_{scale_, [this](const std::array<double, 2>& place, double seconds_per_mm) {
                joules_per_mm_ = seconds_per_mm * job_.beam.full_power_w;
                sweep({place[0], place[1]});
              }} {
    lay_out_plan();
    // With kerf control, the motors leave the planned path, along which `energy_` measures. So
    // `heat_` measures instead.
    if (simulator.settings().get(cnc::setting::kKerfControl) != 0.0F) {
      simulator.add_sink(heat_);
      return;
    }
    simulator.add_sink(deviation_);
    simulator.add_sink(energy_);
    simulator.add_sink(*this);
  }

  void on_row(const TraceRow& row) override {
    // The beam may have been on until now, so the path up to here was cut.
    const bool lit = row.duty > 0.0F || duty_ > 0.0F;
    duty_ = row.duty;
    if (!lit) return;
    sweep({row.position[0] / scale_[0], row.position[1] / scale_[1]});
  }

  [[nodiscard]] EdgeFigures figures() const;

 private:
  static constexpr double kNear = 2.0;  ///< Greatest distance at which searches find strokes, mm.

  struct Sum {
    EdgeFigures figures{};
    double sizes_mm = 0.0;
    double since_mm = 0.0;  ///< Distance from the last point of the profile.
  };

  /// Adds a disc around the beam to the swept area, with the kerf of the present heat input.
  void sweep(const Place& here) {
    if (pierces_.nearest(here).distance_mm < kAroundPierce) return;
    nearest_ = strokes_.nearest(here, nearest_);
    const LayerPlan& layer = job_.plan.plan_of(job_.plan.cuts[nearest_.owner]);
    if (is_engraved(layer.settings.side)) {
      // The beam does not cut through the sheet here. The next cut starts with an unknown heat
      // input.
      joules_per_mm_ = 0.0;
      return;
    }
    const double radius = 0.5 * kerf_at(layer);
    swept_.add(here, radius);
    // `unknown_` contains all edges around the beam, also edges that this beam was too narrow to
    // reach.
    if (!is_known(layer)) unknown_.add(here, radius + kAroundUnknown);
    const double ratio = ratio_of(layer);
    note_heat(ratio);
    if (ratio > corner_ratio_ && corners_.nearest(here).distance_mm < layer.condition.kerf_mm) {
      corner_ratio_ = ratio;
    }
  }

  void look(const drawing::Shape& edge, double touches_mm, Sum& sum) const;
  void look(const Place& place, double stretch_mm, double touches_mm, Sum& sum) const;
  /// Adds a point to the profile if it is far enough from the last point, or if it begins an edge.
  static void add_to_profile(const EdgePlace& edge, double stretch_mm, Sum& sum);

  EnergyMeter::Options options_of(const CutJob& job, Simulator& simulator) {
    return {.max_speed = simulator.settings().get(cnc::setting::kMaxSpindleSpeed),
            .min_speed = simulator.settings().get(cnc::setting::kMinSpindleSpeed),
            .on_window = [this, &job](double seconds_per_mm) {
              joules_per_mm_ = seconds_per_mm * job.beam.full_power_w;
            }};
  }

  static double joules_per_mm(const LayerPlan& layer) {
    const cnc::kerf::Condition& cut = layer.condition.cut;
    return cnc::kerf::heat_input<double>(
        cnc::kerf::HeatUnit::kJoulesPerMillimetre, cut.power_mw, cut.speed_um_min);
  }
  [[nodiscard]] double ratio_of(const LayerPlan& layer) const {
    return joules_per_mm_ > 0.0 ? joules_per_mm_ / joules_per_mm(layer) : 1.0;
  }
  [[nodiscard]] double kerf_at(const LayerPlan& layer) const {
    const cnc::kerf::Condition& cut = layer.condition.cut;
    const double heat = ratio_of(layer) *
                        cnc::kerf::heat_input<double>(table_.unit, cut.power_mw, cut.speed_um_min);
    return kerf_of_heat(table_.view(), cut.thickness_um, heat).value_or(layer.condition.kerf_mm);
  }
  /// Returns whether test cuts cover the planned power at the speed that would give the present
  /// heat input.
  [[nodiscard]] bool is_known(const LayerPlan& layer) const {
    const cnc::kerf::Condition& cut = layer.condition.cut;
    const auto speeds =
        cnc::kerf::permissible_speeds(table_.view(), cut.thickness_um, cut.power_mw);
    const double speed = cut.speed_um_min / ratio_of(layer);
    // Tolerance of the measurement of heat input, as a share.
    constexpr double kMeasured = 0.01;
    return speeds.ok() && speed >= (1.0 - kMeasured) * speeds.value().least &&
           speed <= (1.0 + kMeasured) * speeds.value().most;
  }
  void note_heat(double ratio) {
    min_ratio_ = std::min(min_ratio_, ratio);
    greatest_ratio_ = std::max(greatest_ratio_, ratio);
  }

  /// Records the strokes, corners and pierces of the plan, and the area that the planned beam
  /// covers.
  void lay_out_plan() {
    for (std::size_t index = 0; index < job_.plan.cuts.size(); ++index) {
      const Cut& cut = job_.plan.cuts[index];
      const double radius = 0.5 * job_.plan.plan_of(cut).condition.kerf_mm;
      for (const Place& corner : cut.corners) corners_.add({corner, corner}, index);
      for (const Stroke& stroke : cut.strokes) {
        strokes_.add(stroke, index);
        if (stroke.purpose == Purpose::kPierce) pierces_.add(stroke, index);
        if (has_beam(stroke.purpose) && !cut.picture) planned_.add(stroke, radius);
      }
    }
    for (const Cut& cut : job_.plan.cuts) {
      for (const Stroke& stroke : cut.programmed) {
        if (stroke.purpose == Purpose::kPierce) pierces_.add(stroke, cut.contour);
      }
    }
    strokes_.prepare();
    corners_.prepare();
    pierces_.prepare();
    planned_.prepare();
  }

  const CutJob& job_;
  OwnedKerfTable<double> table_;
  cnc::AxisArray<double> scale_;
  ProgrammedPath path_;
  PathDeviation deviation_;
  double joules_per_mm_ = 0.0;  ///< Heat input of the window that ends here, J/mm.
  EnergyMeter energy_;
  CourseHeat heat_;
  Clearance strokes_{kNear};
  Clearance::Nearest nearest_{};  ///< The stroke nearest to the previous point.
  Clearance pierces_{kNear};
  Clearance corners_{kNear};
  PlannedArea planned_;
  SweptArea swept_;
  SweptArea unknown_;
  float duty_ = 0.0F;
  double min_ratio_ = 1.0;
  double greatest_ratio_ = 1.0;
  double corner_ratio_ = 0.0;
};

void EdgeCheck::Sweep::add_to_profile(const EdgePlace& edge, double stretch_mm, Sum& sum) {
  constexpr double kEvery = 0.1;
  std::vector<EdgePlace>& row = sum.figures.profile;
  sum.since_mm += stretch_mm;
  EdgePlace next = edge;
  next.joins = !row.empty() && drawing::distance(row.back().place, edge.place) < 2.0 * kEvery;
  if (next.joins && sum.since_mm < kEvery) return;
  sum.since_mm = 0.0;
  row.push_back(next);
}

/// Compares the actual cut with the planned cut at a point that represents a stretch of a drawn
/// edge. Adds the result to `sum`.
void EdgeCheck::Sweep::look(const Place& place,
                            double stretch_mm,
                            double touches_mm,
                            Sum& sum) const {
  const double planned = planned_.depth_of(place);
  const double cut = swept_.depth_of(place);
  note(sum.figures.max_off_model, cut - planned, place);
  if (unknown_.depth_of(place) > -kTouches) {
    sum.figures.unknown_mm += stretch_mm;
  } else {
    note(sum.figures.max_off_known, cut - planned, place);
  }
  const bool reached = planned >= -touches_mm;
  add_to_profile({.place = place, .mm = cut, .reached = reached, .joins = true}, stretch_mm, sum);
  if (!reached) {
    sum.figures.untouched_mm += stretch_mm;
    return;
  }
  ++sum.figures.places;
  sum.sizes_mm += std::abs(cut);
  note(cut > 0.0 ? sum.figures.max_off : sum.figures.max_left, cut, place);
}

void EdgeCheck::Sweep::look(const drawing::Shape& edge, double touches_mm, Sum& sum) const {
  const double touches = touches_mm + (is_free_form(edge) ? job_.plan.curves.tolerance_mm : 0.0);
  const std::vector<Place> places = drawing::outline_of({&edge, 1}, kEdgeChord);
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Stroke chord{places[i - 1], places[i]};
    const int count = 1 + static_cast<int>(length_of(chord) / kEdgeEvery);
    for (int k = 0; k < count; ++k) {
      const Place place = place_at(chord, static_cast<double>(k) / count);
      look(place, length_of(chord) / count, touches, sum);
    }
  }
}

EdgeFigures EdgeCheck::Sweep::figures() const {
  Sum sum{{.min_heat_ratio = min_ratio_,
           .greatest_heat_ratio = greatest_ratio_,
           .greatest_corner_ratio = corner_ratio_}};
  for (std::size_t i = 0; i < job_.drawn.contours.size(); ++i) {
    const drawing::DrawnContour& contour = job_.drawn.contours[i];
    const LayerPlan& layer = job_.plan.layers[contour.entity.layer];
    const LayerSettings& settings = job_.plan.recipes.of(i, layer).settings;
    if (settings.side != Side::kWaste) continue;
    const double touches = kTouches + settings.common_line_mm;
    for (const drawing::Shape& edge : contour.shapes) look(edge, touches, sum);
  }
  if (sum.figures.places != 0) {
    sum.figures.mean_mm = sum.sizes_mm / static_cast<double>(sum.figures.places);
  }
  return sum.figures;
}

EdgeCheck::EdgeCheck(const CutJob& job, const std::string& program, Simulator& simulator)
    : sweep_{std::make_unique<Sweep>(job, program, simulator)} {}

EdgeCheck::~EdgeCheck() = default;

EdgeFigures EdgeCheck::figures() const { return sweep_->figures(); }

}  // namespace sim::cut
