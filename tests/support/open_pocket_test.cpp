#include "host-sim/pocket/open_pocket.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "host-sim/contour/contour_text.hpp"
#include "host-sim/pocket/areas.hpp"
#include "host-sim/pocket/strategy.hpp"
#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::PathPoint;
using cnc::pocket::Use;
using sim::pocket::MilledPocket;
using sim::pocket::StockBox;
using sim::pocket::StrategyOptions;

/// mm: the stock counts as a thousandth smaller, and contours are written in micrometres.
constexpr double kSkinMm = 2.0e-3;

StrategyOptions open_options(double radius_mm, const StockBox& stock) {
  StrategyOptions options;
  options.pocket.clearing = {
      .tool_radius = radius_mm, .corner_radius = 0.1 * radius_mm, .stepover = 2.0 * radius_mm};
  options.pocket.entry = {cnc::pocket::EntryKind::kHelix, 0.05, 0.9 * radius_mm};
  options.pocket.depth = options.pocket.depth_step = 0.1 * radius_mm;
  options.stock = stock;
  return options;
}

/// The paths of all areas that are open, or all that are not.
MilledPocket mill(const sim::Contour& pockets, const StrategyOptions& options, bool is_open) {
  const double radius_mm = options.pocket.clearing.tool_radius;
  const sim::Contour all = sim::pocket::with_surroundings(
      pockets, *options.stock, sim::pocket::margin_around(*options.stock, radius_mm));
  MilledPocket milled;
  sim::pocket::StrategyPlanner planner{options};
  for (const sim::Contour& area : sim::pocket::areas_of(all)) {
    if (sim::pocket::is_around(area.view(), *options.stock) != is_open) continue;
    milled.append(planner.mill(area.view(), radius_mm));
  }
  return milled;
}

/// How far a place is inside of a box; negative outside.
double depth_in(const StockBox& box, const WideVec2& place) {
  return std::min({place.x() - box.x0, box.x1 - place.x(), place.y() - box.y0, box.y1 - place.y()});
}

/// Looks for faults of the path of open pockets by samples.
class OpenCheck {
 public:
  OpenCheck(const sim::Contour& pockets, const MilledPocket& path, const StrategyOptions& options)
      : path_{path}, radius_{options.pocket.clearing.tool_radius}, stock_{*options.stock} {
    walls_.add(pockets.view());
    constexpr int kSamples = 96;
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      for (int k = 0; k < kSamples; ++k) {
        const WideVec2 wall = walls_.at(i, static_cast<double>(k) / kSamples);
        if (depth_in(stock_, wall) > 0.0) walls_in_stock_.push_back(wall);
      }
    }
    cnc::pocket::for_each_element(path.path(), [this](const auto& from, const auto& to) {
      if (from.use == Use::kPass && cnc::pocket::flat_length(from, to) > 0.0) {
        passes_.add_element(cnc::pocket::arc_of(from, to));
      }
    });
  }

  std::string run(Random& random) {
    cnc::pocket::for_each_element(
        path_.path(), [this](const auto& from, const auto& to) { check_element(from, to); });
    for (int i = 0; i < 300; ++i) check_stock(random);
    return complaint_;
  }
  [[nodiscard]] std::size_t places() const { return places_; }

 private:
  void complain(const std::string& text, const WideVec2& place) {
    if (!complaint_.empty()) return;
    complaint_ = text + " at " + std::to_string(place.x()) + " " + std::to_string(place.y());
  }

  /// Whether stock that must stay is at a place, and not only its skin.
  [[nodiscard]] bool must_stay(const WideVec2& place) const {
    return depth_in(stock_, place) > kSkinMm && !walls_.encloses(place) &&
           walls_.distance(place) > kSkinMm;
  }

  void check_element(const PathPoint<double>& from, const PathPoint<double>& to) {
    const bool is_down = from.use == Use::kLink && to.z < from.z;
    if (is_down)
      return each_of_rim(from.point(), [this](const WideVec2& rim) {
        if (depth_in(stock_, rim) > 1.0e-6) complain("a plunge into stock", rim);
      });
    if (cnc::pocket::flat_length(from, to) == 0.0) return;
    const cnc::contour::exact::PlainArc arc{cnc::pocket::arc_of(from, to)};
    for (const double share : {0.0, 0.31, 0.5, 0.83}) {
      each_of_rim(arc.at(share), [this](const WideVec2& rim) {
        if (must_stay(rim)) complain("gouges", rim);
      });
    }
  }

  template <typename Visit>
  void each_of_rim(const WideVec2& centre, Visit&& visit) const {
    constexpr int kAround = 32;
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.3) / kAround;
      visit(WideVec2{centre + radius_ * WideVec2{std::cos(angle), std::sin(angle)}});
    }
  }

  /// Whether a disc of the tool around some centre nearby holds the place and nothing that must
  /// stay.
  [[nodiscard]] bool is_reachable(const WideVec2& place) const {
    constexpr int kCentres = 24;
    for (int i = 0; i < kCentres; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kCentres;
      for (const double share : {0.0, 0.5, 0.9}) {
        const WideVec2 centre =
            place + share * radius_ * WideVec2{std::cos(angle), std::sin(angle)};
        if (is_free(centre)) return true;
      }
    }
    return false;
  }

  /// Whether a disc a little larger than the tool holds nothing that must stay.
  [[nodiscard]] bool is_free(const WideVec2& centre) const {
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

  void check_stock(Random& random) {
    const WideVec2 place{random.between(stock_.x0, stock_.x1),
                         random.between(stock_.y0, stock_.y1)};
    if (!walls_.encloses(place) || !is_reachable(place)) return;
    ++places_;
    const double away = passes_.empty() ? 1.0e9 : passes_.distance(place);
    if (away > radius_ + kSkinMm) {
      complain("leaves stock, " + std::to_string(away - radius_) + " mm from the tool", place);
    }
  }

  const MilledPocket& path_;
  double radius_;
  StockBox stock_;
  cnc::pocket::PlainContour walls_;
  std::vector<WideVec2> walls_in_stock_;  ///< Places of the walls, close together.
  cnc::pocket::PlainContour passes_;
  std::size_t places_ = 0;
  std::string complaint_;
};

constexpr StockBox kStock{0.0, 0.0, 100.0, 60.0};

std::string faults_of_open(const char* text, double radius_mm, std::size_t least_places) {
  const sim::Contour pockets = sim::contour_from_text(text, "test");
  const StrategyOptions options = open_options(radius_mm, kStock);
  const MilledPocket path = mill(pockets, options, true);
  EXPECT_TRUE(mill(pockets, options, false).points.empty());
  Random random{1};
  OpenCheck check{pockets, path, options};
  const std::string faults = check.run(random);
  EXPECT_GE(check.places(), least_places);
  return faults;
}

TEST(OpenPockets, AreMilledFromBesideTheStock) {
  // A slot that ends beyond the edge, one that ends on it, a corner, and one from side to side.
  EXPECT_EQ(faults_of_open("40 20\n60 20\n60 70\n40 70\nclosed\n", 3.0, 20), "");
  EXPECT_EQ(faults_of_open("40 20\n60 20\n60 60\n40 60\nclosed\n", 3.0, 20), "");
  EXPECT_EQ(faults_of_open("70 30\n100 30\n100 60\n70 60\nclosed\n", 3.0, 20), "");
  EXPECT_EQ(faults_of_open("-10 20\n110 20\n110 40\n-10 40\nclosed\n", 3.0, 50), "");
}

TEST(OpenPockets, KeepIslandsAndWhatIsClosed) {
  const sim::Contour pockets = sim::contour_from_text(
      "30 20\n70 20\n70 70\n30 70\nclosed\n50 35 -1\n56 35 -1\nclosed\n"
      "5 5\n25 5\n25 25\n5 25\nclosed\n",
      "test");
  const StrategyOptions options = open_options(3.0, kStock);
  const MilledPocket open = mill(pockets, options, true);
  const MilledPocket closed = mill(pockets, options, false);
  EXPECT_FALSE(closed.points.empty());
  for (const auto& point : closed.points) EXPECT_LT(point.x, 25.0);
  for (const auto& point : open.points) EXPECT_GT(point.x, 25.0);
  Random random{1};
  EXPECT_NE((OpenCheck{pockets, open, options}.run(random)), "");  // It leaves the closed pocket.
  MilledPocket all = open;
  all.append(closed);
  EXPECT_EQ((OpenCheck{pockets, all, options}.run(random)), "");
}

TEST(OpenPockets, LeaveAStockAloneThatTheyDoNotReach) {
  const sim::Contour pockets = sim::contour_from_text("5 5\n25 5\n25 25\n5 25\nclosed\n", "test");
  EXPECT_TRUE(mill(pockets, open_options(3.0, kStock), true).points.empty());
}

TEST(OpenPockets, OfRandomShapesAreCleared) {
  std::size_t places = 0;
  std::size_t refused = 0;
  for (const std::uint64_t seed : Trials{40}) {
    Random random{seed};
    cnc::pocket::PocketBench bench;
    const double radius = cnc::pocket::add_random_pocket(bench, random);
    const sim::Contour pockets = sim::copy_of(bench.pocket());
    // A stock that the pocket crosses on one side or on two.
    StockBox stock{1.0e9, 1.0e9, -1.0e9, -1.0e9};
    for (const auto& vertex : pockets.vertices) {
      stock.include({vertex.x, vertex.y, vertex.x, vertex.y});
    }
    const double width = stock.x1 - stock.x0;
    const double height = stock.y1 - stock.y0;
    stock = {stock.x0 + random.between(-0.4, 0.4) * width,
             stock.y0 + random.between(-0.4, 0.4) * height,
             stock.x1 + 0.1 * width,
             stock.y1 + 0.2 * height};
    StrategyOptions options = open_options(radius, stock);
    if (random.chance(0.3)) options.pocket.milling = cnc::pocket::Milling::kConventional;
    try {
      MilledPocket path = mill(pockets, options, true);
      try {
        path.append(mill(pockets, options, false));
      } catch (const sim::pocket::NoPocketPath&) {
        ++refused;  // A closed part that the tool does not fit into.
        continue;
      }
      OpenCheck check{pockets, path, options};
      EXPECT_EQ(check.run(random), "") << "KERFLINE_SEED=" << seed;
      places += check.places();
    } catch (const sim::pocket::NoPocketPath&) {
      ++refused;  // A part is too short for a ramp.
    }
  }
  std::printf("%zu places with stock, %zu refused\n", places, refused);
}

/// What may be milled is what is in a pocket or beside the stock.
TEST(OpenPockets, HaveAllThatIsBesideTheStockAroundThem) {
  for (const std::uint64_t seed : Trials{200}) {
    Random random{seed};
    cnc::pocket::PocketBench bench;
    const double radius = cnc::pocket::add_random_pocket(bench, random);
    const sim::Contour pockets = sim::copy_of(bench.pocket());
    const auto& vertex = pockets.vertices[random.below(pockets.vertices.size())];
    const StockBox stock{vertex.x + random.between(-5.0, 5.0) * radius,
                         vertex.y + random.between(-5.0, 5.0) * radius,
                         vertex.x + random.between(6.0, 40.0) * radius,
                         vertex.y + random.between(6.0, 40.0) * radius};
    const sim::Contour area = sim::pocket::with_surroundings(pockets, stock, 4.0 * radius);
    cnc::pocket::PlainContour inside;
    inside.add(area.view());
    cnc::pocket::PlainContour walls;
    walls.add(pockets.view());
    for (int i = 0; i < 100; ++i) {
      const WideVec2 place{random.between(stock.x0 - 5.0 * radius, stock.x1 + 5.0 * radius),
                           random.between(stock.y0 - 5.0 * radius, stock.y1 + 5.0 * radius)};
      const double depth = depth_in(stock, place);
      if (std::abs(depth) < kSkinMm || std::abs(depth + 4.0 * radius) < kSkinMm) continue;
      if (walls.distance(place) < kSkinMm) continue;
      const bool is_beside = depth < 0.0 && depth > -4.0 * radius;
      const bool is_in_pocket = depth > 0.0 && walls.encloses(place);
      EXPECT_EQ(inside.encloses(place), is_beside || is_in_pocket)
          << place.x() << " " << place.y() << " KERFLINE_SEED=" << seed;
    }
  }
}

}  // namespace
}  // namespace proof
