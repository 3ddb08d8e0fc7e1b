#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "host-sim/measure/program_line.hpp"

namespace sim {

/// Condition that determines the width for G41 and G42 if the width is the kerf of a material: the
/// values of M190, S and F at that line.
struct CutCondition {
  int table = 0;  ///< Number of the kerf table: P of M190, with the numbers of the listing `$K`.
  double thickness_mm = 0.0;
  double spindle_speed = 0.0;
  double feed_mm_min = 0.0;
};

/// Returns the width of the cut, mm; none if it is not known.
using CutWidth = std::function<std::optional<double>(const CutCondition&)>;

/// Reads G40, G41, G42, G41.1 and G42.1 in the same way as the simulator. Also reads their data:
/// tools (G10 L1, T, M6) and the material (M190).
class CutterCompensation {
 public:
  /// Begins without compensation.
  /// @param width returns the kerf for G41 of a laser without D
  CutterCompensation(bool laser, CutWidth width) : laser_{laser}, width_{std::move(width)} {}

  /// Applies the words of a line.
  /// @param scale mm per unit of length of the line
  /// @param feed_mm_min F in mm/min
  /// @return note for the user about an ignored word; empty if all words are applied
  [[nodiscard]] std::string apply(const ProgramLine& line,
                                  double scale,
                                  double spindle_speed,
                                  double feed_mm_min);
  /// Applies G10 L1. Returns false for any other G10.
  [[nodiscard]] bool set_tool(const ProgramLine& line, double scale);
  void end_program();  ///< Applies M2 and M30.

  /// Returns half the width, mm, positive to the right of the path; 0 for G40.
  [[nodiscard]] double offset_mm() const { return offset_mm_; }
  /// Returns whether the width is the kerf of a material.
  [[nodiscard]] bool by_kerf() const { return by_kerf_; }

  /// Returns whether apply() supports an M number; knows_g() does the same for a G number in
  /// tenths.
  [[nodiscard]] static bool knows_m(int m) { return m == 190; }
  [[nodiscard]] static bool knows_g(int g);

 private:
  static constexpr std::size_t kTools = 12;

  [[nodiscard]] double radius_of(double tool) const;
  [[nodiscard]] std::optional<double> width_of(const ProgramLine& line,
                                               bool by_word,
                                               double scale) const;

  bool laser_;
  CutWidth width_;
  std::array<double, kTools + 1> radii_{};  ///< Radius of each tool, indexed by its number, mm.
  double tool_ = 0.0;
  CutCondition condition_{};
  double offset_mm_ = 0.0;
  bool by_kerf_ = false;
};

}  // namespace sim
