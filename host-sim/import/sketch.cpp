#include "host-sim/import/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "host-sim/import/stroke_colour.hpp"
#include "host-sim/text/lettering.hpp"

namespace sim::drawing {
namespace {

// Length below which a shape counts as a point, mm: a tenth of the nanometre in which the
// controller computes.
constexpr double kNoLengthMm = 1.0e-7;
constexpr std::size_t kMaxLayers = 10'000;

bool within_reach(const Place& place) {
  return std::abs(place.x()) <= kFarthestMm && std::abs(place.y()) <= kFarthestMm;
}

/// Returns whether all points that define a shape are finite and within kFarthestMm.
bool within_reach(const Shape& shape) {
  if (!finite(shape)) return false;
  if (const auto* const curve = std::get_if<Nurbs>(&shape)) {
    return std::ranges::all_of(curve->points, [](const Place& p) { return within_reach(p); });
  }
  if (const auto* const curve = std::get_if<Bezier>(&shape)) {
    return std::ranges::all_of(curve->points, [](const Place& p) { return within_reach(p); });
  }
  if (const auto* const ellipse = std::get_if<Ellipse>(&shape)) {
    return within_reach(ellipse->centre) && within_reach(ellipse->major) &&
           within_reach(ellipse->minor);
  }
  if (const auto* const arc = std::get_if<Arc>(&shape)) {
    // Only an arc of more than half a turn may reach far beyond its ends, up to all sides of its
    // circle.
    const double radius = distance(arc->start, arc->centre);
    const Place far = arc->centre.cwiseAbs() + Place{radius, radius};
    if (std::abs(arc->sweep) > 0.5 * kFullTurn && !within_reach(far)) return false;
  }
  return within_reach(start_of(shape)) && within_reach(end_of(shape));
}

bool has_length(const Shape& shape) {
  if (const auto* const line = std::get_if<Line>(&shape)) {
    return distance(line->start, line->end) > kNoLengthMm;
  }
  return length_of_hull(shape) > kNoLengthMm;
}

}  // namespace

std::string first_words(std::string_view words) {
  constexpr std::size_t kMaxBytesOfWords = 40;
  std::string line;
  for (const char c : words) {
    const bool blank = c == ' ' || (c > 0 && c < ' ');
    if (blank && (line.empty() || line.back() == ' ')) continue;
    const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
    if (line.size() >= kMaxBytesOfWords && !continues) return line + "…";
    line += blank ? ' ' : c;
  }
  if (line.ends_with(' ')) line.pop_back();
  return line;
}

double length_of_hull(const Shape& shape) {
  const auto sum = [](const auto& points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
    return length;
  };
  if (const auto* const line = std::get_if<Line>(&shape)) return distance(line->start, line->end);
  if (const auto* const curve = std::get_if<Nurbs>(&shape)) return sum(curve->points);
  if (const auto* const curve = std::get_if<Bezier>(&shape)) return sum(curve->points);
  if (const auto* const arc = std::get_if<Arc>(&shape)) {
    return distance(arc->start, arc->centre) * std::abs(arc->sweep);
  }
  const auto& ellipse = std::get<Ellipse>(shape);
  return (ellipse.major.norm() + ellipse.minor.norm()) * std::abs(ellipse.to - ellipse.from);
}

text::Lettering& Sketch::lettering() {
  if (!lettering_) lettering_ = std::make_shared<text::Lettering>(text_ == TextMode::kStroke);
  return *lettering_;
}

std::size_t Sketch::layer(const Layer& layer) {
  const auto found = layer_index_.find(layer);
  if (found != layer_index_.end()) return found->second;
  if (layers_.size() >= kMaxLayers) return layers_.size() - 1;
  layer_index_.emplace(layer, layers_.size());
  layers_.push_back(layer);
  return layers_.size() - 1;
}

std::size_t Sketch::add_entity(Entity entity) {
  entities_.push_back(std::move(entity));
  return entities_.size() - 1;
}

bool Sketch::add(Chain chain) {
  if (full_ || chain.shapes.empty()) return !full_;
  const Entity& from = entities_[chain.entity];
  if (!std::ranges::all_of(chain.shapes, [](const Shape& s) { return within_reach(s); })) {
    report({FaultKind::kBadEntity,
            from,
            {},
            "one of its points is not a number, or is farther than 10 km from the origin",
            "correct the point, or the unit of the drawing"});
    return true;
  }
  const Place start = start_of(chain.shapes.front());
  std::erase_if(chain.shapes, [](const Shape& shape) { return !has_length(shape); });
  if (chain.shapes.empty()) {
    note({FaultKind::kIgnored, from, start, "it has no length", "it is left out"});
    return true;
  }
  shapes_ += chain.shapes.size();
  if (shapes_ > kMaxShapes) {
    full_ = true;
    report({FaultKind::kTooMuch,
            from,
            {},
            fmt::format("there are more than {} curves; this curve and all later ones are left out",
                        kMaxShapes),
            "simplify the drawing, or divide it into several files"});
    return false;
  }
  chain.shapes.shrink_to_fit();
  chains_.push_back(std::move(chain));
  return true;
}

void Sketch::add(DrawnPicture picture) {
  const Layer& layer = layers_[picture.entity.layer];
  const std::string_view name =
      layer.colour == kPictureColour || layer.name.empty() ? layer.colour : layer.name;
  note({FaultKind::kPicture,
        picture.entity,
        {},
        "pictures are left out",
        fmt::format("`cut --layer '{}: kind=image, power=20%, feed=3000'` burns them", name)});
  pictures_.push_back(std::move(picture));
}

void Sketch::report_bad_picture(const Entity& entity, std::string reason, std::string remedy) {
  note({FaultKind::kBadPicture, entity, {}, std::move(reason), std::move(remedy)});
}

std::shared_ptr<const picture::GreyImage> Sketch::decode(std::string_view bytes,
                                                         const Entity& entity) {
  try {
    auto image = std::make_shared<picture::GreyImage>(picture::read_image(bytes, "it"));
    picture_pixels_ += image->darkness.size();
    if (picture_pixels_ <= share_of(picture::kMaxImagePixels)) return image;
    report_bad_picture(
        entity, "together with the pictures before it, it has too many pixels", "make it smaller");
  } catch (const std::exception& error) {
    report_bad_picture(
        entity, fmt::format("it cannot be read: {}", error.what()), "embed it as PNG or JPEG");
  }
  return nullptr;
}

bool Sketch::is_of_strokes(const Fault& fault) const {
  const bool is_of_lines = fault.kind == FaultKind::kOpen || fault.kind == FaultKind::kBranch ||
                           fault.kind == FaultKind::kCrossing;
  return is_of_lines && is_of_strokes(fault.entity);
}

bool Sketch::is_of_strokes(const Entity& entity) const {
  return text_ == TextMode::kStroke && !entity.name.empty() && entity.layer < layers_.size() &&
         layers_[entity.layer].colour == kStrokeTextColour;
}

void Sketch::report(Fault fault) {
  if (is_of_strokes(fault)) return;
  if (fault.is_of_line && ++lines_ > kMaxLinesListed) return;
  if (faults_.size() < kMaxFaults) {
    faults_.push_back(std::move(fault));
  } else {
    ++more_faults_;
  }
}

void Sketch::refuse(std::size_t line, std::size_t column, std::string reason, std::string remedy) {
  Entity whole{.line = line, .column = column};
  report({FaultKind::kUnreadable, std::move(whole), {}, std::move(reason), std::move(remedy)});
}

void Sketch::note(const Fault& first, std::string detail) {
  // Letters and pictures have one note for each layer, because rules may skip the letters or
  // pictures of a single layer.
  const bool is_of_layer = first.kind == FaultKind::kText || first.kind == FaultKind::kPicture ||
                           first.kind == FaultKind::kBadPicture;
  const std::size_t layer = is_of_layer ? first.entity.layer : 0;
  const std::tuple key{first.kind, first.reason, layer};
  if (notes_.size() >= kMaxFaults && !notes_.contains(key)) return;
  Note& note = notes_[key];
  if (note.count++ == 0) note = {first, std::move(detail), 1};
}

void Sketch::leave_out_text(const Entity& entity, std::string_view words, std::string remedy) {
  note({FaultKind::kText, entity, {}, "letters are left out", std::move(remedy)},
       fmt::format(": \"{}\"", first_words(words)));
}

void Sketch::note(const std::string& what, const Entity& first, std::string remedy) {
  note({FaultKind::kNote, first, {}, what, std::move(remedy)});
}

void Sketch::scale(double factor) {
  const Transform larger = scaled_by(factor, factor);
  for (Chain& chain : chains_) {
    for (Shape& shape : chain.shapes) shape = transformed(shape, larger);
  }
  const auto enlarge = [&larger](Fault& fault) {
    if (fault.place_mm) fault.place_mm = larger(*fault.place_mm);
  };
  for (Fault& fault : faults_) enlarge(fault);
  for (auto& [key, note] : notes_) enlarge(note.first);
  for (DrawnPicture& picture : pictures_) picture.to_mm = larger * picture.to_mm;
}

void Sketch::forget_lines() {
  const auto forget = [](Entity& entity) { entity.line = entity.column = 0; };
  for (Entity& entity : entities_) forget(entity);
  for (Fault& fault : faults_) forget(fault.entity);
  for (DrawnPicture& picture : pictures_) forget(picture.entity);
  for (auto& [key, note] : notes_) forget(note.first.entity);
}

void Sketch::finish() {
  for (auto& [key, note] : notes_) {
    if (note.count > 1) note.detail += fmt::format(" ({} in all)", note.count);
    note.first.reason += note.detail;
    report(std::move(note.first));
  }
  notes_.clear();
}

}  // namespace sim::drawing
