#include "tests/support/speed_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/place_rules.hpp"

namespace sim {
namespace {

/// Factor on v³ for the optimum's own error: the acceleration-limited optimum may exceed its value
/// on the grid by 1 % of speed.
constexpr double kOwnGrid = 1.03;

/// Returns the square of the greatest speed at the start of a piece, by the joint alone: 0 for a
/// stop. Only this function knows how joints are driven.
double joint_square(const ProgrammedPath& path, std::size_t piece) {
  if (piece == 0) return 0.0;
  const bool stop = is_stop(path.pieces[piece],
                            path.pieces[piece - 1].curve.tangent_at(1.0),
                            path.pieces[piece].curve.tangent_at(0.0));
  return stop ? 0.0 : std::numeric_limits<double>::infinity();
}

bool stops_before(const ProgrammedPath& path, std::size_t piece) {
  return joint_square(path, piece) <= 0.0;
}

double cube_of_root(double square) { return square * std::sqrt(square); }

/// Part of a path between two stops: pieces first…end − 1.
struct PieceRange {
  std::size_t first = 0;
  std::size_t end = 0;
};

class SectionMesher {
 public:
  SectionMesher(const ProgrammedPath& path,
                const MotionLimits& limits,
                const MeshSize& size,
                const SpeedProfile& fastest,
                PieceRange range)
      : path_{path}, limits_{limits}, size_{size}, fastest_{fastest}, range_{range} {}

  /// Divides the section into cells. @param start start of the section, mm along the path @param
  /// sample first sample of the profile in the section
  SpeedSection mesh(double start, std::size_t sample) {
    start_ = start;
    end_ = start;
    for (std::size_t i = range_.first; i < range_.end; ++i) {
      end_ += path_.pieces[i].curve.length();
    }
    find_scales();
    find_slow_joints();
    time_samples(sample);
    double piece_start = start_;
    for (std::size_t i = range_.first; i < range_.end; ++i) {
      add_piece(path_.pieces[i], piece_start);
      piece_start += path_.pieces[i].curve.length();
    }
    bound_ends();
    bound_relief();
    return std::move(cells_);
  }

 private:
  void find_scales() {
    rise_ = INFINITY;
    jerk_ = acceleration_ = 0.0;
    for (std::size_t i = range_.first; i < range_.end; ++i) {
      const PathPiece& piece = path_.pieces[i];
      for (const double fraction : {0.0, 0.5, 1.0}) {
        const PlaceRules rules = rules_at(piece.curve, fraction, limits_);
        const AlongPath most = along_path(rules, cap_at(piece, fraction));
        jerk_ = std::max(jerk_, most.jerk);
        acceleration_ = std::max(acceleration_, most.acceleration);
        for (std::size_t k = 0; k < rules.count; ++k) {
          rise_ = std::min(rise_, rules.axes[k].acceleration / rules.axes[k].jerk);
          longest_rise_ = std::max(longest_rise_, rules.axes[k].acceleration / rules.axes[k].jerk);
        }
      }
    }
  }

  [[nodiscard]] double cap_at(const PathPiece& piece, double fraction) const {
    return cube_of_root(speed_limit_squared(
        piece, piece.curve.tangent_at(fraction), piece.curve.curvature_at(fraction), limits_));
  }

  /// Computes √y at the joints, limited by the values that can be reached from the other joints.
  /// Jerk alone lets √y grow by at most √(4.5 J) per length, as in a start from rest.
  void find_slow_joints() {
    slope_ = std::sqrt(4.5 * jerk_);
    double place = start_;
    for (std::size_t i = range_.first; i <= range_.end; ++i) {
      double cap = 0.0;
      if (i > range_.first && i < range_.end) {
        cap = std::min({cap_at(path_.pieces[i - 1], 1.0),
                        cap_at(path_.pieces[i], 0.0),
                        cube_of_root(joint_square(path_, i))});
      }
      const double reached =
          roots_.empty() ? 0.0 : roots_.back() + slope_ * (place - joins_.back());
      roots_.push_back(std::min(std::sqrt(cap), reached));
      joins_.push_back(place);
      if (i < range_.end) place += path_.pieces[i].curve.length();
    }
    for (std::size_t i = roots_.size() - 1; i-- > 0;) {
      roots_[i] = std::min(roots_[i], roots_[i + 1] + slope_ * (joins_[i + 1] - joins_[i]));
    }
  }

  /// Returns the greatest y at a position that jerk permits between the joints before and after it.
  [[nodiscard]] double cube_between_joints(double place) const {
    const auto above = std::ranges::upper_bound(joins_, place);
    const auto next = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - joins_.begin(), 1, std::ssize(joins_) - 1));
    const double root =
        std::min(roots_[next - 1] + slope_ * std::max(0.0, place - joins_[next - 1]),
                 roots_[next] + slope_ * std::max(0.0, joins_[next] - place));
    return root * root;
  }

  /// Computes times, positions and the greatest v² of the estimated motion.
  void time_samples(std::size_t sample) {
    const auto& samples = fastest_.samples;
    places_ = {start_};
    times_ = {0.0};
    squares_ = {0.0};
    for (; sample + 1 < samples.size() && samples[sample].place < end_ - 1.0e-9; ++sample) {
      const auto& from = samples[sample];
      const auto& to = samples[sample + 1];
      if (to.place <= places_.back()) continue;
      // Takes four points between two samples of the profile, limited by the speeds that can be
      // reached from both samples.
      for (const double share : {0.05, 0.3, 0.7, 1.0}) {
        const double way = share * (to.place - from.place);
        const double rest = (1.0 - share) * (to.place - from.place);
        add_sample(from.place + way,
                   std::min(from.speed * from.speed + 2.0 * acceleration_ * way,
                            to.speed * to.speed + 2.0 * acceleration_ * rest));
      }
    }
    const double least = times_.back() / static_cast<double>(size_.max_cells);
    const double most = times_.back() / static_cast<double>(size_.min_cells);
    step_ = std::clamp(rise_ / size_.cells_per_rise, least, most);
  }

  void add_sample(double place, double square) {
    const double speed = std::min(std::sqrt(square), std::cbrt(cube_between_joints(place)));
    if (last_speed_ + speed <= 0.0) return;
    // The integral ∫ d^(−⅔) at stops gives the factor 3.
    const double weight = last_speed_ > 0.0 && speed > 0.0 ? 2.0 : 3.0;
    const double time = weight * (place - places_.back()) / (last_speed_ + speed);
    last_speed_ = speed;
    times_.push_back(times_.back() + time);
    places_.push_back(place);
    squares_.push_back(square);
  }

  [[nodiscard]] static double interpolate(const std::vector<double>& from,
                                          const std::vector<double>& to,
                                          double at) {
    const auto above = std::ranges::upper_bound(from, at);
    const auto i = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - from.begin(), 1, std::ssize(from) - 1));
    const double share = (at - from[i - 1]) / (from[i] - from[i - 1]);
    return to[i - 1] + std::clamp(share, 0.0, 1.0) * (to[i] - to[i - 1]);
  }

  void add_piece(const PathPiece& piece, double piece_start) {
    const double length = piece.curve.length();
    if (length <= 0.0) return;
    const double from = interpolate(places_, times_, piece_start);
    const double to = interpolate(places_, times_, piece_start + length);
    const double sweep = piece.curve.circle() ? std::abs(piece.curve.circle()->sweep) : 0.0;
    const auto count = static_cast<std::size_t>(
        std::max({1.0, std::ceil((to - from) / step_), std::ceil(sweep / size_.widest)}));
    double last = 0.0;
    for (std::size_t i = 1; i <= count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      const double place = interpolate(times_, places_, from + share * (to - from)) - piece_start;
      const double fraction = i == count ? 1.0 : place / length;
      if (fraction <= last) continue;
      add_cell(piece, last, fraction, piece_start);
      last = fraction;
    }
  }

  void add_cell(const PathPiece& piece, double from, double to, double piece_start) {
    const double middle = 0.5 * (from + to);
    SpeedCell cell{.length = (to - from) * piece.curve.length(),
                   .start = rules_at(piece.curve, from, limits_),
                   .middle = rules_at(piece.curve, middle, limits_),
                   .end = rules_at(piece.curve, to, limits_),
                   .begins_piece = from == 0.0,
                   .turns = piece.curve.circle().has_value(),
                   .cap_inside = cap_at(piece, middle),
                   .cap_end = cap_at(piece, to)};
    if (cell.begins_piece && !cells_.empty()) {
      joints_.push_back(cells_.size());
      cells_.back().cap_end = std::min(cells_.back().cap_end, cap_at(piece, 0.0));
    }
    cells_.push_back(cell);
    const double place = piece_start + middle * piece.curve.length();
    fastest_cubes_.push_back(
        std::min(cube_of_root(interpolate(places_, squares_, place)), cube_between_joints(place)));
  }

  /// Applies the corner rule at the joints.
  void bound_ends() {
    std::size_t piece = range_.first;
    for (const std::size_t joint : joints_) {
      SpeedCell& cell = cells_[joint - 1];
      cell.cap_end = std::min(cell.cap_end, cube_of_root(joint_square(path_, ++piece)));
    }
  }

  /// Computes the bounds of a²/v. First, a²/v ≤ 2 J: to reach the acceleration a from 0, or to
  /// return to 0, the motion changes its speed by at least a²/2J. Second, a²/v ≤ A²/v, which is a
  /// convex function of y. So its chord is a bound, too, from where it is 2 J to the greatest
  /// possible y.
  void bound_relief() {
    const auto reach = static_cast<std::size_t>(std::ceil(longest_rise_ / step_)) + 2;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::size_t first = i > reach ? i - reach : 0;
      const std::size_t end = std::min(cells_.size(), i + reach + 1);
      double jerk = 0.0;
      for (std::size_t k = first; k < end; ++k) jerk = std::max(jerk, cell_limits(k).jerk);
      const double acceleration = cell_limits(i).acceleration;
      JerkRelief& relief = cells_[i].relief;
      relief.exact = false;
      relief.most = 2.0 * jerk;
      const double low_speed = acceleration * acceleration / relief.most;
      const double low = std::pow(low_speed, 3.0);
      const double high = std::min(kOwnGrid * fastest_cubes_[i], cells_[i].cap_inside);
      if (!(low < high) || !std::isfinite(relief.most)) continue;
      const double at_high = acceleration * acceleration / std::cbrt(high);
      relief.slope = (relief.most - at_high) / (high - low);
      relief.offset = relief.most + relief.slope * low;
    }
  }

  [[nodiscard]] AlongPath cell_limits(std::size_t cell) const {
    const double highest = std::min(cells_[cell].cap_inside, kOwnGrid * fastest_cubes_[cell]);
    return along_path(cells_[cell].middle, highest);
  }

  const ProgrammedPath& path_;
  const MotionLimits& limits_;
  const MeshSize& size_;
  const SpeedProfile& fastest_;
  PieceRange range_;
  double start_ = 0.0;
  double end_ = 0.0;
  double rise_ = 0.0;            ///< Least A/J, s.
  double longest_rise_ = 0.0;    ///< Greatest A/J, s.
  double jerk_ = 0.0;            ///< Greatest jerk along the path, mm/s³.
  double acceleration_ = 0.0;    ///< Greatest acceleration along the path, mm/s².
  double step_ = 0.0;            ///< Duration of a cell, s.
  double slope_ = 0.0;           ///< Greatest growth of √y per length.
  std::vector<double> joins_{};  ///< Positions of all joints and of both ends, mm.
  std::vector<double> roots_{};  ///< √y at `joins_`.
  std::vector<double> times_{};
  std::vector<double> places_{};
  std::vector<double> squares_{};  ///< v² of the acceleration-limited optimum.
  double last_speed_ = 0.0;
  SpeedSection cells_{};
  std::vector<double> fastest_cubes_{};  ///< v³ of the fastest motion, for each cell.
  std::vector<std::size_t> joints_{};    ///< Index of the first cell of every piece but the first.
};

}  // namespace

std::vector<SpeedSection> speed_mesh(const ProgrammedPath& path,
                                     const MotionLimits& limits,
                                     const MeshSize& size) {
  std::vector<SpeedSection> sections;
  const SpeedProfile fastest = optimal_profile(path, limits);
  double start = 0.0;
  std::size_t sample = 0;
  for (std::size_t first = 0; first < path.pieces.size();) {
    std::size_t end = first + 1;
    while (end < path.pieces.size() && !stops_before(path, end)) ++end;
    SpeedSection section =
        SectionMesher{path, limits, size, fastest, {first, end}}.mesh(start, sample);
    for (std::size_t i = first; i < end; ++i) start += path.pieces[i].curve.length();
    while (sample < fastest.samples.size() && fastest.samples[sample].place < start - 1.0e-9) {
      ++sample;
    }
    if (!section.empty()) sections.push_back(std::move(section));
    first = end;
  }
  return sections;
}

}  // namespace sim
