#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/plan.hpp"
#include "host-sim/engrave/engrave_program.hpp"

namespace sim::cut {

/// A picture of a drawing, as its layer burns it.
struct BurntPicture {
  drawing::Entity entity{};
  engrave::BurnRaster raster{};
  Place at_mm{0.0, 0.0};  ///< The lower left corner of the raster.
  engrave::EngravedRows rows{};
};

/// How pictures are written.
struct PictureForm {
  bool is_plain = false;  ///< One S to a line, whatever the layers say.
  unsigned decimals = 4;  ///< Decimals of positions.
};

/// Leaves in a drawing only the pictures of layers that burn them.
void keep_burnt_pictures(drawing::Drawing& drawn, const std::vector<LayerSettings>& layers);

/// Returns a cut for each picture of the drawing, layers of lower rank first, else in the order of
/// the file. A picture that is white becomes a fault of kind kPicture in `warnings`. Throws
/// std::invalid_argument with the layer for what the laser or the raster cannot.
/// @param layers one for each layer of the drawing, with power and feed
[[nodiscard]] std::vector<Cut> picture_cuts(const drawing::Drawing& drawn,
                                            const std::vector<LayerPlan>& layers,
                                            const Beam& beam,
                                            const PictureForm& form,
                                            const OrderWish& machine,
                                            std::vector<drawing::Fault>& warnings);

/// Returns the wishes for the cuts behind pictures: they begin where the last picture ends.
[[nodiscard]] OrderWish order_behind(const OrderWish& wish, const std::vector<Cut>& pictures);

/// Puts pictures before all cuts of a plan that was made with order_behind(). Other orders that the
/// plan tells of have the rapids to the pictures as well.
/// @param from where the head is before the first of them
void put_first(std::vector<Cut> pictures, const Place& from, CutPlan& plan);

/// Returns `picture image "photo": 400 x 300 pixels, 40.00 x 30.00 mm at X5.000 Y5.000; 300 rows,
/// 9000.0 mm burnt` for each picture of a plan; of several passes once.
[[nodiscard]] std::vector<std::string> picture_lines(const CutPlan& plan);

}  // namespace sim::cut
