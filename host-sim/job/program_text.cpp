#include "host-sim/job/program_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "firmware/link/line_check.hpp"
#include "firmware/link/realtime_byte.hpp"
#include "host-sim/job/program_marks.hpp"
#include "host-sim/measure/program_line.hpp"
#include "planner/gcode/block.hpp"
#include "planner/gcode/line_reader.hpp"

namespace sim {
namespace {

/// Greatest number of wrong checks that are listed for one file.
constexpr std::size_t kMaxWrongChecks = 1000;

/// The parts of one kind that were left out of a program: their number, and a note with the
/// position of the first part.
struct Finding {
  LineNote first{};
  std::size_t count = 0;

  void add(std::size_t line, std::size_t column, std::string_view text) {
    if (count++ == 0) first = {line, column, std::string{text}};
  }
};

/// Returns the number of bytes that follow `lead`, the first byte of a character in UTF-8. A
/// controller counts them in the same way.
unsigned continuations_after(unsigned char lead) {
  if (lead >= 0xF0) return lead < 0xF8 ? 3 : 0;
  if (lead >= 0xE0) return 2;
  return lead >= 0xC2 ? 1 : 0;
}

bool is_continuation(unsigned char byte) { return (byte & 0xC0U) == 0x80U; }

class Preparation {
 public:
  Preparation(std::string file, bool block_delete)
      : text_{std::move(file)}, block_delete_{block_delete} {}

  ProgramText run() {
    if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff")) {
      return {{}, {}, {{1, 0, "the file is UTF-16: save it as UTF-8"}}, false};
    }
    drop_mark();
    for (std::size_t at = 0; at < text_.size();) {
      ++line_;
      const std::size_t end = std::min(text_.find_first_of("\r\n", at), text_.size());
      prepare({text_.data() + at, end - at});
      const bool pair = end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n';
      at = end + (pair ? 2 : 1);
    }
    return {std::move(text_), notes(), std::move(faults_)};
  }

 private:
  enum Kind : std::uint8_t {
    kMark,
    kControl,
    kAtOnce,
    kForeign,
    kChecks,
    kCounting,
    kSlash,
    kDriven,
    kSecond,
    kRest
  };
  static constexpr std::size_t kKinds = 10;

  void drop_mark() {
    const std::size_t rest = cnc::gcode::without_mark(text_).size();
    if (rest == text_.size()) return;
    text_.erase(0, text_.size() - rest);
    found_[kMark].add(1, 0, "a byte order mark is left out");
  }

  void prepare(std::span<char> line) {
    blank_bytes(line);
    if (end_line_ != 0) return blank_rest(line);
    const std::string_view text{line.data(), line.size()};
    const std::size_t front = text.find_first_not_of(" \t");
    block_delete_ = block_delete_after(text, block_delete_);
    if (front == std::string_view::npos || text[front] == '$') return;
    if (const auto note = marks_.take(line_, text)) found_[kSecond].add(line_, 0, *note);
    take_check(line);
    if (text.find('/') != std::string_view::npos) note_slash(text);
    if (text.find_first_of("Mm") != std::string_view::npos && ends_program(text)) end_line_ = line_;
  }

  static void blank(std::span<char> line, std::size_t from, std::size_t count) {
    std::ranges::fill(line.subspan(from, count), ' ');
  }

  /// Replaces by blanks, outside of comments, the bytes on which a controller would act immediately
  /// or which it would drop.
  void blank_bytes(std::span<char> line) {
    char closing = ' ';
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      if (closing != ' ') {
        if (c == closing) closing = ' ';
        continue;
      }
      const auto byte = static_cast<unsigned char>(c);
      if (c == ';') return;
      if (c == '(') closing = ')';
      if (byte >= 0x80) {
        i += pass_high(line, i);
      } else if (cnc::is_ascii_realtime(byte)) {
        found_[kAtOnce].add(line_, i + 1, at_once_text(byte));
        line[i] = ' ';
      } else if (c != '\t' && byte < ' ') {
        found_[kControl].add(line_, i + 1, fmt::format("control byte 0x{:02X} is left out", byte));
        line[i] = ' ';
      }
    }
  }

  static std::string at_once_text(unsigned char byte) {
    const std::string shown = byte < ' ' ? fmt::format("byte 0x{:02X}", byte)
                                         : fmt::format("'{}'", static_cast<char>(byte));
    return shown + " is a command that acts immediately: it is left out of the program";
  }

  /// Replaces the character at index `at` by blanks if a controller would not accept the character
  /// unchanged. Returns the number of bytes of the character after the first one.
  std::size_t pass_high(std::span<char> line, std::size_t at) {
    const auto byte = static_cast<unsigned char>(line[at]);
    if (is_continuation(byte)) {
      found_[kForeign].add(line_, at + 1, fmt::format("byte 0x{:02X} is read as a blank", byte));
      line[at] = ' ';
      return 0;
    }
    std::size_t more = 0;
    while (more < continuations_after(byte) && at + more + 1 < line.size() &&
           is_continuation(static_cast<unsigned char>(line[at + more + 1]))) {
      ++more;
    }
    // The character stays in the text, because the controller refuses it and reports its column.
    if (byte != 0xC2 || more != 1) return more;
    const auto code = static_cast<unsigned char>(line[at + 1]);
    const char* const name = code == 0xA0 ? "a no-break space" : "a character";
    found_[kForeign].add(
        line_, at + 1, fmt::format("{} (U+{:04X}) is read as a blank", name, code));
    blank(line, at, 2);
    return 1;
  }

  void take_check(std::span<char> line) {
    const std::string_view text{line.data(), line.size()};
    const auto mark = cnc::find_mark(text);
    const std::size_t star = mark ? mark->covered.size() : text.size();
    if (mark && mark->form() == cnc::LineMark::Form::kNone) {
      if (faults_.size() < kMaxWrongChecks) {
        faults_.push_back({line_, star + 1, "the check does not match its line"});
      }
      return;
    }
    if (mark) {
      found_[kChecks].add(line_, star + 1, "the checks of lines are correct, and are left out");
      blank(line, star, 1 + mark->digits.size());
      blank_number_of_statement(line);
    }
    if (!counts_anew(text)) return;
    found_[kCounting].add(line_, 0, "M110 is for senders that repeat lines: it is left out");
    blank(line, 0, line.size());
  }

  /// Replaces the word N of a line such as `N5 $G` by blanks. A controller accepts a number before
  /// a statement only if the line has a check.
  static void blank_number_of_statement(std::span<char> line) {
    const std::string_view text{line.data(), line.size()};
    const std::size_t dollar = text.find('$');
    if (dollar == std::string_view::npos) return;
    const std::string_view before = text.substr(0, dollar);
    const bool number = before.find_first_not_of("Nn0123456789 \t") == std::string_view::npos;
    if (number) blank(line, 0, dollar);
  }

  /// Returns whether a line consists of M110 and, optionally, words N.
  static bool counts_anew(std::string_view text) {
    constexpr std::uint32_t kCountAnew = 110;
    if (text.find("110") == std::string_view::npos) return false;
    cnc::gcode::LineReader reader{text};
    cnc::gcode::Word word{};
    if (reader.begin(false)) return false;
    bool found = false;
    while (!reader.at_end()) {
      if (reader.read(word)) return false;
      const bool counts =
          word.letter == 'M' && word.value.is_integer() && word.value.whole == kCountAnew;
      if (!counts && word.letter != 'N') return false;
      found = found || counts;
    }
    return found;
  }

  void note_slash(std::string_view text) {
    const std::size_t slash = text.find('/');
    const std::string_view before = text.substr(0, slash);
    const bool at_front = before.find_first_not_of("Nn0123456789 \t") == std::string_view::npos;
    if (!at_front) return;
    if (block_delete_) {
      found_[kSlash].add(line_, slash + 1, "lines that begin with / are skipped ($890, $B)");
    } else {
      found_[kDriven].add(line_, slash + 1, "lines that begin with / are driven ($890=0)");
    }
  }

  [[nodiscard]] bool ends_program(std::string_view text) const {
    cnc::gcode::LineReader reader{text};
    cnc::gcode::Word word{};
    if (reader.begin(block_delete_)) return false;
    bool ends = false;
    for (bool first = true; !reader.at_end(); first = false) {
      if (reader.read(word)) return false;
      if (first && word.letter == 'N' && reader.pass_slash_after_number(block_delete_))
        return false;
      const bool end = word.value == cnc::gcode::Decimal{.whole = 2} ||
                       word.value == cnc::gcode::Decimal{.whole = 30};
      ends = ends || (word.letter == 'M' && end);
    }
    return ends;
  }

  void blank_rest(std::span<char> line) {
    cnc::gcode::Block block;
    const bool nothing =
        !cnc::gcode::read_block({line.data(), line.size()}, block_delete_, block) && block.empty();
    if (!nothing) {
      found_[kRest].add(
          line_,
          0,
          fmt::format("the program ended in line {}: nothing from here on is driven", end_line_));
    }
    blank(line, 0, line.size());
  }

  [[nodiscard]] std::vector<LineNote> notes() const {
    std::vector<LineNote> notes;
    for (const Finding& found : found_) {
      if (found.count == 0) continue;
      notes.push_back(found.first);
      if (found.count > 1) notes.back().text += fmt::format("; {} times in all", found.count);
    }
    std::ranges::stable_sort(notes, {}, &LineNote::line);
    return notes;
  }

  std::string text_;
  bool block_delete_;  ///< True if lines with `/` are skipped. The program may change this value.
  ProgramMarks marks_;
  std::size_t line_ = 0;
  std::size_t end_line_ = 0;  ///< Line of the M2 or M30 that ends the program; 0 if there was none.
  std::array<Finding, kKinds> found_{};
  std::vector<LineNote> faults_;
};

}  // namespace

ProgramText prepare_program(std::string file, bool block_delete) {
  return Preparation{std::move(file), block_delete}.run();
}

std::string place_and_text(const std::string& file, const LineNote& note) {
  if (note.column == 0) return fmt::format("{}:{}: {}", file, note.line, note.text);
  return fmt::format("{}:{}:{}: {}", file, note.line, note.column, note.text);
}

}  // namespace sim
