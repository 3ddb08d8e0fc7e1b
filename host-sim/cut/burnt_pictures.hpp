#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/plan.hpp"
#include "host-sim/engrave/engrave_program.hpp"

namespace sim::cut {

/// A picture of a drawing, as the settings of its layer burn it.
struct BurntPicture {
  drawing::Entity entity{};
  engrave::BurnRaster raster{};
  Place at_mm{0.0, 0.0};  ///< The lower left corner of the raster.
  engrave::EngravedRows rows{};
};

/// Format in which pictures are written.
struct PictureForm {
  bool is_plain = false;  ///< One S word per line, whatever the layers require.
  unsigned decimals = 4;  ///< Decimals of printed positions.
};

/// Removes from a drawing everything except the pictures of layers that burn them.
void keep_burnt_pictures(drawing::Drawing& drawn, const std::vector<LayerSettings>& layers);

/// Returns a cut for each picture of the drawing. Layers of lower rank come first; otherwise the
/// order is that of the file. A white picture becomes a fault of kind kPicture in `warnings`.
/// Throws std::invalid_argument, which names the layer, for settings that the laser or the raster
/// cannot fulfil.
/// @param layers one for each layer of the drawing, with power and feed
[[nodiscard]] std::vector<Cut> picture_cuts(const drawing::Drawing& drawn,
                                            const std::vector<LayerPlan>& layers,
                                            const Beam& beam,
                                            const PictureForm& form,
                                            const OrderWish& machine,
                                            std::vector<drawing::Fault>& warnings);

/// Returns the order wishes for the cuts that follow the pictures: they begin at the point where
/// the last picture ends.
[[nodiscard]] OrderWish order_behind(const OrderWish& wish, const std::vector<Cut>& pictures);

/// Inserts pictures before all cuts of a plan that was made with order_behind(). The figures of the
/// other orders in the plan then include the rapids to the pictures, too.
/// @param from position of the head before the first picture
void put_first(std::vector<Cut> pictures, const Place& from, CutPlan& plan);

/// Returns `picture image "photo": 400 x 300 pixels, 40.00 x 30.00 mm at X5.000 Y5.000; 300 rows,
/// 9000.0 mm burnt` for each picture of a plan. A picture with several passes is listed once.
[[nodiscard]] std::vector<std::string> picture_lines(const CutPlan& plan);

}  // namespace sim::cut
