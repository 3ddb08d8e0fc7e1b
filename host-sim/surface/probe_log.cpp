#include "host-sim/surface/probe_log.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::surface {
namespace {

constexpr std::size_t kMaxAxes = 8;
constexpr std::string_view kAnswer = "[PRB:";
constexpr std::string_view kWorkOffset = "WCO:";

/// Returns the first three numbers of a list of finite numbers that are separated by commas.
/// Returns nothing if the text is not such a list or does not have three to kMaxAxes numbers.
std::optional<Eigen::Vector3d> parsed_place(std::string_view text) {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  while (count < kMaxAxes) {
    const std::size_t comma = text.find(',');
    const auto value = parsed_number(text.substr(0, comma));
    if (!value || !std::isfinite(*value)) return {};
    if (count < 3) {
      if (std::abs(*value) > kFarthestMm) return {};
      place[static_cast<Eigen::Index>(count)] = *value;
    }
    ++count;
    if (comma == std::string_view::npos) {
      return count >= 3 ? std::optional{place} : std::nullopt;
    }
    text.remove_prefix(comma + 1);
  }
  return {};
}

struct KnownOffset {
  Eigen::Vector3d offset;
  std::size_t line;
};

/// Reads a log line by line.
class LogReader {
 public:
  explicit LogReader(double unit_mm) : unit_mm_{unit_mm} {}

  void take(std::string_view line, std::size_t number) {
    take_answers(line, number);
    take_work_offset(line, number);
    take_listing(line, number);
  }

  ProbeLog result() {
    if (work_offsets_.empty()) {
      take_listed_offset();
    } else {
      choose_work_offset();
    }
    return std::move(log_);
  }

 private:
  void take_answers(std::string_view line, std::size_t number) {
    for (std::size_t from = line.find(kAnswer); from != std::string_view::npos;
         from = line.find(kAnswer, from + 1)) {
      const std::string_view rest = line.substr(from + kAnswer.size());
      const std::string_view body = rest.substr(0, rest.find(']'));
      const bool is_whole = body.size() < rest.size() && body.size() > 2 &&
                            (body.ends_with(":0") || body.ends_with(":1"));
      const auto place = is_whole ? parsed_place(body.substr(0, body.size() - 2)) : std::nullopt;
      if (place) {
        log_.answers.push_back(
            {.place = *place * unit_mm_, .is_touch = body.back() == '1', .line = number});
      } else {
        log_.damaged_lines.push_back(number);
      }
    }
  }

  void take_work_offset(std::string_view line, std::size_t number) {
    const std::size_t open = line.find('<');
    const std::size_t from = line.find(kWorkOffset, open);
    if (open == std::string_view::npos || from == std::string_view::npos) return;
    const std::string_view rest = line.substr(from + kWorkOffset.size());
    const std::size_t end = rest.find_first_of("|>");
    if (end == std::string_view::npos) return;
    const auto offset = parsed_place(rest.substr(0, end));
    if (!offset) return;
    const Eigen::Vector3d value = *offset * unit_mm_;
    if (work_offsets_.empty() || work_offsets_.back().offset != value) {
      work_offsets_.push_back({value, number});
    }
  }

  /// Stores the offsets of a `$#` listing, for example `[G54:x,y,z]`, and the active coordinate
  /// system of a `[GC:…]` line.
  void take_listing(std::string_view line, std::size_t number) {
    const std::size_t open = line.find('[');
    if (open == std::string_view::npos) return;
    line = line.substr(open + 1);
    const std::size_t colon = line.find(':');
    const std::size_t end = line.find(']');
    if (colon == std::string_view::npos || end == std::string_view::npos || colon > end) return;
    const std::string_view key = line.substr(0, colon);
    const std::string_view value = line.substr(colon + 1, end - colon - 1);
    if (key == "GC") return take_modes(value);
    if (key == "TLO") return take_tool_length(value);
    const bool is_place = key == "G92" || (key.starts_with("G5") && key.size() >= 3);
    const auto place = is_place ? parsed_place(value) : std::nullopt;
    if (!place) return;
    listed_[std::string{key}] = *place * unit_mm_;
    log_.offset_line = number;
  }

  void take_modes(std::string_view modes) {
    TextWords words{modes, 1};
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      const bool is_system = word.size() >= 3 && word.starts_with("G5") && word[2] >= '4';
      if (is_system) system_ = word;
    }
  }

  /// Stores the tool length. Grbl lists one length, along Z; grblHAL lists a length for each axis.
  void take_tool_length(std::string_view value) {
    Eigen::Vector3d length = Eigen::Vector3d::Zero();
    if (const auto place = parsed_place(value)) {
      length = *place;
    } else if (const auto along_z = parsed_number(value); along_z && std::isfinite(*along_z)) {
      length.z() = *along_z;
    }
    listed_["TLO"] = length * unit_mm_;
  }

  void take_listed_offset() {
    const auto system = listed_.find(system_);
    if (system == listed_.end()) return;
    log_.offset = system->second;
    for (const char* key : {"G92", "TLO"}) {
      const auto found = listed_.find(key);
      if (found != listed_.end()) *log_.offset += found->second;
    }
  }

  /// Sets the log's offset to the offset at the first answer. Also finds the first line between the
  /// first and the last answer at which the offset changes.
  void choose_work_offset() {
    const std::size_t begin = log_.answers.empty() ? 0 : log_.answers.front().line;
    const std::size_t end = log_.answers.empty() ? 0 : log_.answers.back().line;
    auto chosen = work_offsets_.begin();
    for (auto it = chosen; it != work_offsets_.end() && it->line <= begin; ++it) chosen = it;
    log_.offset = chosen->offset;
    log_.offset_line = chosen->line;
    const auto next = chosen + 1;
    if (next != work_offsets_.end() && next->line <= end) log_.changed_line = next->line;
  }

  double unit_mm_;
  ProbeLog log_{};
  /// Offsets in status reports, with an entry for each change.
  std::vector<KnownOffset> work_offsets_;
  std::map<std::string, Eigen::Vector3d, std::less<>> listed_;
  std::string system_ = "G54";
};

}  // namespace

ProbeLog read_probe_log(std::string_view text, double unit_mm) {
  LogReader reader{unit_mm};
  TextLines lines{text};
  while (const auto line = lines.next()) reader.take(*line, lines.number());
  return reader.result();
}

}  // namespace sim::surface
