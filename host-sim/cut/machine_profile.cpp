#include "host-sim/cut/machine_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "firmware/machine/settings.hpp"
#include "host-sim/cut/cut_name.hpp"
#include "host-sim/cut/json_fields.hpp"

namespace sim::cut {
namespace {

constexpr const char* kProfileMark = "kerfline_machine";
constexpr double kMaxBedMm = 1.0e5;
constexpr double kMaxRate = 1.0e6;          ///< Greatest rate, mm/min.
constexpr double kMaxAcceleration = 1.0e6;  ///< Greatest acceleration, mm/s².
constexpr double kMaxJerk = 1.0e9;          ///< Greatest jerk, mm/s³.
/// Distance beyond the bed at which a position still counts as within it, because of rounding.
constexpr double kBedSlackMm = 1.0e-3;

struct CornerName {
  const char* key;
  const char* text;
  OriginCorner corner;
};
constexpr std::array<CornerName, 5> kCorners{{
    {"front-left", "front left", OriginCorner::kFrontLeft},
    {"front-right", "front right", OriginCorner::kFrontRight},
    {"back-left", "back left", OriginCorner::kBackLeft},
    {"back-right", "back right", OriginCorner::kBackRight},
    {"centre", "centre", OriginCorner::kCentre},
}};

OriginCorner corner_of(const JsonFields& fields) {
  const std::string text = fields.text("origin").value_or("front-left");
  for (const CornerName& known : kCorners) {
    if (known.key == text) return known.corner;
  }
  fields.refuse("origin", "must be front-left, front-right, back-left, back-right or centre");
}

/// Adds the first value as the setting `number`, for X, and the second one as the next setting, for
/// Y.
void add_pair(std::vector<SettingChange>& settings,
              std::uint16_t number,
              const std::optional<std::pair<double, double>>& values,
              const std::string& place) {
  if (!values) return;
  settings.push_back({number, static_cast<float>(values->first), place});
  settings.push_back(
      {static_cast<std::uint16_t>(number + 1), static_cast<float>(values->second), place});
}

std::vector<SettingChange> settings_in(const JsonFields& fields, const std::string& file) {
  std::vector<SettingChange> settings;
  const auto place = [&file](const char* key) { return fmt::format("{}: /{}", file, key); };
  if (const auto scale = fields.number("s_max", 1.0, 1.0e6)) {
    settings.push_back(
        {cnc::setting::kMaxSpindleSpeed, static_cast<float>(*scale), place("s_max")});
  }
  add_pair(settings, 110, fields.pair("rate_mm_min", 1.0, kMaxRate), place("rate_mm_min"));
  add_pair(settings,
           120,
           fields.pair("acceleration_mm_s2", 1.0, kMaxAcceleration),
           place("acceleration_mm_s2"));
  add_pair(settings, 130, fields.pair("bed_mm", 1.0, kMaxBedMm), place("bed_mm"));
  add_pair(settings, 800, fields.pair("jerk_mm_s3", 0.0, kMaxJerk), place("jerk_mm_s3"));
  const std::vector<std::string> lines = fields.texts("settings");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    settings.push_back(parse_setting(lines[i], fmt::format("{}: /settings/{}", file, i)));
  }
  return settings;
}

/// Returns points of a stroke that include its outermost points in both directions along each axis.
std::vector<Place> outermost_of(const Stroke& stroke) {
  std::vector<Place> places{stroke.from, stroke.to};
  if (stroke.bulge == 0.0) return places;
  const double b = stroke.bulge;
  const Place chord = stroke.to - stroke.from;
  const Place centre =
      0.5 * (stroke.from + stroke.to) + (1.0 - b * b) / (4.0 * b) * Place{-chord.y(), chord.x()};
  const double radius = drawing::distance(centre, stroke.from);
  const double sweep = 4.0 * std::atan(b);
  const double begin = std::atan2(stroke.from.y() - centre.y(), stroke.from.x() - centre.x());
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  const double low = std::min(begin, begin + sweep);
  const double high = std::max(begin, begin + sweep);
  for (double k = std::ceil(low / kQuarter); k * kQuarter <= high; k += 1.0) {
    places.emplace_back(centre + radius * drawing::direction(k * kQuarter));
  }
  return places;
}

/// Returns points of a cut that include its outermost points. They are points of its strokes, and
/// of its strokes for a controller that computes compensated paths.
std::vector<Place> outermost_of(const Cut& cut) {
  std::vector<Place> places;
  for (const std::vector<Stroke>* strokes : {&cut.strokes, &cut.programmed}) {
    for (const Stroke& stroke : *strokes) {
      const std::vector<Place> own = outermost_of(stroke);
      places.insert(places.end(), own.begin(), own.end());
    }
  }
  return places;
}

/// One side of the bed, with the point of the job that is farthest beyond it.
struct BedSide {
  const char* name = "";
  std::size_t axis = 0;
  double way = 1.0;  ///< Sign of the direction along the axis in which this side of the bed is.
  double edge = 0.0;
  double beyond_mm = kBedSlackMm;
  Place place{0.0, 0.0};
  const Cut* cut = nullptr;

  void look(const Place& at, const Cut& of) {
    const double beyond = way * (at[static_cast<Eigen::Index>(axis)] - edge);
    if (beyond <= beyond_mm) return;
    beyond_mm = beyond;
    place = at;
    cut = &of;
  }
};

}  // namespace

BedBox MachineProfile::bed() const {
  const double x = bed_mm.x();
  const double y = bed_mm.y();
  switch (origin) {
    case OriginCorner::kFrontRight:
      return {{-x, 0.0}, {0.0, y}};
    case OriginCorner::kBackLeft:
      return {{0.0, -y}, {x, 0.0}};
    case OriginCorner::kBackRight:
      return {{-x, -y}, {0.0, 0.0}};
    case OriginCorner::kCentre:
      return {{-0.5 * x, -0.5 * y}, {0.5 * x, 0.5 * y}};
    case OriginCorner::kFrontLeft:
      break;
  }
  return {{0.0, 0.0}, {x, y}};
}

std::string MachineProfile::origin_text() const {
  for (const CornerName& known : kCorners) {
    if (known.corner == origin) return fmt::format("origin at the {} of the bed", known.text);
  }
  return {};
}

MachineProfile read_machine_profile(const std::string& text, const std::string& file) {
  const auto document = marked_json(text, file, kProfileMark, "machine profile");
  const JsonFields fields{document,
                          file,
                          "",
                          {kProfileMark,
                           "name",
                           "note",
                           "bed_mm",
                           "origin",
                           "full_power_w",
                           "s_max",
                           "beam_offset_mm",
                           "rate_mm_min",
                           "acceleration_mm_s2",
                           "jerk_mm_s3",
                           "settings"}};
  MachineProfile profile{.name = fields.text("name").value_or(file),
                         .note = fields.text("note").value_or("")};
  const auto bed = fields.pair("bed_mm", 1.0, kMaxBedMm);
  if (!bed) fields.refuse("bed_mm", "is missing; give width and depth, such as [300, 200]");
  profile.bed_mm = {bed->first, bed->second};
  profile.origin = corner_of(fields);
  profile.full_power_w = fields.number("full_power_w", 0.001, 1.0e5).value_or(0.0);
  if (const auto offset = fields.pair("beam_offset_mm", -kMaxBedMm, kMaxBedMm)) {
    profile.beam_offset_mm = {offset->first, offset->second};
  }
  profile.settings = settings_in(fields, file);
  return profile;
}

std::vector<drawing::Fault> off_the_bed(const CutPlan& plan,
                                        const drawing::Drawing& drawn,
                                        const MachineProfile& profile) {
  const BedBox bed = profile.bed();
  std::array<BedSide, 4> sides{{{"left", 0, -1.0, bed.low.x()},
                                {"right", 0, 1.0, bed.high.x()},
                                {"front", 1, -1.0, bed.low.y()},
                                {"back", 1, 1.0, bed.high.y()}}};
  for (const Cut& cut : plan.cuts) {
    for (const Place& place : outermost_of(cut)) {
      for (BedSide& side : sides) side.look(place, cut);
    }
  }
  std::vector<drawing::Fault> faults;
  for (const BedSide& side : sides) {
    if (side.cut == nullptr) continue;
    faults.push_back(
        {drawing::FaultKind::kTooMuch,
         entity_of(*side.cut, drawn),
         side.place,
         fmt::format("leaves the bed of {}, {:g} x {:g} mm, {}, by {:.3f} mm at its {}",
                     profile.name,
                     profile.bed_mm.x(),
                     profile.bed_mm.y(),
                     profile.origin_text(),
                     side.beyond_mm,
                     side.name),
         "put it elsewhere with --place or --move, or make it smaller with --scale"});
  }
  return faults;
}

}  // namespace sim::cut
