#include "tests/support/open_pocket_judge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::PathPoint;
using cnc::pocket::Use;
using sim::pocket::MilledPocket;
using sim::pocket::StockBox;
using sim::pocket::StrategyOptions;

template <typename Visit>
void each_of_rim(const WideVec2& centre, double radius, Visit&& visit) {
  constexpr int kAround = 32;
  for (int i = 0; i < kAround; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.3) / kAround;
    visit(WideVec2{centre + radius * WideVec2{std::cos(angle), std::sin(angle)}});
  }
}

}  // namespace

double depth_in(const StockBox& box, const WideVec2& place) {
  return std::min({place.x() - box.x0, box.x1 - place.x(), place.y() - box.y0, box.y1 - place.y()});
}

OpenPocketJudge::OpenPocketJudge(const sim::Contour& pockets,
                                 const MilledPocket& path,
                                 const StrategyOptions& options)
    : path_{path},
      radius_{options.pocket.clearing.tool_radius},
      floor_z_{-options.pocket.depth},
      stock_{*options.stock},
      pockets_{pockets.view()} {
  walls_.add(pockets.view());
  constexpr int kSamples = 96;
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    for (int k = 0; k < kSamples; ++k) {
      const WideVec2 wall = walls_.at(i, static_cast<double>(k) / kSamples);
      if (depth_in(stock_, wall) > 0.0) walls_in_stock_.push_back(wall);
    }
  }
}

std::string OpenPocketJudge::run(Random& random) {
  cnc::pocket::for_each_element(path_.path(), [this](const auto& from, const auto& to) {
    check_element(from, to);
    take(from, to);
  });
  for (int i = 0; i < 300; ++i) check_stock(random);
  return complaint_;
}

void OpenPocketJudge::complain(const std::string& text, const WideVec2& place) {
  if (!complaint_.empty()) return;
  complaint_ = text + " at " + std::to_string(place.x()) + " " + std::to_string(place.y());
}

/// Returns whether a point is in stock that must stay, deeper than the skin.
bool OpenPocketJudge::must_stay(const WideVec2& place) const {
  if (depth_in(stock_, place) <= kOpenSkinMm) return false;
  constexpr double kClearlyMm = 0.01;
  // A quick check: the oracle below takes longer.
  if (pockets_->depth(place) > kClearlyMm) return false;
  return walls_.distance(place) > kOpenSkinMm && !walls_.encloses(place);
}

/// Returns whether a point never had stock (except a skin) or the tool has swept it.
bool OpenPocketJudge::is_cleared(const WideVec2& place) const {
  if (depth_in(stock_, place) <= kOpenSkinMm) return true;
  return !swept_.empty() && swept_.distance(place) <= radius_ + kOpenSkinMm;
}

void OpenPocketJudge::take(const PathPoint<double>& from, const PathPoint<double>& to) {
  if (from.z != floor_z_ || to.z != floor_z_) return;
  if (cnc::pocket::flat_length(from, to) > 0.0) swept_.add_element(cnc::pocket::arc_of(from, to));
}

void OpenPocketJudge::check_element(const PathPoint<double>& from, const PathPoint<double>& to) {
  const double length = cnc::pocket::flat_length(from, to);
  if (from.use == Use::kEntry && from.z - to.z > length) complain("a plunge", from.point());
  if (from.use == Use::kPass && from.z != to.z) complain("a pass that is not level", from.point());
  if (from.use == Use::kLink) check_link(from, to);
  if (length == 0.0) return;
  const cnc::contour::exact::PlainArc arc{cnc::pocket::arc_of(from, to)};
  const bool is_short = length < 0.5 * radius_;
  for (const double share : {0.5, 0.0, 0.31, 0.83}) {
    if (is_short && share != 0.5) break;
    each_of_rim(arc.at(share), radius_, [this](const WideVec2& rim) {
      if (must_stay(rim)) complain("gouges", rim);
    });
  }
}

/// Checks a link: it must lead over cleared floor, and may descend only where the tool meets no
/// stock.
void OpenPocketJudge::check_link(const PathPoint<double>& from, const PathPoint<double>& to) {
  const bool is_down = to.z < from.z;
  if (is_down && from.point() != to.point()) complain("a slanting link", from.point());
  const cnc::contour::exact::PlainArc arc{cnc::pocket::arc_of(from, to)};
  for (const double share : {0.5, 1.0}) {
    const WideVec2 place = is_down ? to.point() : arc.at(share);
    each_of_rim(place, radius_ - kOpenSkinMm, [&](const WideVec2& rim) {
      if (!is_cleared(rim)) complain(is_down ? "a plunge into stock" : "a link in stock", rim);
    });
  }
}

/// Returns whether the tool can stand at some centre nearby so that it covers the point and no
/// stock that must stay.
bool OpenPocketJudge::is_reachable(const WideVec2& place) const {
  constexpr int kCentres = 24;
  for (int i = 0; i < kCentres; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kCentres;
    for (const double share : {0.0, 0.5, 0.9}) {
      const WideVec2 way{std::cos(angle), std::sin(angle)};
      if (is_free(place + share * radius_ * way)) return true;
    }
  }
  return false;
}

/// Returns whether a disc slightly larger than the tool covers no stock that must stay.
bool OpenPocketJudge::is_free(const WideVec2& centre) const {
  const double reach = 1.01 * radius_;
  if (depth_in(stock_, centre) < -reach) return true;
  const auto is_near = [&](const WideVec2& wall) { return (wall - centre).norm() < reach; };
  if (std::ranges::any_of(walls_in_stock_, is_near)) return false;
  for (const double share : {0.35, 0.7, 1.0}) {
    for (int i = 0; i < 48; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 48;
      const WideVec2 rim = centre + share * reach * WideVec2{std::cos(angle), std::sin(angle)};
      if (depth_in(stock_, rim) > 0.0 && !walls_.encloses(rim)) return false;
    }
  }
  return depth_in(stock_, centre) < 0.0 || walls_.encloses(centre);
}

void OpenPocketJudge::check_stock(Random& random) {
  const WideVec2 place{random.between(stock_.x0, stock_.x1), random.between(stock_.y0, stock_.y1)};
  if (!walls_.encloses(place) || !is_reachable(place)) return;
  ++places_;
  const double away = swept_.empty() ? 1.0e9 : swept_.distance(place);
  if (away > radius_ + kOpenSkinMm) {
    complain("leaves stock, " + std::to_string(away - radius_) + " mm from the tool", place);
  }
}

}  // namespace proof
