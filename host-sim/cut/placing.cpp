#include "host-sim/cut/placing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "host-sim/import/piece.hpp"
#include "host-sim/sheet/place_parts.hpp"

namespace sim::cut {
namespace {

using drawing::Drawing;
using drawing::DrawnContour;
using drawing::Piece;
using drawing::Transform;

/// The upright rectangle around a drawing, mm.
struct DrawnBox {
  Place low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Place high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

  [[nodiscard]] Place size() const { return high - low; }
};

Transform about(const Place& middle, const Transform& transform) {
  return drawing::moved_by(middle) * transform * drawing::moved_by(-middle);
}

/// Returns transformed contours, which keep their names and part numbers.
std::vector<Piece> mapped(const std::vector<Piece>& pieces, const Transform& transform) {
  std::vector<Piece> result;
  result.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    Piece& moved = result.emplace_back();
    moved.contour.entity = piece.contour.entity;
    moved.contour.closed = piece.contour.closed;
    for (const drawing::Shape& shape : piece.contour.shapes) {
      moved.contour.shapes.push_back(transformed(shape, transform));
    }
    measure(moved);
  }
  return result;
}

DrawnBox box_around(const std::vector<Piece>& pieces) {
  DrawnBox box;
  for (const Piece& piece : pieces) {
    for (const Place& place : piece.outline) {
      box.low = box.low.cwiseMin(place);
      box.high = box.high.cwiseMax(place);
    }
  }
  return box;
}

/// Extends a box to contain the corners of a picture.
void include(const drawing::DrawnPicture& picture, DrawnBox& box) {
  const auto width = static_cast<double>(picture.image->width);
  const auto height = static_cast<double>(picture.image->height);
  for (const Place& corner :
       {Place{0.0, 0.0}, Place{width, 0.0}, Place{0.0, height}, Place{width, height}}) {
    const Place place = picture.to_mm(corner);
    box.low = box.low.cwiseMin(place);
    box.high = box.high.cwiseMax(place);
  }
}

void move_faults(Drawing& drawn, const Transform& transform) {
  for (drawing::Fault& fault : drawn.faults) {
    if (fault.place_mm) fault.place_mm = transform(*fault.place_mm);
  }
}

/// Places one drawing on the machine, with its copies.
class DrawingPlacer {
 public:
  DrawingPlacer(Drawing& drawn, const PlaceWishes& wishes, double effort)
      : drawn_{drawn}, wishes_{wishes}, effort_{effort} {
    for (DrawnContour& contour : drawn.contours) {
      Piece& piece = pieces_.emplace_back();
      piece.contour = contour;
      measure(piece);
    }
    pictures_ = drawn.pictures;
    find_box();
  }

  void place(const MachineProfile* profile) {
    change(about(0.5 * (box_.low + box_.high), shape_change()));
    copy();
    const Place way =
        wishes_.move_mm +
        (wishes_.at ? lower_left(wishes_, box_.size(), profile) - box_.low : Place{0.0, 0.0});
    change(drawing::moved_by(way));
    drawing::Sketch sketch{effort_};
    nest(sketch, pieces_);
    drawn_.contours.clear();
    for (Piece& piece : pieces_) drawn_.contours.push_back(std::move(piece.contour));
    drawn_.pictures = std::move(pictures_);
  }

  [[nodiscard]] const DrawnBox& box() const { return box_; }

 private:
  [[nodiscard]] Transform shape_change() const {
    const bool has_mirror = wishes_.mirror.has_value();
    const bool along_x = has_mirror && *wishes_.mirror == MirrorAlong::kX;
    const bool along_y = has_mirror && *wishes_.mirror == MirrorAlong::kY;
    const Transform size = drawing::scaled_by(along_x ? -wishes_.scale : wishes_.scale,
                                              along_y ? -wishes_.scale : wishes_.scale);
    return sheet::transform_of({.angle_deg = wishes_.turn_deg}) * size;
  }

  void change(const Transform& transform) {
    if (transform.x_axis == Place{1.0, 0.0} && transform.y_axis == Place{0.0, 1.0} &&
        transform.origin == Place{0.0, 0.0}) {
      return;
    }
    pieces_ = mapped(pieces_, transform);
    for (drawing::DrawnPicture& picture : pictures_) picture.to_mm = transform * picture.to_mm;
    find_box();
    move_faults(drawn_, transform);
  }

  void copy() {
    const std::size_t copies = wishes_.columns * wishes_.rows;
    if (copies == 1) return;
    std::size_t shapes = 0;
    std::size_t parts = 0;
    for (const Piece& piece : pieces_) {
      shapes += piece.contour.shapes.size();
      parts = std::max(parts, piece.contour.entity.part + 1);
    }
    if (shapes * copies > drawing::kMaxShapes) {
      throw std::invalid_argument(
          fmt::format("--copies {}x{}: has more than {} lines and curves; make fewer copies",
                      wishes_.columns,
                      wishes_.rows,
                      drawing::kMaxShapes));
    }
    const Place pitch = box_.size() + Place{wishes_.gap_mm, wishes_.gap_mm};
    std::vector<Piece> all;
    all.reserve(pieces_.size() * copies);
    for (std::size_t number = 0; number < copies; ++number) {
      const std::size_t row = number / wishes_.columns;
      const Place way{pitch.x() * static_cast<double>(number % wishes_.columns),
                      pitch.y() * static_cast<double>(row)};
      for (Piece& piece : mapped(pieces_, drawing::moved_by(way))) {
        piece.contour.entity.part += number * parts;
        piece.contour.entity.name = fmt::format("#{}: {}", number + 1, piece.contour.entity.name);
        all.push_back(std::move(piece));
      }
    }
    pieces_ = std::move(all);
    copy_pictures(pitch);
    find_box();
  }

  void copy_pictures(const Place& pitch) {
    const std::vector<drawing::DrawnPicture> once = std::exchange(pictures_, {});
    for (std::size_t number = 0; number < wishes_.columns * wishes_.rows; ++number) {
      const std::size_t row = number / wishes_.columns;
      const Place way{pitch.x() * static_cast<double>(number % wishes_.columns),
                      pitch.y() * static_cast<double>(row)};
      for (const drawing::DrawnPicture& picture : once) {
        drawing::DrawnPicture& copy = pictures_.emplace_back(picture);
        copy.to_mm = drawing::moved_by(way) * copy.to_mm;
        copy.entity.name = fmt::format("#{}: {}", number + 1, copy.entity.name);
      }
    }
  }

  void find_box() {
    box_ = box_around(pieces_);
    for (const drawing::DrawnPicture& picture : pictures_) include(picture, box_);
  }

  Drawing& drawn_;
  const PlaceWishes& wishes_;
  double effort_;
  std::vector<Piece> pieces_;
  std::vector<drawing::DrawnPicture> pictures_;
  DrawnBox box_;
};

std::string change_text(const PlaceWishes& wishes) {
  std::string text;
  if (wishes.mirror)
    text += *wishes.mirror == MirrorAlong::kX ? "mirrored along X, " : "mirrored along Y, ";
  if (wishes.scale != 1.0) text += fmt::format("scaled by {:g}, ", wishes.scale);
  if (wishes.turn_deg != 0.0) text += fmt::format("turned by {:g} degrees, ", wishes.turn_deg);
  if (wishes.columns * wishes.rows > 1) {
    text += fmt::format("{} x {} copies, ", wishes.columns, wishes.rows);
  }
  return text;
}

}  // namespace

Place lower_left(const PlaceWishes& wishes, const Place& size, const MachineProfile* profile) {
  const PlaceAt at = wishes.at.value_or(PlaceAt::kPoint);
  if (at == PlaceAt::kPoint) return wishes.point_mm;
  if (at == PlaceAt::kCentre && profile == nullptr) {
    throw std::invalid_argument(
        "--place centre: the bed is not known; name the machine with --machine, or give --place "
        "X,Y");
  }
  const BedBox bed = profile != nullptr ? profile->bed() : BedBox{};
  if (at == PlaceAt::kCentre) return 0.5 * (bed.low + bed.high - size);
  const Place margin{wishes.margin_mm, wishes.margin_mm};
  const Place low = bed.low + margin;
  const Place high = bed.high - margin - size;
  // If the origin is on the right or at the back, the coordinates on the bed are negative.
  return {bed.low.x() < 0.0 && bed.high.x() <= 0.0 ? high.x() : low.x(),
          bed.low.y() < 0.0 && bed.high.y() <= 0.0 ? high.y() : low.y()};
}

bool PlaceWishes::is_asked() const {
  return at || mirror || turn_deg != 0.0 || scale != 1.0 || columns * rows > 1 ||
         move_mm != Place{0.0, 0.0};
}

std::string place_drawing(Drawing& drawn,
                          const PlaceWishes& wishes,
                          const MachineProfile* profile,
                          double effort) {
  PlaceWishes all = wishes;
  if (profile != nullptr) all.move_mm -= profile->beam_offset_mm;
  if (!all.is_asked() || (drawn.contours.empty() && drawn.pictures.empty())) return {};
  DrawingPlacer placer{drawn, all, effort};
  placer.place(profile);
  const DrawnBox& box = placer.box();
  return fmt::format(
      "placed: {}X{:.3f} to {:.3f}, Y{:.3f} to {:.3f} mm{}; positions are those of the machine",
      change_text(all),
      box.low.x(),
      box.high.x(),
      box.low.y(),
      box.high.y(),
      profile == nullptr ? "" : ", " + profile->origin_text());
}

}  // namespace sim::cut
