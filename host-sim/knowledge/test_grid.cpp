#include "host-sim/knowledge/test_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "host-sim/text/lettering.hpp"
#include "host-sim/text/stroke_font.hpp"

namespace sim {
namespace {

using drawing::Place;

/// Least height of a label's capitals; lower capitals cannot be read on wood.
constexpr double kMinLabelMm = 1.2;
constexpr double kLabelSpaceMm = 1.5;  ///< Distance of labels from squares and slots, mm.
/// Greatest distance between the curves of a letter and the lines that replace them.
constexpr double kLetterFaultMm = 0.01;
constexpr const char* kAxesText = "% right, mm/min up";

std::string grid_number(double value) {
  constexpr double kThousand = 1000.0;
  return fmt::format("{:.10g}", std::round(value * kThousand) / kThousand);
}

/// Returns the width of a label whose capitals have the height 1, in the same unit.
double width_of_label(std::string_view words) {
  text::Lettering lettering{true};
  double width = 0.0;
  for (const text::Letter& letter : lettering.line(words, {})) width += letter.advance;
  return width * text::kStrokeUnitsPerEm / text::kStrokeCapital;
}

double widest_label(const std::vector<double>& values) {
  double widest = 0.0;
  for (const double value : values) widest = std::max(widest, width_of_label(grid_number(value)));
  return widest;
}

/// Positions of a grid's parts, relative to its lower left corner.
struct GridLayout {
  double label_mm = 0.0;
  Place squares{0.0, 0.0};  ///< Lower left corner of the first square.
  double pitch_mm = 0.0;
  double axes_y = 0.0;         ///< Base line of the axes' titles.
  double slot_labels_y = 0.0;  ///< Base line of the labels with the slots' widths.
  double slots_y = 0.0;
  std::vector<double> slots_x{};
  Place size{0.0, 0.0};
};

GridLayout layout_of(const TestGrid& grid) {
  GridLayout layout{.label_mm = label_height(grid), .pitch_mm = grid.cell_mm + grid.gap_mm};
  layout.squares = {widest_label(grid.feeds_mm_min) * layout.label_mm + kLabelSpaceMm,
                    layout.label_mm + kLabelSpaceMm};
  const auto across = static_cast<double>(grid.powers_percent.size());
  const auto up = static_cast<double>(grid.feeds_mm_min.size());
  const double right = layout.squares.x() + across * layout.pitch_mm - grid.gap_mm;
  const double top = layout.squares.y() + up * layout.pitch_mm - grid.gap_mm;
  layout.axes_y = top + kLabelSpaceMm;
  layout.slot_labels_y = layout.axes_y + layout.label_mm + kLabelSpaceMm + 1.0;
  layout.slots_y = layout.slot_labels_y + layout.label_mm + kLabelSpaceMm;
  double x = layout.squares.x();
  for (const double width : grid.slots_mm) {
    const double label = width_of_label(grid_number(width)) * layout.label_mm;
    layout.slots_x.push_back(x + 0.5 * std::max(0.0, label - width));
    x += std::max(label, width) + grid.gap_mm;
  }
  const double axes = width_of_label(kAxesText) * layout.label_mm;
  layout.size = {std::max({right, x - grid.gap_mm, layout.squares.x() + axes}),
                 grid.slots_mm.empty() ? layout.axes_y + layout.label_mm
                                       : layout.slots_y + grid.slot_length_mm};
  return layout;
}

/// Writes the motions of a grid as G-code. The beam is on along each path.
class GridWriter {
 public:
  GridWriter(const TestGrid& grid, const GridProgram& program)
      : grid_{grid}, program_{program}, layout_{layout_of(grid)} {}

  std::string written(const std::vector<std::string>& heading) {
    for (const std::string& line : heading) comment(line);
    out_ += "G21 G90 G17 G94\n";
    if (!program_.air.empty()) out_ += program_.air + "\n";
    out_ += program_.follows_speed ? "M4 S0\n" : "M3 S0\n";
    write_labels();
    write_squares();
    write_slots();
    return out_ + "M5\n" + (program_.air.empty() ? "" : "M9\n") + "M2\n";
  }

 private:
  void comment(const std::string& text) { out_ += cut::comment_line(text); }

  std::string point(const Place& place) const {
    return fmt::format("X{} Y{}",
                       grid_number(program_.at_mm.x() + place.x()),
                       grid_number(program_.at_mm.y() + place.y()));
  }

  void path(const std::vector<Place>& places, const GridCondition& condition) {
    constexpr double kFull = 100.0;
    out_ += fmt::format("G0 {}\n", point(places.front()));
    for (std::size_t i = 1; i < places.size(); ++i) {
      out_ += "G1 " + point(places[i]);
      if (i == 1) {
        out_ += fmt::format(" F{} S{}",
                            grid_number(condition.feed_mm_min),
                            grid_number(condition.power_percent / kFull * program_.full_power_s));
      }
      out_ += "\n";
    }
    out_ += "S0\n";
  }

  void label(double value, const Place& at, double anchor) {
    label(grid_number(value), at, anchor);
  }

  /// Writes words at a base line.
  /// @param anchor share of the words' width that is left of `at`
  void label(const std::string& words, Place at, double anchor) {
    const double em = layout_.label_mm * text::kStrokeUnitsPerEm / text::kStrokeCapital;
    at.x() -= anchor * width_of_label(words) * layout_.label_mm;
    for (const text::Letter& letter : lettering_.line(words, {})) {
      for (const auto& stroke : letter.strokes) {
        std::vector<Place> places = drawing::outline_of(stroke, kLetterFaultMm / em);
        for (Place& place : places) place = at + em * place;
        if (places.size() > 1) path(places, grid_.labels);
      }
      at.x() += em * letter.advance;
    }
  }

  void write_labels() {
    comment("labels");
    for (std::size_t i = 0; i < grid_.powers_percent.size(); ++i) {
      label(grid_.powers_percent[i], corner(i, 0) + Place{0.5 * grid_.cell_mm, -label_drop()}, 0.5);
    }
    for (std::size_t i = 0; i < grid_.feeds_mm_min.size(); ++i) {
      const Place middle{-kLabelSpaceMm, 0.5 * (grid_.cell_mm - layout_.label_mm)};
      label(grid_.feeds_mm_min[i], corner(0, i) + middle, 1.0);
    }
    label(kAxesText, {layout_.squares.x(), layout_.axes_y}, 0.0);
    for (std::size_t i = 0; i < grid_.slots_mm.size(); ++i) {
      const double middle = layout_.slots_x[i] + 0.5 * grid_.slots_mm[i];
      label(grid_.slots_mm[i], {middle, layout_.slot_labels_y}, 0.5);
    }
  }

  [[nodiscard]] double label_drop() const { return layout_.label_mm + 0.5 * kLabelSpaceMm; }

  [[nodiscard]] Place corner(std::size_t column, std::size_t row) const {
    return layout_.squares +
           layout_.pitch_mm * Place{static_cast<double>(column), static_cast<double>(row)};
  }

  void write_squares() {
    std::size_t number = 0;
    for (std::size_t row = 0; row < grid_.feeds_mm_min.size(); ++row) {
      for (std::size_t column = 0; column < grid_.powers_percent.size(); ++column) {
        const GridCondition condition{grid_.powers_percent[column], grid_.feeds_mm_min[row]};
        comment(fmt::format("square {}: {} percent, {} mm/min",
                            ++number,
                            grid_number(condition.power_percent),
                            grid_number(condition.feed_mm_min)));
        for (std::size_t pass = 0; pass < grid_.passes; ++pass) {
          write_square(corner(column, row), condition);
        }
      }
    }
  }

  void write_square(const Place& at, const GridCondition& condition) {
    if (!grid_.is_filled) return rectangle(at, {grid_.cell_mm, grid_.cell_mm}, condition);
    const auto lines =
        std::max<std::size_t>(1, static_cast<std::size_t>(grid_.cell_mm / grid_.interval_mm));
    for (std::size_t i = 0; i < lines; ++i) {
      const double y = (static_cast<double>(i) + 0.5) * grid_.interval_mm;
      const double from = i % 2 == 0 ? 0.0 : grid_.cell_mm;
      path({at + Place{from, y}, at + Place{grid_.cell_mm - from, y}}, condition);
    }
  }

  void rectangle(const Place& at, const Place& size, const GridCondition& condition) {
    path({at, at + Place{size.x(), 0.0}, at + size, at + Place{0.0, size.y()}, at}, condition);
  }

  void write_slots() {
    for (std::size_t i = 0; i < grid_.slots_mm.size(); ++i) {
      comment(fmt::format("slot {}: path {} mm wide, {} percent, {} mm/min",
                          i + 1,
                          grid_number(grid_.slots_mm[i]),
                          grid_number(grid_.slots.power_percent),
                          grid_number(grid_.slots.feed_mm_min)));
      for (std::size_t pass = 0; pass < grid_.passes; ++pass) {
        rectangle({layout_.slots_x[i], layout_.slots_y},
                  {grid_.slots_mm[i], grid_.slot_length_mm},
                  grid_.slots);
      }
    }
  }

  const TestGrid& grid_;
  const GridProgram& program_;
  GridLayout layout_;
  text::Lettering lettering_{true};
  std::string out_;
};

}  // namespace

double label_height(const TestGrid& grid) {
  const double widest = std::max(1.0, widest_label(grid.powers_percent));
  const double pitch = grid.cell_mm + grid.gap_mm;
  const double height = std::min({grid.label_mm, pitch / widest, grid.cell_mm});
  if (height >= std::min(kMinLabelMm, grid.label_mm)) return height;
  throw std::invalid_argument(fmt::format(
      "--cell: labels of {:g} mm require {:.1f} mm from square to square, and a cell of "
      "their height; increase --cell or --gap",
      kMinLabelMm,
      kMinLabelMm * widest));
}

drawing::Place size_of(const TestGrid& grid) { return layout_of(grid).size; }

std::string program_of(const TestGrid& grid,
                       const GridProgram& program,
                       const std::vector<std::string>& heading) {
  return GridWriter{grid, program}.written(heading);
}

std::vector<double> steps_between(double least, double most, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(count - 1);
    values.push_back(std::stod(grid_number(least + share * (most - least))));
  }
  return values;
}

}  // namespace sim
