#include "host-sim/surface/probe_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <map>
#include <stdexcept>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::surface {
namespace {

constexpr std::string_view kFirstLine = "(kerfline probe-grid 1)";
constexpr std::string_view kFirstWords = "(kerfline probe-grid ";

/// Assumed time in which a tip stops after a contact. Half of the time is for braking from 12 mm/s
/// with 250 mm/s². The other half is for motion that the controller has already planned.
constexpr double kStopS = 0.05;

struct NamedValue {
  const char* name;
  double value;
};

void require_above_0(std::initializer_list<NamedValue> values, const char* unit) {
  for (const auto& [name, value] : values) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw std::invalid_argument(fmt::format("{} {:g}: must be above 0 {}", name, value, unit));
  }
}

/// Returns the text of a coordinate or a feed, with at most four decimals.
std::string number(double value) {
  std::string text = fmt::format("{:.4f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

/// Writes the G-code of a program point by point.
class ProbeText {
 public:
  explicit ProbeText(const ProbeProgram& program)
      : program_{program},
        depth_{number(program.depth_mm)},
        safe_{number(program.safe_mm)},
        feed_{number(program.feed)},
        fast_feed_{number(program.fast_feed)},
        retract_{number(program.retract_mm)},
        hop_{number(program.hop_mm)},
        travel_feed_{number(program.travel_feed)} {}

  std::string text() {
    add_heading();
    add("M5\nG21 G90 G17 G94\nG0 Z{}\n", safe_);
    for (std::size_t turn = 0; turn < program_.grid.size(); ++turn) {
      add_way(program_.grid.place(program_.grid.driven(turn)), turn == 0);
      add_touch();
    }
    add("G0 Z{}\nM2\n", safe_);
    return fmt::to_string(buffer_);
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
  }

  void add_heading() {
    const ProbeProgram& p = program_;
    add("{}\n(x={}:{} columns={})\n", kFirstLine, p.grid.x.from_mm, p.grid.x.to_mm, p.grid.x.count);
    add("(y={}:{} rows={})\n", p.grid.y.from_mm, p.grid.y.to_mm, p.grid.y.count);
    add("(pitch X {} mm, Y {} mm)\n", number(p.grid.x.pitch_mm()), number(p.grid.y.pitch_mm()));
    add("(order: rows along X as a serpentine, from the least X and Y)\n");
    add("(safe={} depth={} feed={})\n", p.safe_mm, p.depth_mm, p.feed);
    if (p.fast_feed > 0.0) add("(fast-feed={} retract={})\n", p.fast_feed, p.retract_mm);
    if (p.hop_mm > 0.0) add("(hop={} travel-feed={})\n", p.hop_mm, p.travel_feed);
    add("(touches={} tip={})\n", p.touches(), p.tip_mm);
  }

  void add_way(const Eigen::Vector2d& to, bool is_first) {
    const std::string x = number(to.x());
    const std::string y = number(to.y());
    if (is_first) {
      add("G0 X{} Y{}\n", x, y);
    } else if (program_.hop_mm > 0.0) {
      add("G91 G0 Z{}\nG90 G38.3 X{} Y{} F{}\nG91 G0 Z{}\nG90\n", hop_, x, y, travel_feed_, hop_);
    } else {
      add("G0 Z{}\nG0 X{} Y{}\n", safe_, x, y);
    }
  }

  void add_touch() {
    if (program_.touches() > 1) {
      add("G38.3 Z{} F{}\nG91 G0 Z{}\nG90\n", depth_, fast_feed_, retract_);
    }
    add("G38.3 Z{} F{}\n", depth_, feed_);
  }

  const ProbeProgram& program_;
  std::string depth_;
  std::string safe_;
  std::string feed_;
  std::string fast_feed_;
  std::string retract_;
  std::string hop_;
  std::string travel_feed_;
  fmt::memory_buffer buffer_;
};

/// Words `name=value` in the comments after the first line, by name.
using Words = std::map<std::string, std::string, std::less<>>;

void add_words(std::string_view comment, Words& words) {
  TextWords found{comment, 1};
  for (std::string_view word = found.next(); !word.empty(); word = found.next()) {
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos) continue;
    words.emplace(word.substr(0, equals), word.substr(equals + 1));
  }
}

Words heading_words(std::string_view text, const std::string& name) {
  TextLines lines{text};
  auto line = lines.next();
  while (line && !line->starts_with(kFirstWords)) line = lines.next();
  if (!line) {
    refuse(name, 0, "has no heading of a probing program", "name the file that probe-grid wrote");
  }
  if (*line != kFirstLine) {
    refuse(name,
           lines.number(),
           "the heading is from another version of kerfline",
           "use this version");
  }
  Words words;
  for (line = lines.next(); line && line->starts_with('(') && line->ends_with(')');
       line = lines.next()) {
    add_words(line->substr(1, line->size() - 2), words);
  }
  return words;
}

/// Reads the words of a heading as numbers.
class HeadingReader {
 public:
  HeadingReader(const Words& words, const std::string& name) : words_{words}, name_{name} {}

  [[nodiscard]] std::string_view word(const char* key) const {
    const auto found = words_.find(key);
    if (found == words_.end()) damaged(key);
    return found->second;
  }
  [[nodiscard]] double number(const char* key) const { return number(key, word(key)); }
  [[nodiscard]] std::size_t count(const char* key) const {
    const auto value = parsed_count(word(key));
    if (!value) damaged(key);
    return *value;
  }
  [[nodiscard]] ProbeSpan span(const char* key, const char* count_key) const {
    const std::string_view value = word(key);
    const std::size_t colon = value.find(':');
    if (colon == std::string_view::npos) damaged(key);
    return {.from_mm = number(key, value.substr(0, colon)),
            .to_mm = number(key, value.substr(colon + 1)),
            .count = count(count_key)};
  }
  [[nodiscard]] bool has(const char* key) const { return words_.contains(key); }
  [[noreturn]] void damaged(const char* key) const {
    refuse(name_,
           0,
           fmt::format("`{}=` is missing in the heading, or is damaged", key),
           "name the file that probe-grid wrote");
  }

 private:
  [[nodiscard]] double number(const char* key, std::string_view text) const {
    const auto value = parsed_number(text);
    if (!value || !std::isfinite(*value)) damaged(key);
    return *value;
  }

  const Words& words_;
  const std::string& name_;
};

}  // namespace

void require_probe_program(const ProbeProgram& program) {
  require_probe_grid(program.grid);
  require_above_0({{"--feed", program.feed}}, "mm/min");
  if (!(std::abs(program.safe_mm) <= kFarthestMm && std::abs(program.depth_mm) <= kFarthestMm)) {
    throw std::invalid_argument(
        fmt::format("--safe {:g}, --depth {:g}: beyond {:g} mm; check the unit",
                    program.safe_mm,
                    program.depth_mm,
                    kFarthestMm));
  }
  if (!(program.safe_mm > program.depth_mm)) {
    throw std::invalid_argument(
        fmt::format("--safe {:g}: must be above --depth {:g}, because the tool probes downwards",
                    program.safe_mm,
                    program.depth_mm));
  }
  if (program.fast_feed != 0.0) {
    require_above_0({{"--fast-feed", program.fast_feed}}, "mm/min");
    require_above_0({{"--retract", program.retract_mm}}, "mm");
    if (program.fast_feed <= program.feed) {
      throw std::invalid_argument(fmt::format(
          "--fast-feed {:g}: must be above --feed {:g}", program.fast_feed, program.feed));
    }
  }
  if (program.hop_mm != 0.0) {
    require_above_0({{"--hop", program.hop_mm}}, "mm");
    require_above_0({{"--travel-feed", program.travel_feed}}, "mm/min");
  }
  if (!(program.tip_mm >= 0.0 && program.tip_mm <= kFarthestMm)) {
    throw std::invalid_argument(
        fmt::format("--tip {:g}: a diameter is 0 mm or more", program.tip_mm));
  }
}

std::vector<std::string> warnings_of(const ProbeProgram& program) {
  std::vector<std::string> warnings;
  const auto check = [&](const char* option, double rise_mm, double feed) {
    const double way_mm = feed / 60.0 * kStopS;
    if (rise_mm >= way_mm) return;
    warnings.push_back(fmt::format(
        "{} {:g}: the tip may need {:g} mm at {:g} mm/min to stop after a contact, and the program "
        "would end with alarm 4; rise by more, or probe more slowly",
        option,
        rise_mm,
        way_mm,
        feed));
  };
  if (program.fast_feed > 0.0) check("--retract", program.retract_mm, program.fast_feed);
  if (program.hop_mm > 0.0) {
    check("--hop", program.hop_mm, std::max(program.travel_feed, program.feed));
  }
  return warnings;
}

std::string text_of_probe_program(const ProbeProgram& program) { return ProbeText{program}.text(); }

ProbeHeading heading_of(const ProbeProgram& program) {
  return {.grid = program.grid,
          .depth_mm = program.depth_mm,
          .touches = program.touches(),
          .tip_mm = program.tip_mm,
          .has_guards = program.hop_mm > 0.0};
}

ProbeHeading read_probe_heading(std::string_view text, const std::string& name) {
  const Words words = heading_words(text, name);
  const HeadingReader reader{words, name};
  const ProbeHeading heading{
      .grid = {.x = reader.span("x", "columns"), .y = reader.span("y", "rows")},
      .depth_mm = reader.number("depth"),
      .touches = reader.count("touches"),
      .tip_mm = reader.number("tip"),
      .has_guards = reader.has("hop")};
  if (heading.touches < 1 || heading.touches > 2) reader.damaged("touches");
  if (heading.tip_mm < 0.0) reader.damaged("tip");
  try {
    require_probe_grid(heading.grid);
  } catch (const std::invalid_argument& error) {
    refuse(name, 0, error.what(), "name the file that probe-grid wrote");
  }
  return heading;
}

}  // namespace sim::surface
