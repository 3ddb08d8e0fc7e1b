#include "host-sim/measure/program_reader.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/measure/programmed_arc.hpp"
#include "planner/base/units.hpp"

namespace sim {
namespace {

double rotary_distance(const Point& from, const Point& to) {
  Point run = to - from;
  for (std::size_t i = 0; i < cnc::kLinearAxisCount; ++i) run[i] = 0.0;
  return norm(run);
}

/// Greatest P of an arc that the controller accepts.
constexpr double kMaxArcTurns = 65'535.0;

/// Greatest number of notes that are kept in memory.
constexpr std::size_t kMaxReadNotes = 1000;

/// Radius below which a circle counts as a point, mm: half a nanometre.
constexpr double kNoCircle = 0.5e-6;

constexpr std::array kStopWords{0, 1, 2, 30};
constexpr int kToolChangeWord = 6;
constexpr std::array kSpindleWords{3, 4, 5};
constexpr std::array kCoolantWords{7, 8, 9};
constexpr std::array kOutputWords{62, 63, 64, 65, 67, 68};

template <std::size_t Count>
bool contains(const std::array<int, Count>& words, int word) {
  return std::ranges::find(words, word) != words.end();
}

}  // namespace

ProgramReader::ProgramReader(const ReadOptions& options)
    : options_{options},
      compensation_{options.laser_mode, options.kerf_width},
      position_{options.start} {
  path_.start = path_.end = options.start;
}

void ProgramReader::read(std::string_view text) {
  ended_ = false;
  for (int number = 1; !text.empty() && !ended_; ++number) read_line(take_line(text), number);
}

void ProgramReader::note(std::string text) {
  if (path_.notes.size() > kMaxReadNotes) return;
  if (path_.notes.size() == kMaxReadNotes) text = "further notes are not listed";
  path_.notes.push_back({line_number_, std::move(text)});
}

// Reads a line in the order of RS274/NGC (NISTIR 6556, table 8).
void ProgramReader::read_line(std::string_view text, int number) {
  line_number_ = number;
  if (text.starts_with('$')) {
    options_.block_delete = block_delete_after(text, options_.block_delete);
    if (options_.on_statement) options_.on_statement(text);
    return;
  }
  const ProgramLine line = take_apart(text, options_.block_delete);
  for (const std::string& fault : line.faults) note(fault);
  const std::vector<int> single = modes_.apply_modes(line);
  apply_spindle(line);
  apply_outputs(line);
  apply_compensation(line);
  apply_tool_centre(line);
  const bool taken = apply_single(line, single);
  if (!taken) move(line);
  stop_or_end(line);
}

void ProgramReader::apply_spindle(const ProgramLine& line) {
  SpindleState state = spindle_;
  for (const int m : line.m) {
    if (m == 3) state = SpindleState::kConstant;
    if (m == 4) state = SpindleState::kDynamic;
    if (m == 5) state = SpindleState::kOff;
  }
  const double speed = line.value('S').value_or(spindle_speed_);
  const bool turning = spindle_ != SpindleState::kOff && speed != spindle_speed_;
  if (state != spindle_ || (turning && !options_.laser_mode)) stop_pending_ = true;
  spindle_ = state;
  spindle_speed_ = speed;
}

void ProgramReader::apply_outputs(const ProgramLine& line) {
  for (const int m : line.m) {
    if (m == kToolChangeWord) {
      stop_pending_ = true;
    } else if (contains(kCoolantWords, m)) {
      stop_pending_ = stop_pending_ || options_.stop_at_coolant;
    } else if (contains(kOutputWords, m)) {
      stop_pending_ = stop_pending_ || options_.stop_at_output;
    } else if (!contains(kSpindleWords, m) && !contains(kStopWords, m) &&
               !CutterCompensation::knows_m(m)) {
      note("M" + std::to_string(m) + " left out");
    }
  }
}

void ProgramReader::apply_compensation(const ProgramLine& line) {
  const double feed_mm_min = cnc::kSecondsPerMinute * modes_.feed(1.0, 0.0);
  const double before = compensation_.offset_mm();
  std::string left = compensation_.apply(line, modes_.scaled(0, 1.0), spindle_speed_, feed_mm_min);
  if (!left.empty()) note(std::move(left));
  const bool shifts = compensation_.by_kerf() && !options_.power_keeps_kerf;
  if (shifts && compensation_.offset_mm() != before) stop_pending_ = true;
  if (before == 0.0 || compensation_.offset_mm() != 0.0) return;
  leaves_edge_ = compensation_.by_kerf();
  is_beside_ = true;
}

/// Applies G43.4 and the words that end it. The machine is at rest; only the numbers of its
/// position change.
void ProgramReader::apply_tool_centre(const ProgramLine& line) {
  const bool begins = line.has_g(434);
  if (begins && !options_.tool_centre) note("G43.4 left out");
  if (!options_.tool_centre) return;
  const bool ends = line.has_g(431) || line.has_g(490);
  if (centre_length_ && (ends || (begins && *centre_length_ != modes_.tool_length()))) {
    switch_tool_centre(false, *centre_length_);
  }
  if (begins && !centre_length_) switch_tool_centre(true, modes_.tool_length());
}

void ProgramReader::switch_tool_centre(bool begins, double tool_length_mm) {
  position_ = options_.tool_centre(position_, tool_length_mm, begins);
  centre_length_.reset();
  if (begins) centre_length_ = tool_length_mm;
  path_.end = position_;
  stop_pending_ = true;
}

void ProgramReader::stop_or_end(const ProgramLine& line) {
  for (const int m : line.m) {
    if (m == 0 || (m == 1 && options_.optional_stop)) stop_pending_ = true;
    if (m != 2 && m != 30) continue;
    if (centre_length_) switch_tool_centre(false, *centre_length_);
    modes_.end_program();
    compensation_.end_program();
    spindle_ = SpindleState::kOff;
    stop_pending_ = ended_ = true;
  }
}

bool ProgramReader::apply_single(const ProgramLine& line, const std::vector<int>& numbers) {
  // G43.1 and G43.4 are modes, but they use the axis words.
  bool taken = line.has_g(431) || line.has_g(434);
  for (const int g : numbers) {
    if (g == 40) stop_pending_ = true;
    // ModalState::target() handles G53.
    if (g == 40 || g == 530 || CutterCompensation::knows_g(g)) continue;
    taken = true;
    if (!apply_home(line, g) && !apply_offset(line, g)) {
      note("G" + std::to_string(g / 10) + "." + std::to_string(g % 10) + " left out");
    }
  }
  return taken;
}

bool ProgramReader::apply_home(const ProgramLine& line, int g) {
  if (g == 280) go_by_way_to(line, first_home_);
  if (g == 281) first_home_ = position_;
  if (g == 300) go_by_way_to(line, second_home_);
  if (g == 301) second_home_ = position_;
  return g == 280 || g == 281 || g == 300 || g == 301;
}

bool ProgramReader::apply_offset(const ProgramLine& line, int g) {
  if (g == 100) {
    return compensation_.set_tool(line, modes_.scaled(0, 1.0)) ||
           modes_.set_coordinate_system(line, position_);
  }
  if (g == 920) modes_.set_shift(line, position_);
  if (g == 921) modes_.clear_shift();
  if (g == 922) modes_.suspend_shift();
  if (g == 923) modes_.restore_shift();
  return g >= 920 && g <= 923;
}

void ProgramReader::go_by_way_to(const ProgramLine& line, const Point& home) {
  if (!line.has_axis_words()) return move_straight(home, Travel::kRapid);
  move_straight(modes_.target(line, position_), Travel::kRapid);
  Point last = position_;
  for (std::size_t i = 0; i < cnc::kAxisCount; ++i) {
    if (line.value(cnc::kAxisLetters[i])) last[i] = home[i];
  }
  move_straight(last, Travel::kRapid);
}

void ProgramReader::move(const ProgramLine& line) {
  using Motion = ModalState::Motion;
  const Motion motion = modes_.motion();
  const bool round = motion == Motion::kClockwise || motion == Motion::kCounterClockwise;
  const bool centred = round && (modes_.centre(line, position_) || line.value('R'));
  if (motion == Motion::kNurbsEnd) return end_nurbs();
  const bool opens = line.has_g(52);
  if (motion == Motion::kNurbs && (opens || line.has_axis_words())) {
    return take_control_point(line, modes_.target(line, position_));
  }
  if (!line.has_axis_words() && !centred) return;
  const Point to = modes_.target(line, position_);
  switch (motion) {
    case Motion::kNone:
      return note("axis words without an active motion; left out");
    case Motion::kRapid:
      return move_straight(to, Travel::kRapid);
    case Motion::kLine:
      return line.powers.empty() ? move_straight(to, Travel::kFeed) : move_in_parts(line, to);
    case Motion::kCubic:
      return move_cubic(line, to);
    case Motion::kQuadratic:
      return move_quadratic(line, to);
    case Motion::kNurbs:
    case Motion::kNurbsEnd:
      return;
    case Motion::kProbe:
      return move_straight(to, Travel::kProbe);
    case Motion::kClockwise:
      return move_round(line, to, true);
    case Motion::kCounterClockwise:
      return move_round(line, to, false);
  }
}

void ProgramReader::move_straight(const Point& to, Travel travel) {
  // A probe begins and ends at rest.
  if (travel == Travel::kProbe) stop_pending_ = true;
  const Curve curve = Curve::line(position_, to);
  add_piece(curve, travel, modes_.feed(curve.linear_length(), rotary_distance(position_, to)));
  if (travel == Travel::kProbe) stop_pending_ = true;
}

/// Divides a motion into equal parts, one for each power of the line, and adds them. With G93, F
/// applies to the complete line.
void ProgramReader::move_in_parts(const ProgramLine& line, const Point& to) {
  const Point from = position_;
  const Curve whole = Curve::line(from, to);
  const double feed = modes_.feed(whole.linear_length(), rotary_distance(from, to));
  for (std::size_t i = 0; i < line.powers.size(); ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(line.powers.size());
    spindle_speed_ = line.powers[i];
    add_piece(Curve::line(position_, whole.point_at(share)), Travel::kFeed, feed);
  }
}

void ProgramReader::move_round(const ProgramLine& line, const Point& to, bool clockwise) {
  ProgrammedArc arc{position_, to, modes_.plane(), {}, clockwise, 1};
  const double turns = line.value('P').value_or(1.0);
  if (turns < 1.0 || turns > kMaxArcTurns || turns != std::floor(turns)) {
    return note("P is not a number of turns from 1 to 65535; the arc is left out");
  }
  arc.turns = static_cast<int>(turns);
  note_third_offset(line);
  const auto radius = line.value('R');
  if (radius && is_closed(arc)) return note("the arc with R ends at its start; left out");
  arc.centre = radius ? centre_from_radius(arc, modes_.scaled(0, *radius))
                      : modes_.centre(line, position_).value_or(std::array{0.0, 0.0});
  if (start_radius(arc) < kNoCircle) return note("the radius of the arc is 0; left out");
  const std::vector<Curve> pieces = pieces_of(arc);
  double length = 0.0;
  for (const Curve& piece : pieces) length += piece.linear_length();
  const double feed = modes_.feed(length, rotary_distance(position_, to));
  for (const Curve& piece : pieces) add_piece(piece, Travel::kFeed, feed);
}

/// Adds a note about a third offset, which is ignored, as in Grbl. Other controllers may read it as
/// the pitch of a helix.
void ProgramReader::note_third_offset(const ProgramLine& line) {
  constexpr std::array<char, 3> kOffsets{'I', 'J', 'K'};
  const char letter = kOffsets[cnc::axes_of(modes_.plane()).normal];
  if (line.value(letter).value_or(0.0) == 0.0) return;
  note(std::string{letter} + " is not in the plane of the arc and has no effect");
}

void ProgramReader::add_piece(const Curve& curve, Travel travel, double feed) {
  path_.end = position_ = curve.end();
  // After G40 the tool is still offset. A motion to its programmed position has no programmed
  // length, but leads back to the path.
  const bool nowhere = curve.length() <= 0.0;
  if (nowhere && !is_beside_) return;
  const cnc::PlaneAxes axes = cnc::axes_of(modes_.plane());
  const Point way = curve.end() - curve.start();
  is_beside_ = is_beside_ && !nowhere && way[axes.first] == 0.0 && way[axes.second] == 0.0;
  PathPiece piece{curve,
                  travel,
                  feed,
                  spindle_speed_,
                  spindle_,
                  line_number_,
                  stop_pending_,
                  modes_.tolerance(options_.path_tolerance, options_.arc_tolerance)};
  piece.tolerance.spline = spline_tolerance_;
  const double offset = compensation_.offset_mm();
  if (offset != 0.0) piece.beside = {offset, modes_.plane()};
  const bool by_kerf = offset != 0.0 ? compensation_.by_kerf() : leaves_edge_;
  leaves_edge_ = false;
  const bool keeps_kerf = by_kerf && options_.power_keeps_kerf;
  if (keeps_kerf && spindle_ == SpindleState::kConstant) piece.spindle = SpindleState::kDynamic;
  stop_pending_ = false;
  if (options_.on_piece) return options_.on_piece(piece);
  path_.pieces.push_back(piece);
}

}  // namespace sim
