#include "host-sim/import/sketch.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace sim::drawing {
namespace {

// Shorter ones are a place and no way: a tenth of the controller's nanometre.
constexpr double kNoLengthMm = 1.0e-7;
constexpr std::size_t kMostLayers = 10'000;

bool within_reach(const Place& place) {
  return std::abs(place.x()) <= kFarthestMm && std::abs(place.y()) <= kFarthestMm;
}

/// Whether every place that decides a shape is a number and not absurdly far.
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
    // Up to half a turn an arc is no farther from its ends than they are from each other; more of
    // one goes all round its centre.
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

std::size_t Sketch::layer(const Layer& layer) {
  const auto found = layer_index_.find(layer);
  if (found != layer_index_.end()) return found->second;
  if (layers_.size() >= kMostLayers) return layers_.size() - 1;
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
            "a place that is no number, or farther than 10 km from the origin",
            "mend it in the drawing, or its units"});
    return true;
  }
  const Place start = start_of(chain.shapes.front());
  std::erase_if(chain.shapes, [](const Shape& shape) { return !has_length(shape); });
  if (chain.shapes.empty()) {
    report({FaultKind::kTooSmall, from, start, "it has no length", "delete it"});
    return true;
  }
  shapes_ += chain.shapes.size();
  if (shapes_ > kMostShapes) {
    full_ = true;
    report({FaultKind::kTooMuch,
            from,
            {},
            fmt::format("more than {} curves; this and what follows is left out", kMostShapes),
            "simplify the drawing, or cut it in parts"});
    return false;
  }
  chains_.push_back(std::move(chain));
  return true;
}

void Sketch::report(Fault fault) {
  if (faults_.size() < kMostFaults) {
    faults_.push_back(std::move(fault));
  } else {
    ++more_faults_;
  }
}

void Sketch::refuse(std::size_t line, std::size_t column, std::string reason, std::string remedy) {
  Entity whole{.line = line, .column = column};
  report({FaultKind::kUnreadable, std::move(whole), {}, std::move(reason), std::move(remedy)});
}

void Sketch::ignore(const std::string& what, const Entity& first, std::string remedy) {
  gather(FaultKind::kIgnored, what, first, std::move(remedy));
}

void Sketch::note(const std::string& what, const Entity& first, std::string remedy) {
  gather(FaultKind::kNote, what, first, std::move(remedy));
}

void Sketch::gather(FaultKind kind,
                    const std::string& what,
                    const Entity& first,
                    std::string remedy) {
  if (ignored_.size() >= kMostFaults && !ignored_.contains(what)) return;
  Ignored& ignored = ignored_[what];
  if (ignored.count++ == 0) {
    ignored.kind = kind;
    ignored.first = first;
    ignored.remedy = std::move(remedy);
  }
}

void Sketch::scale(double factor) {
  const Transform larger = scaled_by(factor, factor);
  for (Chain& chain : chains_) {
    for (Shape& shape : chain.shapes) shape = transformed(shape, larger);
  }
  for (Fault& fault : faults_) {
    if (fault.place_mm) fault.place_mm = larger(*fault.place_mm);
  }
}

void Sketch::forget_lines() {
  const auto forget = [](Entity& entity) { entity.line = entity.column = 0; };
  for (Entity& entity : entities_) forget(entity);
  for (Fault& fault : faults_) forget(fault.entity);
  for (auto& [what, ignored] : ignored_) forget(ignored.first);
}

void Sketch::finish() {
  for (auto& [what, ignored] : ignored_) {
    const std::string more =
        ignored.count > 1 ? fmt::format(" ({} in all)", ignored.count) : std::string{};
    report({ignored.kind, ignored.first, {}, what + more, ignored.remedy});
  }
  ignored_.clear();
}

}  // namespace sim::drawing
