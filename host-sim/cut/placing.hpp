#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cut/machine_profile.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// The axis along which a drawing is mirrored.
enum class MirrorAlong : std::uint8_t {
  kX,  ///< Left and right change places.
  kY,  ///< Top and bottom do.
};

/// Where the box around a drawing, with all its copies, is put.
enum class PlaceAt : std::uint8_t {
  kCorner,  ///< PlaceWishes::margin_mm from both edges of the bed at its origin.
  kCentre,  ///< Of the bed.
  kPoint,   ///< Its lower left corner is there.
};

/// How a drawing is put on the machine: it is mirrored, scaled and turned about the middle of its
/// box, copied, put to its place, and moved, in this order.
struct PlaceWishes {
  std::optional<PlaceAt> at{};
  Place point_mm{0.0, 0.0};  ///< Of PlaceAt::kPoint.
  Place move_mm{0.0, 0.0};
  double turn_deg = 0.0;  ///< Counter-clockwise.
  std::optional<MirrorAlong> mirror{};
  double scale = 1.0;  ///< Above 0.
  std::size_t columns = 1;
  std::size_t rows = 1;
  double gap_mm = 2.0;  ///< Between the boxes of copies.
  double margin_mm = 5.0;

  [[nodiscard]] bool is_asked() const;
};

/// Returns where the lower left corner of a box comes to; PlaceWishes::point_mm without a place.
/// Throws std::invalid_argument for a centre without a machine.
/// @param profile the machine; null where it is not known
[[nodiscard]] Place lower_left(const PlaceWishes& wishes,
                               const Place& size,
                               const MachineProfile* profile);

/// Puts a drawing to its place. Arcs stay arcs; places of faults move with the first copy. Throws
/// std::invalid_argument where the wishes need a machine, or make the drawing too large.
/// @param profile the machine; null where it is not known
/// @return a line that says what was done, empty where nothing was
[[nodiscard]] std::string place_drawing(drawing::Drawing& drawn,
                                        const PlaceWishes& wishes,
                                        const MachineProfile* profile,
                                        double effort);

}  // namespace sim::cut
