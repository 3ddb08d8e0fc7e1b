#include "host-sim/cut/burnt_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "host-sim/cut/fill_area.hpp"
#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/engrave/upright_image.hpp"
#include "host-sim/knowledge/experiment.hpp"
#include "planner/base/contract.hpp"

namespace sim::cut {
namespace {

double share_of_full(double watts, const Beam& beam) {
  if (watts <= beam.full_power_w) return watts / beam.full_power_w;
  throw std::invalid_argument(
      fmt::format("{:g} W are more than the laser's {:g} W; choose less, or give the laser's power "
                  "with --full-power",
                  watts,
                  beam.full_power_w));
}

engrave::ToneCurve tone_of(const LayerPlan& layer, const Beam& beam) {
  const ImageSettings& image = layer.settings.image;
  const double min_w = image.min_power.watts.value_or(0.0);
  const engrave::ToneCurve tone{
      .shading = image.shading,
      .min_power = share_of_full(min_w, beam),
      .max_power = share_of_full(from_thousandths(layer.condition.cut.power_mw), beam),
      .gamma = image.gamma,
      .is_inverted = image.is_inverted};
  if (tone.min_power > tone.max_power) {
    throw std::invalid_argument("min-power exceeds power; choose a lower min-power");
  }
  return tone;
}

engrave::EngraveSettings rows_of(const LayerPlan& layer,
                                 const Beam& beam,
                                 const PictureForm& form,
                                 const OrderWish& machine) {
  const double feed_mm_min = from_thousandths(layer.condition.cut.speed_um_min);
  const ImageSettings& image = layer.settings.image;
  return {.feed_mm_min = feed_mm_min,
          .overscan_mm = layer.settings.fill.overscan_mm.value_or(
              overscan_for(feed_mm_min / 60.0, 0.0, machine.limits)),
          .reverse_shift_mm = image.reverse_shift_mm,
          .is_one_way = image.is_one_way,
          .is_plain = image.is_plain || form.is_plain,
          .follows_speed = beam.follows_speed,
          .full_power_s = beam.full_power_s,
          .decimals = static_cast<int>(form.decimals)};
}

/// Appends a stroke, unless it has no length.
void add(std::vector<Stroke>& strokes, const Place& from, const Place& to, Purpose purpose) {
  if (from != to) strokes.push_back({.from = from, .to = to, .purpose = purpose});
}

std::vector<Stroke> strokes_of(const std::vector<engrave::EngravedRow>& rows) {
  std::vector<Stroke> strokes;
  std::optional<Place> end;
  for (const engrave::EngravedRow& row : rows) {
    const Place start{row.start_mm, row.y_mm};
    const Place from{row.from_mm, row.y_mm};
    const Place to{row.to_mm, row.y_mm};
    if (end) add(strokes, *end, start, Purpose::kOverscan);
    add(strokes, start, from, Purpose::kOverscan);
    add(strokes, from, to, Purpose::kContour);
    end = Place{row.end_mm, row.y_mm};
    add(strokes, to, *end, Purpose::kOverscan);
  }
  return strokes;
}

/// Returns a picture as the settings of its layer burn it; null if the picture is white.
std::shared_ptr<const BurntPicture> burnt(const drawing::DrawnPicture& picture,
                                          const LayerPlan& layer,
                                          engrave::EngraveSettings settings,
                                          const engrave::ToneCurve& tone,
                                          const cnc::order::RapidLimits& limits) {
  const double interval_mm = layer.settings.fill.interval_mm;
  const double pixel_mm = layer.settings.image.pixel_mm.value_or(interval_mm);
  const engrave::UprightImage upright =
      engrave::upright(*picture.image, picture.to_mm, std::min(interval_mm, pixel_mm));
  BurntPicture result{.entity = picture.entity, .at_mm = upright.low_mm};
  result.raster = engrave::burn_raster(
      upright.image, upright.high_mm - upright.low_mm, interval_mm, pixel_mm, tone);
  settings.at_mm = upright.low_mm;
  auto rows = engrave_rows(result.raster, settings, limits);
  if (!rows) return nullptr;
  result.rows = *std::move(rows);
  return std::make_shared<const BurntPicture>(std::move(result));
}

}  // namespace

void keep_burnt_pictures(drawing::Drawing& drawn, const std::vector<LayerSettings>& layers) {
  std::erase_if(drawn.pictures, [&layers](const drawing::DrawnPicture& picture) {
    return layers[picture.entity.layer].side != Side::kImage;
  });
}

std::vector<Cut> picture_cuts(const drawing::Drawing& drawn,
                              const std::vector<LayerPlan>& layers,
                              const Beam& beam,
                              const PictureForm& form,
                              const OrderWish& machine,
                              std::vector<drawing::Fault>& warnings) {
  std::vector<Cut> cuts;
  for (const drawing::DrawnPicture& picture : drawn.pictures) {
    const LayerPlan& layer = layers[picture.entity.layer];
    CNC_ASSERT(layer.settings.side == Side::kImage);
    Cut cut{.contour = kNoContour, .layer = picture.entity.layer};
    try {
      cut.picture = burnt(picture,
                          layer,
                          rows_of(layer, beam, form, machine),
                          tone_of(layer, beam),
                          machine.limits);
    } catch (const std::invalid_argument& error) {
      const drawing::Layer& named = drawn.layers[picture.entity.layer];
      throw std::invalid_argument(
          fmt::format("layer \"{}\" {}: {}", named.name, named.colour, error.what()));
    }
    if (cut.picture) {
      cut.strokes = strokes_of(cut.picture->rows.rows);
      cuts.push_back(std::move(cut));
      continue;
    }
    warnings.push_back({drawing::FaultKind::kPicture,
                        picture.entity,
                        {},
                        "the picture is white, so nothing is burnt",
                        "burn its light areas with invert=on"});
  }
  const auto rank_of = [&layers](const Cut& cut) {
    return layers[cut.layer].settings.rank.value_or(0);
  };
  std::ranges::stable_sort(cuts, {}, rank_of);
  return cuts;
}

OrderWish order_behind(const OrderWish& wish, const std::vector<Cut>& pictures) {
  OrderWish behind = wish;
  if (!pictures.empty()) behind.from = pictures.back().end();
  return behind;
}

void put_first(std::vector<Cut> pictures, const Place& from, CutPlan& plan) {
  if (pictures.empty()) return;
  const RapidSum alone = rapids_of(plan);
  const std::size_t count = pictures.size();
  for (std::size_t i = 0; i < count; ++i) pictures[i].turn = i;
  for (Cut& cut : plan.cuts) {
    cut.turn += count;
    for (std::size_t& before : cut.after) before += count;
    pictures.push_back(std::move(cut));
  }
  plan.cuts = std::move(pictures);
  plan.order.wish.from = from;
  const RapidSum all = rapids_of(plan);
  OrderFigures& order = plan.order;
  for (RapidSum* sum :
       {&order.rapids, &order.straight, &order.listed, &order.file, &order.nearest}) {
    sum->length_mm += all.length_mm - alone.length_mm;
    sum->time_s += all.time_s - alone.time_s;
  }
}

std::vector<std::string> picture_lines(const CutPlan& plan) {
  std::vector<std::string> lines;
  for (const Cut& cut : plan.cuts) {
    if (!cut.picture || cut.pass > 1) continue;
    const engrave::BurnRaster& raster = cut.picture->raster;
    lines.push_back(
        fmt::format("picture {}: {} x {} pixels, {:.2f} x {:.2f} mm at X{:.3f} Y{:.3f}; {} rows, "
                    "{:.1f} mm burnt",
                    cut.picture->entity.name,
                    raster.columns,
                    raster.rows,
                    raster.pixel_mm * static_cast<double>(raster.columns),
                    raster.interval_mm * static_cast<double>(raster.rows),
                    cut.picture->at_mm.x(),
                    cut.picture->at_mm.y(),
                    cut.picture->rows.figures.rows,
                    cut.picture->rows.figures.burnt_mm));
  }
  return lines;
}

}  // namespace sim::cut
