#include "host-sim/job/program_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planner/base/units.hpp"

namespace sim {
namespace {

/// Greatest relative difference between feeds that count as equal, because of rounding.
constexpr double kRounding = 1.0e-6;

/// Returns a number as text, with at most three decimals and without trailing zeros.
std::string plain(double value) {
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

bool has_m(const ProgramLine& words, int number) {
  return std::ranges::find(words.m, number) != words.m.end();
}

/// Adds a value to a list of reported values. Returns false if the list already contains the value,
/// or is full.
bool is_news(std::vector<double>& listed, double value) {
  if (listed.size() >= ProgramWatch::kMaxNotes) return false;
  const bool known = std::ranges::any_of(
      listed, [value](double other) { return std::abs(value - other) <= kRounding * value; });
  if (!known) listed.push_back(value);
  return !known;
}

}  // namespace

ProgramWatch::ProgramWatch(const cnc::Settings& settings)
    : max_power_{static_cast<double>(settings.get(cnc::setting::kMaxSpindleSpeed))},
      laser_{settings.get(cnc::setting::kLaserMode) != 0.0F},
      burns_at_rest_{settings.get(cnc::setting::kRestLightDuty) > 0.0F &&
                     settings.get(cnc::setting::kRestLightTime) > 0.0F},
      soft_limits_{settings.get(cnc::setting::kSoftLimits) != 0.0F},
      block_delete_{settings.get(cnc::setting::kBlockDelete) != 0.0F} {
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    rates_[axis] = static_cast<double>(settings.get(cnc::setting::kRate, axis)) /
                   static_cast<double>(cnc::kSecondsPerMinute);
  }
}

/// Most lines have only axis words. A check for other letters avoids the cost of dividing such
/// lines into words.
void ProgramWatch::take(std::size_t line, std::string_view text) {
  const std::size_t front = text.find_first_not_of(" \t");
  if (front == std::string_view::npos) return;
  if (text[front] == '$') {
    block_delete_ = block_delete_after(text, block_delete_);
    homed_ = homed_ || text.substr(front).starts_with("$H") || text.substr(front).starts_with("$h");
    return;
  }
  if (text.find_first_of("SsMmPpFf") == std::string_view::npos) return;
  take_words(line, take_apart(text, block_delete_));
}

/// Processes the words of a line in the order in which a controller executes them: S, M3 to M5,
/// dwell, motion, stop.
void ProgramWatch::take_words(std::size_t line, const ProgramLine& words) {
  if (const auto power = words.value('S')) {
    check_power(line, *power);
    for (const double part : words.powers) check_power(line, part);
    power_ = words.powers.empty() ? *power : words.powers.back();
  }
  if (const auto feed = words.value('F')) {
    feeds_.push_back({line, *feed});
    if (feeds_.size() > kMaxPending) feeds_.pop_front();
  }
  take_spindle(line, words);
  take_dwell(line, words);
  const bool ends = has_m(words, 2) || has_m(words, 30);
  if (ends || has_m(words, 0) || has_m(words, 6)) go_dark();
  if (ends) constant_ = false;
}

void ProgramWatch::take_spindle(std::size_t line, const ProgramLine& words) {
  const bool was_lit = lit();
  if (has_m(words, 3)) constant_ = true;
  if (has_m(words, 4) || has_m(words, 5)) constant_ = false;
  if (!lit()) return go_dark();
  if (!was_lit || has_m(words, 3)) lit_line_ = line;
}

void ProgramWatch::take_dwell(std::size_t line, const ProgramLine& words) {
  if (!words.has_g(40) || words.value('P').value_or(0.0) <= 0.0 || !lit()) return;
  note(line, "the beam is off during this dwell: under M3 nothing burns at rest");
  notes_light_at_rest_ = true;
  lit_line_ = 0;
}

void ProgramWatch::check_power(std::size_t line, double power) {
  if (power <= max_power_ || !is_news(powers_listed_, power)) return;
  note(line,
       fmt::format("S{} is above ${}={} and gives no more than that",
                   plain(power),
                   cnc::setting::kMaxSpindleSpeed,
                   plain(max_power_)));
}

void ProgramWatch::put(const PathPiece& piece) {
  if (soft_limits_ && !homed_) {
    note(static_cast<std::size_t>(piece.line),
         "soft limits ($20) guard homed axes only: home the machine ($H) before this program");
    homed_ = true;
  }
  if (piece.travel != Travel::kFeed) return;
  if (piece.spindle != SpindleState::kOff) lit_line_ = 0;
  check_feed(piece);
}

/// Returns the beginning of a note about a feed: the word F of the program and, if its number
/// differs, the feed in mm/min or degrees/min. The number differs in inches (G20) and inverse time
/// (G93).
std::string ProgramWatch::feed_text(const PathPiece& piece, std::size_t axis) const {
  const double feed = piece.feed * static_cast<double>(cnc::kSecondsPerMinute);
  const auto line = static_cast<std::size_t>(std::max(piece.line, 0));
  const auto found = std::find_if(
      feeds_.rbegin(), feeds_.rend(), [line](const Feed& word) { return word.line <= line; });
  const char* const unit = axis < cnc::kLinearAxisCount ? "mm/min" : "degrees/min";
  if (found == feeds_.rend()) return fmt::format("the feed of {} {} is", plain(feed), unit);
  const bool is_same = std::abs(found->word - feed) <= kRounding * feed;
  if (is_same) return fmt::format("F{} is", plain(found->word));
  return fmt::format("F{} requires {} {} here,", plain(found->word), plain(feed), unit);
}

/// Adds a note about the first axis whose rate the piece exceeds. An arc may have any direction in
/// its plane.
void ProgramWatch::check_feed(const PathPiece& piece) {
  const Point run = piece.curve.end() - piece.curve.start();
  const double length = piece.curve.linear_length();
  const double whole = length > 0.0 ? length : piece.curve.length();
  if (whole <= 0.0) return;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    double share = std::abs(run[axis]) / whole;
    if (const auto& circle = piece.curve.circle()) {
      const auto axes = cnc::axes_of(circle->plane);
      if (axis == axes.first || axis == axes.second) share = 1.0;
    }
    if (piece.feed * share <= rates_[axis] * (1.0 + kRounding)) continue;
    if (!is_news(feeds_listed_, piece.feed)) return;
    const double minute = static_cast<double>(cnc::kSecondsPerMinute);
    return note(static_cast<std::size_t>(piece.line),
                fmt::format("{} above ${}={}, the rate of {}: driven more slowly",
                            feed_text(piece, axis),
                            cnc::setting::kRate + axis,
                            plain(rates_[axis] * minute),
                            cnc::kAxisLetters[axis]));
  }
}

/// Ends the light. Adds a note if there was no motion since the light began, as with light for a
/// focus dot.
void ProgramWatch::go_dark() {
  if (lit_line_ != 0) {
    note(lit_line_, "M3 is on here and off again without a motion: nothing burns at rest");
    notes_light_at_rest_ = true;
  }
  lit_line_ = 0;
}

void ProgramWatch::note(std::size_t line, std::string text) {
  if (notes_.size() > kMaxNotes) return;
  if (notes_.size() == kMaxNotes) text = "further notes of this kind are not listed";
  notes_.push_back({line, 0, std::move(text)});
}

std::vector<LineNote> ProgramWatch::notes() const {
  std::vector<LineNote> sorted = notes_;
  std::ranges::stable_sort(sorted, {}, &LineNote::line);
  return sorted;
}

}  // namespace sim
