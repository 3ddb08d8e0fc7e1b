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

/// The program that offsets the path by half a kerf.
enum class WayBeside : std::uint8_t {
  kHere,  ///< This program: the G-code contains the beam's path.
  /// The controller: the G-code contains the drawn outline, and G42 with the kerf of the material.
  kOnController,
};

/// Stands for no contour, as the number of a cut's contour.
inline constexpr std::size_t kNoContour = SIZE_MAX;

/// The whole path along a contour, of which several cuts each have a piece; see share_lines().
using SharedLoop = std::shared_ptr<const std::vector<Stroke>>;

struct BurntPicture;

/// One pierce and the strokes that follow it; or a picture, whose rows are the strokes.
struct Cut {
  /// Number of the contour in the drawing; kNoContour for a slice or a picture.
  std::size_t contour = 0;
  std::size_t layer = 0;  ///< Number of the layer in the drawing and in the plan.
  std::size_t turn = 0;   ///< Cuts of lower turns come before this cut: see CutTurn.
  bool is_hole = false;
  double area_mm2 = 0.0;  ///< Area enclosed by the beam's path, or by `loop`; 0 for an open line.
  /// The whole path, if earlier cuts have some of its lines; otherwise none.
  SharedLoop loop{};
  std::vector<Stroke> strokes{};
  /// The strokes for a controller that computes the compensated path itself (see ControllerWay);
  /// empty if the controller gets `strokes`.
  std::vector<Stroke> programmed{};
  /// Points where the path turned sharply, whatever was done about them.
  std::vector<Place> corners{};
  /// Cuts that must come before this cut. Contours inside a part are cut while the part is still
  /// held.
  std::vector<std::size_t> after{};
  /// Corners of the rapid to the start, between its ends; empty if the rapid is straight.
  std::vector<Place> approach{};
  double lift_mm = 0.0;   ///< Height of Z during the rapid to the start; 0: not lifted.
  bool is_slice = false;  ///< A cut through the waste, which belongs to no contour of the drawing.
  unsigned pass = 1;      ///< Number of this pass over the contour, from 1.
  /// Time at rest with the beam off before the pierce, until the sheet is cooler.
  double wait_s = 0.0;
  std::shared_ptr<const BurntPicture> picture{};  ///< The picture; null if the cut is no picture.

  [[nodiscard]] const Place& start() const { return strokes.front().from; }
  [[nodiscard]] const Place& end() const { return strokes.back().to; }
};

/// Figures of the order of the cuts, with the costs of other orders for comparison.
struct OrderFigures {
  OrderWish wish{};
  bool is_proven = false;  ///< True if no order with beginnings from the lists is cheaper.
  RapidSum rapids{};       ///< Rapids of this order as they are driven.
  /// Rapids of this order if all were straight, as those of the orders below are.
  RapidSum straight{};
  /// Rapids of the first order found, in which all beginnings come from the lists.
  RapidSum listed{};
  /// Rapids in the order of the drawing, each cut with its usual beginning.
  RapidSum file{};
  /// Rapids if always the nearest cut is next, each with its usual beginning.
  RapidSum nearest{};
  double strokes_s = 0.0;  ///< Predicted time without the rapids; 0 until predict() is called.

  [[nodiscard]] double predicted_s() const { return rapids.time_s + strokes_s; }
};

/// Figures of the lines that two parts share; see share_lines().
struct SharedLineFigures {
  bool is_asked = false;
  std::size_t lines = 0;    ///< Lines that are cut once for the parts on both sides.
  double length_mm = 0.0;   ///< Length of these lines.
  double max_off_mm = 0.0;  ///< Greatest excess of the gap of two parts over the kerf.
};

/// The cuts in order, and the contours of the drawing that cannot be cut.
struct CutPlan {
  std::vector<LayerPlan> layers;
  Recipes recipes{};  ///< Plans of contours that rules treat differently from their layers.
  std::vector<Cut> cuts;
  std::vector<drawing::Fault> faults;    ///< Contours that are not cut as drawn.
  std::vector<drawing::Fault> warnings;  ///< Warnings about contours that are cut as drawn.
  OutlineOptions curves;                 ///< Options by which the drawing's curves became arcs.
  OrderFigures order{};                  ///< Data on the choice of the order and on its cost.
  std::vector<Place> way_home{};         ///< Corners of the rapid after the last cut.
  /// Height of Z during the rapid after the last cut; 0: not lifted.
  double lift_home_mm = 0.0;
  SharedLineFigures shared{};  ///< Lines that are cut once for two parts.
  SafetyFigures safety{};      ///< Figures of the measures that make the order safe.

  /// Returns the plan for a cut: by the rules for its contour, otherwise that of its layer.
  [[nodiscard]] const LayerPlan& plan_of(const Cut& cut) const {
    return recipes.of(cut.contour, layers[cut.layer]);
  }
};

/// Plans the cuts of a drawing. The closed contours of each layer are cut at an offset of half a
/// kerf, on the waste side, with leads, overcut and tabs. Those of layers with such a setting are
/// cut on the line. Curves that are neither lines nor arcs are cut as arcs within the tolerance.
/// Faults are contours that could not be approximated by arcs, holes too narrow for the kerf, and
/// parts that are too close to each other for it. Open contours are the drawing's own faults, and
/// are left out.
/// @param layers one for each layer of the drawing
/// @param beside kOnController: cuts at an offset have `programmed`, too; warnings name those
/// without it
/// @param recipes plans of single contours, which replace those of their layers
/// @param order how order and beginnings are chosen; throws as choose_order() does
/// @pre the tolerance of `curves` is within its limits
[[nodiscard]] CutPlan plan_cuts(const drawing::Drawing& drawn,
                                std::vector<LayerPlan> layers,
                                const OutlineOptions& curves = {},
                                WayBeside beside = WayBeside::kHere,
                                Recipes recipes = {},
                                const OrderWish& order = {});

}  // namespace sim::cut
