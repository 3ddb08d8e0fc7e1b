#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "host-sim/measure/program_line.hpp"

namespace sim {

/// What G41 and G42 ask the width for, where it is the kerf of a material: M190, S and F as they
/// are.
struct CutCondition {
  int table = 0;  ///< P of M190, as `$K` counts them.
  double thickness_mm = 0.0;
  double spindle_speed = 0.0;
  double feed_mm_min = 0.0;
};

/// mm; nothing where it is not known.
using CutWidth = std::function<std::optional<double>(const CutCondition&)>;

/// G40, G41, G42, G41.1 and G42.1 as the simulator reads them, with what they go by: tools (G10 L1,
/// T, M6) and the material (M190).
class CutterCompensation {
 public:
  /// @param width by the kerf, where a laser's G41 has no D
  CutterCompensation(bool laser, CutWidth width) : laser_{laser}, width_{std::move(width)} {}

  /// The words of a line. @param scale mm to its unit of length @param feed_mm_min F as it is
  /// @return what is left out, for people; empty where nothing is
  [[nodiscard]] std::string apply(const ProgramLine& line,
                                  double scale,
                                  double spindle_speed,
                                  double feed_mm_min);
  /// G10 L1; false for any other G10.
  [[nodiscard]] bool set_tool(const ProgramLine& line, double scale);
  void end_program();  ///< M2 and M30.

  /// Half the width, positive to the right of the path; 0 for G40.
  [[nodiscard]] double offset_mm() const { return offset_mm_; }
  /// The width is the kerf of a material.
  [[nodiscard]] bool by_kerf() const { return by_kerf_; }

  /// M numbers and G numbers, in tenths, that apply() understands.
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
  std::array<double, kTools + 1> radii_{};  ///< mm, by the tool's number.
  double tool_ = 0.0;
  CutCondition condition_{};
  double offset_mm_ = 0.0;
  bool by_kerf_ = false;
};

}  // namespace sim
