#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/plan.hpp"
#include "host-sim/engrave/engrave_program.hpp"

namespace sim::cut {

/// A picture of a drawing as its layer burns it: the raster of powers and the rows of motion.
struct BurntPicture {
  drawing::Entity entity{};
  engrave::BurnRaster raster{};
  Place at_mm{0.0, 0.0};  ///< Lower left corner of the raster.
  engrave::EngravedRows rows{};
};

/// Format of the rows of pictures in a program.
struct PictureForm {
  /// Whether each line has at most one S word, also on layers whose settings do not require this.
  bool is_plain = false;
  unsigned decimals = 4;  ///< Decimals of printed positions.
};

/// Removes pictures from a drawing if their layers do not burn pictures.
/// @param layers settings of each layer of the drawing
void keep_burnt_pictures(drawing::Drawing& drawn, const std::vector<LayerSettings>& layers);

/// Returns a cut for each picture of the drawing. Pictures of layers with a lower rank come first;
/// pictures of equal rank are in the order of the file. A white picture becomes a fault of kind
/// kPicture in `warnings`. Throws std::invalid_argument with the name of the layer if the laser or
/// the raster cannot fulfil a setting.
/// @param layers plan of each layer of the drawing, with power and feed
[[nodiscard]] std::vector<Cut> picture_cuts(const drawing::Drawing& drawn,
                                            const std::vector<LayerPlan>& layers,
                                            const Beam& beam,
                                            const PictureForm& form,
                                            const OrderWish& machine,
                                            std::vector<drawing::Fault>& warnings);

/// Returns `wish` for the order of the cuts that follow the pictures: the head starts at the end of
/// the last picture.
[[nodiscard]] OrderWish order_behind(const OrderWish& wish, const std::vector<Cut>& pictures);

/// Inserts pictures before all cuts of a plan that was made with order_behind(). Adds the rapids
/// that lead to the pictures to the figures of the order of `plan` and to those of the orders for
/// comparison.
/// @param from position of the head before the first picture
void put_first(std::vector<Cut> pictures, const Place& from, CutPlan& plan);

/// Returns a line for each picture of a plan: `picture image "photo": 400 x 300 pixels, 40.00 x
/// 30.00 mm at X5.000 Y5.000; 300 rows, 9000.0 mm burnt`. A picture with several passes is listed
/// once.
[[nodiscard]] std::vector<std::string> picture_lines(const CutPlan& plan);

}  // namespace sim::cut
