#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host-sim/contour/outline.hpp"
#include "host-sim/cut/order_choice.hpp"
#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/recipe.hpp"
#include "host-sim/cut/safety_figures.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// The side that computes the compensated path, at an offset of half a kerf.
enum class WayBeside : std::uint8_t {
  kHere,  ///< This program computes the path, and the G-code contains the path of the beam.
  /// The controller computes the path. The G-code contains the drawn outline, and G42 with the kerf
  /// of the material.
  kOnController,
};

/// Value of Cut::contour for a cut without a contour.
inline constexpr std::size_t kNoContour = SIZE_MAX;

/// The whole path along a contour, if each of several cuts has a piece of it; see share_lines().
using SharedLoop = std::shared_ptr<const std::vector<Stroke>>;

struct BurntPicture;

/// One cut: a pierce and the strokes that follow it. For a picture, the strokes are its rows.
struct Cut {
  /// Number of the contour in the drawing; kNoContour if the cut is a slice or a picture.
  std::size_t contour = 0;
  std::size_t layer = 0;  ///< Number of the layer in the drawing and in the plan.
  std::size_t turn = 0;   ///< Number of its turn (see CutTurn). Cuts of lower turns come first.
  bool is_hole = false;
  double area_mm2 = 0.0;  ///< Area that the path, or `loop`, encloses; 0 for an open line.
  /// The whole path, if earlier cuts have some of its lines; otherwise null.
  SharedLoop loop{};
  std::vector<Stroke> strokes{};
  /// The strokes for a controller that computes the compensated path itself (see ControllerWay).
  /// Empty if the program contains `strokes`.
  std::vector<Stroke> programmed{};
  /// Points where the path turns sharply, with or without a treatment of these corners.
  std::vector<Place> corners{};
  /// Numbers of the cuts that must come before this cut. Contours inside a part are cut while the
  /// part is still held.
  std::vector<std::size_t> after{};
  /// Points between the ends of the rapid to the start of the cut, at which it turns; empty if the
  /// rapid is straight.
  std::vector<Place> approach{};
  double lift_mm = 0.0;   ///< Height of Z during the rapid to the cut; 0: not lifted.
  bool is_slice = false;  ///< Whether the cut divides the waste; it then belongs to no contour.
  unsigned pass = 1;      ///< Number of this pass over the contour, from 1 on.
  /// Time for which the beam rests with its power off before the pierce, until the sheet is cooler.
  double wait_s = 0.0;
  std::shared_ptr<const BurntPicture> picture{};  ///< The picture; null if the cut is no picture.

  [[nodiscard]] const Place& start() const { return strokes.front().from; }
  [[nodiscard]] const Place& end() const { return strokes.back().to; }
};

/// Figures of the order of the cuts, and of other orders for comparison.
struct OrderFigures {
  OrderWish wish{};
  /// Whether it is proven that no order with listed beginnings is cheaper.
  bool is_proven = false;
  RapidSum rapids{};  ///< Rapids of this order as they are routed.
  /// Rapids of this order if all of them were straight, for a comparison with the orders below.
  RapidSum straight{};
  /// Rapids of the order before refinement, when all beginnings are from the lists.
  RapidSum listed{};
  /// Rapids of the order of the drawing, with the usual beginning of each cut.
  RapidSum file{};
  /// Rapids of the order in which the nearest cut is always next, with the usual beginning of each
  /// cut.
  RapidSum nearest{};
  /// Predicted time of everything except rapids; 0 before predict() is called.
  double strokes_s = 0.0;

  [[nodiscard]] double predicted_s() const { return rapids.time_s + strokes_s; }
};

/// Figures of the lines that two parts share; see share_lines().
struct SharedLineFigures {
  bool is_asked = false;
  std::size_t lines = 0;    ///< Number of lines that are cut once for the parts on both sides.
  double length_mm = 0.0;   ///< Total length of the shared lines.
  double max_off_mm = 0.0;  ///< Greatest difference between the gap of two parts and the kerf.
};

/// The plan of a job: its cuts in order, and the faults of the drawing's contours.
struct CutPlan {
  std::vector<LayerPlan> layers;
  Recipes recipes{};  ///< Plans of contours that rules treat differently from their layers.
  std::vector<Cut> cuts;
  std::vector<drawing::Fault> faults;    ///< Faults of contours that are not cut as drawn.
  std::vector<drawing::Fault> warnings;  ///< Warnings about contours, cuts and settings.
  OutlineOptions curves;                 ///< Options by which the drawing's curves became arcs.
  OrderFigures order{};                  ///< Figures of the chosen order and of its cost.
  /// Points between the ends of the rapid after the last cut, at which it turns.
  std::vector<Place> way_home{};
  /// Height of Z during the rapid after the last cut; 0: not lifted.
  double lift_home_mm = 0.0;
  SharedLineFigures shared{};  ///< Figures of the lines that are cut once for two parts.
  SafetyFigures safety{};      ///< Effects of the measures that make the order safe.

  /// Returns the plan that applies to a cut: that of its contour if rules changed it, otherwise
  /// that of its layer.
  [[nodiscard]] const LayerPlan& plan_of(const Cut& cut) const {
    return recipes.of(cut.contour, layers[cut.layer]);
  }
};

/// Plans the cuts of a drawing. The closed contours of each layer are cut at an offset of half a
/// kerf, on the side of the waste, with leads, overcut and tabs. If the settings of a layer require
/// it, its contours are cut on the line instead. Curves that are neither lines nor arcs are cut as
/// arcs within the tolerance.
///
/// Faults are contours that cannot be approximated by arcs, parts and holes narrower than the kerf,
/// and parts that are nearer to each other than the kerf. Open contours are cut on the line, with a
/// warning. Open contours that may be meant as closed are left out, because they are faults of the
/// drawing.
/// @param layers plan of each layer of the drawing
/// @param beside with kOnController, cuts at an offset also have `programmed`; warnings name cuts
/// without it
/// @param recipes plans of single contours, which replace those of their layers
/// @param order wishes for order and beginnings; throws as choose_order() does
/// @pre the tolerance of `curves` is within its limits
[[nodiscard]] CutPlan plan_cuts(const drawing::Drawing& drawn,
                                std::vector<LayerPlan> layers,
                                const OutlineOptions& curves = {},
                                WayBeside beside = WayBeside::kHere,
                                Recipes recipes = {},
                                const OrderWish& order = {});

}  // namespace sim::cut
