#include "planner/gcode/program_writer.hpp"

#include <array>

namespace cnc::gcode {
namespace {

constexpr std::array<char, kLinearAxisCount> kCentreLetters{'I', 'J', 'K'};

}  // namespace

std::string_view ProgramWriter::use_plane(Plane plane) {
  CNC_ASSERT(place_.has_value() && written_height_.has_value());
  text_.clear();
  if (plane == plane_) return text_.view();
  std::array<std::int32_t, kLinearAxisCount> place{};
  const PlaneAxes before = axes_of(plane_);
  place[before.first] = place_->x;
  place[before.second] = place_->y;
  place[before.normal] = *written_height_;
  const PlaneAxes after = axes_of(plane);
  place_ = GridPlace{place[after.first], place[after.second]};
  height_ = written_height_ = place[after.normal];
  plane_ = plane;
  constexpr int kFirstPlane = 17;
  text_.add_word('G', kFirstPlane + static_cast<int>(plane), 0);
  text_.add('\n');
  return text_.view();
}

std::optional<std::int32_t> ProgramWriter::half_way() const {
  if (!height_ || !written_height_) return height_;
  return *written_height_ + (*height_ - *written_height_) / 2;
}

void ProgramWriter::add_rapids(GridPlace to) {
  const auto end = height_;
  const bool goes_down = end && written_height_ && *end < *written_height_;
  if (goes_down) height_ = written_height_;
  // At the start of a program the machine may be at any height, so the motion to the height comes
  // first.
  if (!goes_down && !is_at_height()) {
    if (motion_ != 0) text_.add_word('G', 0, 0);
    motion_ = 0;
    add_height();
    text_.add('\n');
  }
  if (place_ != to) {
    add_motion(0, to);
    end_line(to);
  }
  height_ = end;
  if (!is_at_height()) {
    add_motion(0, to);
    end_line(to);
  }
}

void ProgramWriter::add_height() {
  if (is_at_height()) return;
  text_.add_word(kAxisLetters[axes_of(plane_).normal], *height_, grid_.decimals());
  written_height_ = height_;
}

void ProgramWriter::add_line(GridPlace to) {
  if (place_ == to && is_at_height()) return;
  add_motion(1, to);
  end_line(to);
}

void ProgramWriter::add_arc(GridPlace to, GridCentre centre, bool clockwise) {
  add_motion(clockwise ? 2 : 3, to);
  const auto decimals = static_cast<std::uint8_t>(grid_.decimals() + 1);
  const PlaneAxes axes = axes_of(plane_);
  if (centre.x != 0) text_.add_word(kCentreLetters[axes.first], centre.x, decimals);
  if (centre.y != 0) text_.add_word(kCentreLetters[axes.second], centre.y, decimals);
  end_line(to);
}

void ProgramWriter::add_motion(int motion, GridPlace to) {
  if (motion != motion_) text_.add_word('G', motion, 0);
  motion_ = motion;
  const PlaneAxes axes = axes_of(plane_);
  const auto add_place = [&](std::size_t axis, std::int32_t place) {
    text_.add_word(kAxisLetters[axis], place, grid_.decimals());
  };
  if (!place_ || place_->x != to.x) add_place(axes.first, to.x);
  if (!place_ || place_->y != to.y) add_place(axes.second, to.y);
  add_height();
}

void ProgramWriter::end_line(GridPlace to) {
  constexpr std::uint8_t kThousandths = 3;
  if (motion_ != 0 && feed_ != written_feed_) text_.add_word('F', feed_, kThousandths);
  if (motion_ != 0 && power_ != written_power_) text_.add_word('S', power_, kThousandths);
  if (motion_ != 0) {
    written_feed_ = feed_;
    written_power_ = power_;
  }
  text_.add('\n');
  place_ = to;
}

}  // namespace cnc::gcode
