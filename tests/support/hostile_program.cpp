#include "tests/support/hostile_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>

#include "firmware/machine/settings.hpp"

namespace proof {
namespace {

constexpr std::string_view kAxes = "XYZ";
constexpr std::string_view kOffsets = "IJK";
constexpr double kFarthestMm = 5.0e5;

using Settings = std::vector<std::pair<int, double>>;

void any_scales(Random& random, Settings& settings) {
  for (int axis = 0; axis < 3; ++axis) {
    settings.emplace_back(100 + axis, random.magnitude(0.01, 1.0e5));
    settings.emplace_back(110 + axis, random.magnitude(10.0, 1.0e6));
    settings.emplace_back(120 + axis, random.magnitude(1.0, 1.0e6));
  }
  settings.emplace_back(11, random.magnitude(1.0e-5, 1.0));
  settings.emplace_back(12, random.magnitude(1.0e-3, 1.0));
}

/// Appends settings of the table with random values. Excludes homing, which would lock the machine.
void any_settings(Random& random, Settings& settings) {
  const auto table = cnc::setting_table();
  for (std::size_t count = random.below(6); count > 0; --count) {
    const cnc::SettingInfo info = table[random.below(table.size())];
    if (info.number == cnc::setting::kHoming) continue;
    const double least = std::max(1.0e-3, double{info.least});
    const bool at_end = random.chance(0.3) || least >= double{info.most};
    double value = at_end ? double{random.chance(0.5) ? info.least : info.most}
                          : random.magnitude(least, double{info.most});
    if (info.is_whole()) value = std::floor(value);
    settings.emplace_back(info.number, value);
  }
}

/// Writes random lines of G-code and tracks the position to which they lead.
class HostileAuthor {
 public:
  explicit HostileAuthor(Random& random)
      : random_{random},
        size_mm_{random.magnitude(1.0e-3, 0.4 * kFarthestMm)},
        incremental_{random.chance(0.5)} {
    lines = {"G21", incremental_ ? "G91" : "G90", fmt::format("F{:.3f}", feed()), "M3 S400"};
  }

  void write_line() {
    const double kind = random_.unit();
    if (kind < 0.35) {
      straight();
    } else if (kind < 0.75) {
      arc();
    } else if (kind < 0.85) {
      spline();
    } else if (kind < 0.92) {
      compensation();
    } else {
      word();
    }
  }

  std::vector<std::string> lines;

 private:
  double feed() { return random_.magnitude(10.0, 1.0e6); }
  double way() { return random_.signed_magnitude(size_mm_ * 1.0e-6, size_mm_); }
  double rounded(double mm) {
    constexpr std::array kGrids = {1.0e3, 1.0e4, 1.0e6};
    const double grid = kGrids[random_.below(kGrids.size())];
    return std::round(mm * grid) / grid;
  }

  /// Returns the word that moves an axis on by `mm`.
  std::string move(std::size_t axis, double mm) {
    place_[axis] += mm;
    return fmt::format(" {}{:.6f}", kAxes[axis], incremental_ ? mm : place_[axis]);
  }

  void straight() {
    std::string line = random_.chance(0.2) ? "G0" : "G1";
    for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
      if (random_.chance(0.6)) line += move(axis, rounded(way()));
    }
    if (random_.chance(0.2)) line += fmt::format(" F{:.3f}", feed());
    lines.push_back(line);
  }

  double turn() {
    if (random_.chance(0.3)) return random_.signed_magnitude(1.0e-9, 1.0);
    if (random_.chance(0.2)) return std::numbers::pi * (1.0 + random_.between(-1.0e-7, 1.0e-7));
    return random_.chance(0.1) ? 0.0 : random_.between(-6.28, 6.28);
  }

  void arc() {
    constexpr std::array<std::array<std::size_t, 2>, 3> kPlanes = {{{0, 1}, {2, 0}, {1, 2}}};
    if (random_.chance(0.2)) {
      plane_ = random_.below(kPlanes.size());
      lines.push_back(fmt::format("G{}", 17 + plane_));
    }
    const auto [first, second] = kPlanes[plane_];
    const double radius = random_.magnitude(std::max(1.0e-4 * size_mm_, 1.0e-4),
                                            random_.chance(0.5) ? size_mm_ : 2.0 * kFarthestMm);
    const double angle = random_.between(-4.0, 4.0);
    const double to = angle + turn();
    const double along = rounded(radius * (std::cos(to) - std::cos(angle)));
    const double aside = rounded(radius * (std::sin(to) - std::sin(angle)));
    std::string line = random_.chance(0.5) ? "G2" : "G3";
    line += move(first, along) + move(second, aside);
    if (random_.chance(0.2)) line += move(3 - first - second, way());
    if (random_.chance(0.25)) {
      const bool is_half = random_.chance(0.3);
      const double size = is_half ? 0.5 * std::hypot(along, aside) * 1.0000001 : radius;
      line += fmt::format(" R{:.6f}", random_.chance(0.5) ? size : -size);
    } else {
      line += fmt::format(" {}{:.6f} {}{:.6f}",
                          kOffsets[first],
                          -radius * std::cos(angle),
                          kOffsets[second],
                          -radius * std::sin(angle));
    }
    if (random_.chance(0.1)) line += fmt::format(" P{}", 1 + random_.below(4));
    lines.push_back(line);
  }

  void spline() {
    if (plane_ != 0) lines.emplace_back("G17");
    plane_ = 0;
    if (random_.chance(0.25)) return nurbs();
    const bool is_cubic = random_.chance(0.6);
    std::string line = is_cubic ? "G5" : "G5.1";
    line += move(0, way());
    line += move(1, way());
    line += fmt::format(" I{:.6f}", way());
    line += fmt::format(" J{:.6f}", way());
    if (is_cubic) line += fmt::format(" P{:.6f}", way());
    if (is_cubic) line += fmt::format(" Q{:.6f}", way());
    lines.push_back(line);
  }

  void nurbs() {
    const std::size_t order = 2 + random_.below(3);
    std::string head = fmt::format("G5.2 L{}", order);
    for (std::size_t count = order + random_.below(5); count > 0; --count) {
      const double x = way();
      const double y = way();
      const double weight = random_.magnitude(1.0e-3, 1.0e3);
      lines.push_back(fmt::format("{} X{:.6f} Y{:.6f} P{:.4f}", head, x, y, weight));
      head.clear();
    }
    lines.emplace_back("G5.3");
  }

  void compensation() {
    if (plane_ != 0) lines.emplace_back("G17");
    plane_ = 0;
    const double width = random_.magnitude(1.0e-4, 100.0);
    const int side = random_.chance(0.5) ? 41 : 42;
    lines.push_back(beside_ ? "G40" : fmt::format("G{}.1 D{:.4f}", side, width));
    beside_ = !beside_;
  }

  void word() {
    const double place = random_.signed_magnitude(1.0e-3, kFarthestMm);
    const double tolerance = random_.magnitude(1.0e-5, 10.0);
    const std::array words = {fmt::format("G64 P{:.5f} Q{:.5f}", tolerance, 0.5 * tolerance),
                              std::string{"G61"},
                              std::string{"G61.1"},
                              std::string{"G64"},
                              fmt::format("G10 L2 P1 X{:.4f}", place),
                              fmt::format("G92 Y{:.4f}", place),
                              std::string{"G92.1"},
                              fmt::format("G43.1 Z{:.4f}", place),
                              std::string{"G49"},
                              std::string{"G4 P0.002"},
                              std::string{"G28.1"},
                              std::string{"G28"},
                              std::string{"M5"},
                              std::string{"M4 S900"}};
    lines.push_back(words[random_.below(words.size())]);
  }

  Random& random_;
  double size_mm_;
  bool incremental_;
  bool beside_ = false;
  std::size_t plane_ = 0;
  std::array<double, 3> place_{};
};

}  // namespace

HostileJob::HostileJob(Random& random) {
  if (random.chance(0.6)) any_scales(random, settings);
  if (random.chance(0.5)) any_settings(random, settings);
  HostileAuthor author{random};
  for (std::size_t count = 3 + random.below(20); count > 0; --count) author.write_line();
  lines = std::move(author.lines);
}

}  // namespace proof
