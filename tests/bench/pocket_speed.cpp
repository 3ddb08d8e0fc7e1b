/// Prints how long the passes of a pocket take, and how the time grows, for three pockets: that of
/// paper 5, plates with a growing number of islands, and walls with a growing number of short
/// lines.
/// Run: build/release/tests/bench_pocket_speed

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <vector>

#include "planner/pocket/clearing.hpp"

namespace {

using cnc::contour::OffsetSizes;
using cnc::contour::OffsetSpace;
using Vertex = cnc::contour::Vertex<double>;

/// Returns `count` items of one type, which `owners` keeps until the run ends.
template <typename Item>
cnc::contour::Slice<Item> items(std::vector<std::shared_ptr<void>>& owners, std::size_t count) {
  auto owner = std::shared_ptr<Item[]>(new Item[count]{});
  owners.push_back(owner);
  return {owner.get(), count};
}

/// Storage of the passes for a given number of elements and loops.
class Storage {
 public:
  Storage(std::size_t elements, std::size_t loops) : elements_{elements}, loops_{loops} {}

  cnc::pocket::ClearingSpace<double> space() {
    return {offset_space(),
            loop_space(),
            loop_space(),
            loop_space(),
            area_space(1),
            area_space(1),
            items<cnc::pocket::LoopNote<double>>(owners_, loops_)};
  }
  cnc::pocket::PassList<double> passes(std::size_t levels) {
    const auto space = area_space(levels);
    return {space.list(), items<cnc::pocket::PassNote<double>>(owners_, space.ranges.size())};
  }

 private:
  OffsetSpace<double> offset_space() {
    const OffsetSizes sizes{elements_, 4 * elements_};
    return {items<Vertex>(owners_, elements_),
            items<cnc::contour::Curve<double>>(owners_, elements_),
            items<cnc::contour::FlatBox<double>>(owners_, sizes.element_boxes()),
            items<cnc::contour::RawCurve<double>>(owners_, sizes.raw()),
            items<cnc::contour::FlatBox<double>>(owners_, sizes.raw_boxes()),
            items<cnc::contour::Node<double>>(owners_, sizes.nodes()),
            items<cnc::contour::Cut<double>>(owners_, sizes.cuts),
            items<cnc::contour::Cut<double>>(owners_, sizes.cuts),
            items<std::uint32_t>(owners_, sizes.raw() + 1),
            items<cnc::contour::Piece>(owners_, sizes.pieces()),
            items<cnc::contour::Run>(owners_, sizes.pieces()),
            items<cnc::contour::Junction>(owners_, sizes.nodes()),
            items<std::uint32_t>(owners_, sizes.nodes())};
  }
  cnc::pocket::LoopSpace<double> loop_space() {
    return {items<Vertex>(owners_, elements_), items<std::uint32_t>(owners_, loops_)};
  }
  cnc::pocket::AreaSpace<double> area_space(std::size_t levels) {
    return {items<Vertex>(owners_, levels * elements_),
            items<std::uint32_t>(owners_, levels * loops_),
            items<cnc::pocket::AreaRange>(owners_, levels * loops_)};
  }

  std::size_t elements_;
  std::size_t loops_;
  std::vector<std::shared_ptr<void>> owners_;
};

struct Pocket {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> loop_ends;

  void close() { loop_ends.push_back(static_cast<std::uint32_t>(vertices.size())); }
};

Pocket paper_pocket() {
  Pocket pocket{{{10, 10}, {130, 10}, {130, 110, 0.0}, {90, 200}, {10, 110}}, {}};
  const double half_sweep = std::asin(0.5 * std::hypot(40.0, 90.0) / 100.0);
  pocket.vertices[2].bulge = -std::tan(0.5 * half_sweep);
  pocket.close();
  return pocket;
}

/// Returns a plate with round islands of 6 mm on a grid of 40 mm.
Pocket plate(std::size_t side) {
  const double size = 40.0 * static_cast<double>(side);
  Pocket pocket{{{0, 0}, {size, 0}, {size, size}, {0, size}}, {}};
  pocket.close();
  for (std::size_t i = 0; i < side * side; ++i) {
    const double x = 40.0 * (static_cast<double>(i % side) + 0.5);
    const double y = 40.0 * (static_cast<double>(i / side) + 0.5);
    pocket.vertices.push_back({x + 3.0, y, -1.0});
    pocket.vertices.push_back({x - 3.0, y, -1.0});
    pocket.close();
  }
  return pocket;
}

/// Returns a flower of short lines, about 200 mm wide.
Pocket flower(std::size_t elements) {
  Pocket pocket;
  for (std::size_t i = 0; i < elements; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(elements);
    const double radius = 80.0 + 20.0 * std::cos(7.0 * angle);
    pocket.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  pocket.close();
  return pocket;
}

void measure(const char* name, const Pocket& pocket, int repeats) {
  const std::size_t elements = 8 * pocket.vertices.size() + 256;
  const std::size_t loops = 2 * pocket.loop_ends.size() + 256;
  Storage storage{elements, loops};
  const auto space = storage.space();
  auto passes = storage.passes(32);
  double best_ms = 1.0e30;
  std::uint32_t count = 0;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const auto result = cnc::pocket::clear_pocket<double>(
        {{pocket.vertices.data(), pocket.vertices.size()},
         {pocket.loop_ends.data(), pocket.loop_ends.size()}},
        {.tool_radius = 5.0, .corner_radius = 0.5, .stepover = 10.0},
        space,
        passes);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    if (!result.ok()) {
      std::printf("%s: fault %d, offset %d\n",
                  name,
                  static_cast<int>(result.error().fault),
                  static_cast<int>(result.error().offset.fault));
      return;
    }
    best_ms = std::min(best_ms, took.count());
    count = result.value();
  }
  std::printf("%-10s %7zu elements %6zu loops %5u passes %10.3f ms\n",
              name,
              pocket.vertices.size(),
              pocket.loop_ends.size(),
              count,
              best_ms);
}

}  // namespace

int main() {
  measure("paper", paper_pocket(), 100);
  for (const std::size_t side : {4U, 8U, 16U, 32U}) measure("islands", plate(side), 1);
  for (const std::size_t elements : {1000U, 10'000U, 100'000U}) {
    measure("flower", flower(elements), 1);
  }
}
