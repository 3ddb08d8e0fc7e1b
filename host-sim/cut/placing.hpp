#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cut/machine_profile.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// The axis along which a drawing is mirrored.
enum class MirrorAlong : std::uint8_t {
  kX,  ///< Left and right are exchanged.
  kY,  ///< Top and bottom are exchanged.
};

/// Position of the box around a drawing with all its copies.
enum class PlaceAt : std::uint8_t {
  kCorner,  ///< In the bed's corner with the origin, at PlaceWishes::margin_mm from both edges.
  kCentre,  ///< In the middle of the bed.
  kPoint,   ///< With its lower left corner at PlaceWishes::point_mm.
};

/// How a drawing is placed on the machine. It is mirrored, scaled and turned about the middle of
/// its box, copied, put at its place, and moved, in this order.
struct PlaceWishes {
  std::optional<PlaceAt> at{};
  Place point_mm{0.0, 0.0};  ///< Position used by PlaceAt::kPoint.
  Place move_mm{0.0, 0.0};
  double turn_deg = 0.0;  ///< Angle, counter-clockwise.
  std::optional<MirrorAlong> mirror{};
  double scale = 1.0;  ///< Factor of the size, above 0.
  std::size_t columns = 1;
  std::size_t rows = 1;
  double gap_mm = 2.0;  ///< Distance between the boxes of copies.
  double margin_mm = 5.0;

  [[nodiscard]] bool is_asked() const;
};

/// Returns the position of the lower left corner of a box; PlaceWishes::point_mm if `at` is not
/// set. Throws std::invalid_argument for the middle of the bed if the machine is not known.
/// @param profile the machine; null if it is not known
[[nodiscard]] Place lower_left(const PlaceWishes& wishes,
                               const Place& size,
                               const MachineProfile* profile);

/// Puts a drawing at its place. Arcs stay arcs. The points of faults move with the first copy.
/// Throws std::invalid_argument if the wishes need a machine that is not known, or if they make the
/// drawing too large.
/// @param profile the machine; null if it is not known
/// @return a line that says what was done; empty if nothing was done
[[nodiscard]] std::string place_drawing(drawing::Drawing& drawn,
                                        const PlaceWishes& wishes,
                                        const MachineProfile* profile,
                                        double effort);

}  // namespace sim::cut
