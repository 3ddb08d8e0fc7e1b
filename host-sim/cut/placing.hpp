#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cut/machine_profile.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// The axis along which a drawing is mirrored.
enum class MirrorAlong : std::uint8_t {
  kX,  ///< Along X: left and right are exchanged.
  kY,  ///< Along Y: top and bottom are exchanged.
};

/// Position of the box around a drawing with all its copies.
enum class PlaceAt : std::uint8_t {
  /// The box is in the corner of the bed with the origin, at PlaceWishes::margin_mm from both
  /// edges.
  kCorner,
  kCentre,  ///< The box is in the middle of the bed.
  kPoint,   ///< The lower left corner of the box is at PlaceWishes::point_mm.
};

/// The placement of a drawing on the machine. The drawing is mirrored, scaled and turned about the
/// middle of its box, then copied, then put at its position, then moved.
struct PlaceWishes {
  std::optional<PlaceAt> at{};
  Place point_mm{0.0, 0.0};  ///< Position of the lower left corner for PlaceAt::kPoint.
  Place move_mm{0.0, 0.0};
  double turn_deg = 0.0;  ///< Angle of rotation, counter-clockwise.
  std::optional<MirrorAlong> mirror{};
  double scale = 1.0;  ///< Factor by which the size changes, above 0.
  std::size_t columns = 1;
  std::size_t rows = 1;
  double gap_mm = 2.0;  ///< Distance between the boxes of adjacent copies.
  double margin_mm = 5.0;

  [[nodiscard]] bool is_asked() const;
};

/// Returns the position to which the lower left corner of a box of `size` moves. It is
/// PlaceWishes::point_mm if `at` is not set. Throws std::invalid_argument for the middle of the bed
/// if the machine is not known.
/// @param profile the machine; null if it is not known
[[nodiscard]] Place lower_left(const PlaceWishes& wishes,
                               const Place& size,
                               const MachineProfile* profile);

/// Places a drawing on the machine. Arcs stay arcs. The points of faults move with the first copy.
/// Throws std::invalid_argument if the wishes require a machine that is not known, or if they make
/// the drawing too large.
/// @param profile the machine; null if it is not known
/// @return a line about the changes; empty if nothing was changed
[[nodiscard]] std::string place_drawing(drawing::Drawing& drawn,
                                        const PlaceWishes& wishes,
                                        const MachineProfile* profile,
                                        double effort);

}  // namespace sim::cut
