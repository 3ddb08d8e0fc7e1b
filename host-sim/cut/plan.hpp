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

/// Who moves the beam half a kerf aside.
enum class WayBeside : std::uint8_t {
  kHere,          ///< The program has the beam's path.
  kOnController,  ///< It has the drawn outline, and G42 by the kerf of the material.
};

/// Number of a cut's contour where it has none.
inline constexpr std::size_t kNoContour = SIZE_MAX;

/// The path along a contour, of which cuts are rests; see share_lines().
using SharedLoop = std::shared_ptr<const std::vector<Stroke>>;

struct BurntPicture;

/// One pierce and what is cut from it on; or a picture, whose rows are its strokes.
struct Cut {
  std::size_t contour = 0;  ///< Of the drawing; kNoContour of a slice and of a picture.
  std::size_t layer = 0;    ///< Of the drawing, and of the plan.
  std::size_t turn = 0;     ///< Cuts of lower turns come before it: see CutTurn.
  bool is_hole = false;
  double area_mm2 = 0.0;  ///< Enclosed by the beam's path, or by `loop`; 0 of an open line.
  SharedLoop loop{};      ///< The whole path, where earlier cuts have some of its lines; else none.
  std::vector<Stroke> strokes{};
  /// The same for a controller that finds the way beside the part (see ControllerWay); none where
  /// it is given the strokes.
  std::vector<Stroke> programmed{};
  /// Where its way turned sharply, whatever was done about it.
  std::vector<Place> corners{};
  /// Cuts that must come before: what lies in a part is cut while the part holds still.
  std::vector<std::size_t> after{};
  /// Corners of the rapid to the start, between its ends; none where it is straight.
  std::vector<Place> approach{};
  double lift_mm = 0.0;   ///< Height of Z during the rapid to the start; 0: not lifted.
  bool is_slice = false;  ///< Of the waste: no contour of the drawing.
  unsigned pass = 1;      ///< Number of times that it has been cut with it.
  double wait_s = 0.0;    ///< The beam rests off before the pierce, until the sheet is cooler.
  std::shared_ptr<const BurntPicture> picture{};  ///< Null of what is no picture.

  [[nodiscard]] const Place& start() const { return strokes.front().from; }
  [[nodiscard]] const Place& end() const { return strokes.back().to; }
};

/// How the cuts came into their order, and what others would have cost.
struct OrderFigures {
  OrderWish wish{};
  bool is_proven = false;  ///< No order with the listed beginnings is cheaper.
  RapidSum rapids{};       ///< The rapids of this order as they are driven.
  RapidSum straight{};     ///< The same if all were straight, as those below are.
  RapidSum listed{};       ///< The first order, in which all beginnings are listed ones.
  RapidSum file{};         ///< As the drawing lists them, each with its usual beginning.
  RapidSum nearest{};      ///< Always the nearest next, each with its usual beginning.
  double strokes_s = 0.0;  ///< Predicted time of everything else; 0 until predict().

  [[nodiscard]] double predicted_s() const { return rapids.time_s + strokes_s; }
};

/// Figures of the lines that two parts share; see share_lines().
struct SharedLineFigures {
  bool is_asked = false;
  std::size_t lines = 0;     ///< Lines that are cut once for the parts on both sides.
  double length_mm = 0.0;    ///< Length of these lines.
  double most_off_mm = 0.0;  ///< Greatest excess of the gap of two parts over the kerf.
};

/// What is to be cut, in order, and what of the drawing cannot be.
struct CutPlan {
  std::vector<LayerPlan> layers;
  Recipes recipes{};  ///< Of contours that rules treat otherwise than their layers.
  std::vector<Cut> cuts;
  std::vector<drawing::Fault> faults;    ///< What is not cut as drawn.
  std::vector<drawing::Fault> warnings;  ///< What is, and should be known.
  OutlineOptions curves;                 ///< How the drawing's curves became arcs.
  OrderFigures order{};                  ///< How the order was chosen, and what it costs.
  std::vector<Place> way_home{};         ///< Corners of the rapid after the last cut.
  double lift_home_mm = 0.0;             ///< Height of Z during that rapid; 0: not lifted.
  SharedLineFigures shared{};            ///< Lines that are cut once for two parts.
  SafetyFigures safety{};                ///< What was done so that the order is safe.

  /// Returns how a cut is made: by the rules for its contour, else as its layer.
  [[nodiscard]] const LayerPlan& plan_of(const Cut& cut) const {
    return recipes.of(cut.contour, layers[cut.layer]);
  }
};

/// The closed contours of each layer, cut half a kerf beside the line, on the waste side, with
/// leads, overcut and tabs; those of layers that say so on the line. Curves that are neither lines
/// nor arcs are cut as arcs within the tolerance. Faults are contours that no arcs follow, holes
/// too narrow for the kerf, and parts that are too close to each other for it; open contours are
/// the drawing's own, and left out.
/// @param layers one for each layer of the drawing
/// @param beside on the controller, what is cut beside the line has `programmed`, too; warnings
/// tell of which has not
/// @param recipes plans of single contours, which replace those of their layers
/// @param order how order and beginnings are chosen; throws as choose_order() does
/// @pre the tolerance of `curves` within its limits
[[nodiscard]] CutPlan plan_cuts(const drawing::Drawing& drawn,
                                std::vector<LayerPlan> layers,
                                const OutlineOptions& curves = {},
                                WayBeside beside = WayBeside::kHere,
                                Recipes recipes = {},
                                const OrderWish& order = {});

}  // namespace sim::cut
