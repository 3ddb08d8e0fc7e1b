#include "host-sim/import/svg_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host-sim/import/drawing.hpp"
#include "host-sim/import/scanner.hpp"

namespace sim::drawing {
namespace {

constexpr double kDegree = kFullTurn / 360.0;

/// Returns the number of operands of a command; nothing for a letter that is no command.
std::optional<std::size_t> operand_count(char upper) {
  switch (upper) {
    case 'Z':
      return 0;
    case 'H':
    case 'V':
      return 1;
    case 'M':
    case 'L':
    case 'T':
      return 2;
    case 'S':
    case 'Q':
      return 4;
    case 'C':
      return 6;
    case 'A':
      return 7;
    default:
      return {};
  }
}

/// Reads the attribute `d` of a path, command by command.
class PathReader {
 public:
  PathReader(std::string_view data, SvgPen& pen) : scanner_{data}, pen_{pen} {}

  std::string read() {
    while (!scanner_.at_end()) {
      const std::size_t column = scanner_.column();
      const char letter = scanner_.peek();
      const auto upper = static_cast<char>(letter & ~0x20);
      const auto count = operand_count(upper);
      const bool is_letter = (letter >= 'A' && letter <= 'Z') || (letter >= 'a' && letter <= 'z');
      if (!is_letter || !count) return fmt::format("no path command at character {} of d", column);
      if (first_ && upper != 'M') return "the path does not begin with M";
      scanner_.skip();
      relative_ = letter != upper;
      if (!repeat(upper, *count)) {
        return fmt::format(
            "{} needs {} numbers at character {} of d", letter, *count, scanner_.column());
      }
      if (pen_.shape_count() > kMaxShapes) return "the path has too many parts";
    }
    return {};
  }

 private:
  /// Draws a command, and repeats it while further operands follow.
  bool repeat(char upper, std::size_t count) {
    if (count == 0) {
      pen_.close();
      smooth_ = '\0';
      return true;
    }
    do {
      if (!operands(upper, count)) return false;
      draw(upper);
      first_ = false;
      if (upper == 'M') upper = 'L';
      smooth_ = upper;
      scanner_.separate();
      if (pen_.shape_count() > kMaxShapes) return true;
    } while (number_follows());
    return true;
  }

  bool number_follows() {
    const char next = scanner_.peek();
    return (next >= '0' && next <= '9') || next == '-' || next == '+' || next == '.';
  }

  bool operands(char upper, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (i != 0) scanner_.separate();
      if (upper == 'A' && (i == 3 || i == 4)) {
        const auto flag = scanner_.flag();
        if (!flag) return false;
        values_[i] = *flag ? 1.0 : 0.0;
        continue;
      }
      const auto value = scanner_.number();
      if (!value) return false;
      values_[i] = *value;
    }
    return true;
  }

  [[nodiscard]] Place place(std::size_t i) const {
    const Place given{values_[i], values_[i + 1]};
    return relative_ ? Place{given + pen_.at()} : given;
  }

  /// Returns the first control point of a smooth command: the last control point mirrored at the
  /// current point, or the current point if the previous command was of another kind.
  [[nodiscard]] Place mirrored(bool after_same_kind) const {
    return after_same_kind ? Place{2.0 * pen_.at() - control_} : pen_.at();
  }

  void draw(char upper) {
    const double base_x = relative_ ? pen_.at().x() : 0.0;
    const double base_y = relative_ ? pen_.at().y() : 0.0;
    switch (upper) {
      case 'M':
        return pen_.move_to(place(0));
      case 'L':
        return pen_.line_to(place(0));
      case 'H':
        return pen_.line_to({base_x + values_[0], pen_.at().y()});
      case 'V':
        return pen_.line_to({pen_.at().x(), base_y + values_[0]});
      case 'A':
        return pen_.arc_to(
            {values_[0], values_[1]}, values_[2], values_[3] != 0.0, values_[4] != 0.0, place(5));
      default:
        return draw_bezier(upper);
    }
  }

  void draw_bezier(char upper) {
    const bool after_cubic = smooth_ == 'C' || smooth_ == 'S';
    const bool after_quadratic = smooth_ == 'Q' || smooth_ == 'T';
    if (upper == 'C' || upper == 'S') {
      const Place first = upper == 'C' ? place(0) : mirrored(after_cubic);
      const std::size_t rest = upper == 'C' ? 2 : 0;
      const Place end = place(rest + 2);
      control_ = place(rest);
      pen_.cubic_to(first, control_, end);
    } else {
      const Place control = upper == 'Q' ? place(0) : mirrored(after_quadratic);
      const Place end = place(upper == 'Q' ? 2 : 0);
      control_ = control;
      pen_.quadratic_to(control, end);
    }
  }

  Scanner scanner_;
  SvgPen& pen_;
  std::array<double, 7> values_{};
  Place control_{0.0, 0.0};
  char smooth_ = '\0';  ///< Letter of the previous command, for mirrored().
  bool relative_ = false;
  bool first_ = true;
};

}  // namespace

std::vector<Shape>& SvgPen::shapes() {
  if (!open_) {
    subpaths_.emplace_back();
    open_ = true;
  }
  ++count_;
  return subpaths_.back();
}

void SvgPen::move_to(const Place& place) {
  at_ = start_ = place;
  open_ = false;
}

void SvgPen::line_to(const Place& place) {
  shapes().emplace_back(Line{at_, place});
  at_ = place;
}

void SvgPen::cubic_to(const Place& first, const Place& second, const Place& place) {
  shapes().emplace_back(Bezier{{at_, first, second, place}});
  at_ = place;
}

void SvgPen::quadratic_to(const Place& control, const Place& place) {
  const Place first = at_ + (control - at_) * (2.0 / 3.0);
  const Place second = place + (control - place) * (2.0 / 3.0);
  cubic_to(first, second, place);
}

void SvgPen::arc_to(
    Place radii, double rotation_deg, bool large, bool positive, const Place& place) {
  radii = radii.cwiseAbs();
  if (place == at_) return;
  if (radii.x() == 0.0 || radii.y() == 0.0) return line_to(place);
  const Place axis = direction(rotation_deg * kDegree);
  const Place left{-axis.y(), axis.x()};
  const Place half = 0.5 * (at_ - place);
  // Vector along half of the chord, in units of the radii along the axes of the ellipse.
  const Place unit{dot(axis, half) / radii.x(), dot(left, half) / radii.y()};
  const double reach = unit.squaredNorm();
  if (reach > 1.0) radii *= std::sqrt(reach);
  const Place u = unit / std::max(1.0, std::sqrt(reach));
  const double offset = std::sqrt(std::max(0.0, 1.0 / u.squaredNorm() - 1.0));
  const double side = large == positive ? -offset : offset;
  const Place centre{side * u.y(), -side * u.x()};
  const Place start = u - centre;
  const Place end = -u - centre;
  double sweep = std::atan2(cross(start, end), dot(start, end));
  if (positive && sweep <= 0.0) sweep += kFullTurn;
  if (!positive && sweep >= 0.0) sweep -= kFullTurn;
  const Place middle =
      0.5 * (at_ + place) + axis * (centre.x() * radii.x()) + left * (centre.y() * radii.y());
  if (radii.x() == radii.y()) {
    shapes().emplace_back(Arc{at_, place, middle, sweep});
  } else {
    const double from = std::atan2(start.y(), start.x());
    shapes().emplace_back(Ellipse{middle, axis * radii.x(), left * radii.y(), from, from + sweep});
  }
  at_ = place;
}

void SvgPen::close() {
  if (open_ && at_ != start_) line_to(start_);
  at_ = start_;
  open_ = false;
}

std::string draw_path(std::string_view data, SvgPen& pen) { return PathReader{data, pen}.read(); }

std::string draw_points(std::string_view points, bool closed, SvgPen& pen) {
  Scanner scanner{points};
  for (bool first = true; !scanner.at_end(); first = false) {
    const auto x = scanner.number();
    scanner.separate();
    const auto y = scanner.number();
    scanner.separate();
    if (!x || !y) return fmt::format("no number at character {} of points", scanner.column());
    if (first) {
      pen.move_to({*x, *y});
    } else {
      pen.line_to({*x, *y});
    }
    if (pen.shape_count() > kMaxShapes) return "there are too many points";
  }
  if (closed) pen.close();
  return {};
}

}  // namespace sim::drawing
