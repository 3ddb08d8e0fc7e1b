#include "host-sim/import/dxf_mtext.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "host-sim/text/utf8.hpp"

namespace sim::drawing {
namespace {

/// Removes a code that begins with two percent signs from the front of `rest`, and appends the
/// character that the code stands for.
void take_percent_code(std::string_view& rest, DxfWords& words) {
  const char code = static_cast<char>(rest[2] >= 'A' && rest[2] <= 'Z' ? rest[2] + 32 : rest[2]);
  std::size_t size = 3;
  if (code == 'c') {
    words.text += "\u00D8";
  } else if (code == 'd') {
    words.text += "\u00B0";
  } else if (code == 'p') {
    words.text += "\u00B1";
  } else if (code == '%') {
    words.text += '%';
  } else if (code == 'u' || code == 'o' || code == 'k') {
    words.has_lines = true;
  } else if (code >= '0' && code <= '9') {
    unsigned letter = 0;
    const std::string_view digits = rest.substr(2, 3);
    const auto [stop, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), letter);
    size = 2 + static_cast<std::size_t>(stop - digits.data());
    // This function does not know the code page. Only ASCII characters are equal in all code pages.
    const bool is_known = letter >= 0x20U && letter < 0x7FU;
    if (is_known) words.text += static_cast<char>(letter);
    words.has_unknown = words.has_unknown || !is_known;
  } else {
    words.text += rest.substr(0, 2);
    size = 2;
  }
  rest.remove_prefix(size);
}

bool is_percent_code(std::string_view rest) { return rest.size() > 2 && rest.starts_with("%%"); }

/// Reads the coded text of a MTEXT, and divides it into paragraphs.
class MtextReader {
 public:
  explicit MtextReader(LetterLine& line) : line_{line}, height_{line.size} {}

  MtextWords read(std::string_view rest) {
    while (!rest.empty()) {
      if (rest.front() == '\\' && rest.size() > 1) {
        take_code(rest);
      } else if (rest.front() == '{' || rest.front() == '}') {
        enter(rest.front() == '{' ? 1 : -1);
        rest.remove_prefix(1);
      } else if (rest.front() == '^' && rest.size() > 1) {
        take_control(rest);
      } else if (is_percent_code(rest)) {
        DxfWords words;
        take_percent_code(rest, words);
        if (words.has_lines) leave_out("%%u");
        if (words.has_unknown) leave_out("%%nnn");
        append(words.text);
      } else {
        append(rest.substr(0, 1));
        rest.remove_prefix(1);
      }
    }
    paragraphs_.push_back(std::move(paragraph_));
    return {std::move(paragraphs_), std::move(unfollowed_)};
  }

 private:
  void append(std::string_view letters) {
    if (has_ended_ && !letters.empty()) leave_out("{}");
    has_letters_ = has_letters_ || !letters.empty();
    paragraph_ += letters;
  }
  void end_paragraph() { paragraphs_.push_back(std::exchange(paragraph_, {})); }
  void leave_out(std::string_view code) {
    if (unfollowed_.find(code) != std::string::npos) return;
    if (!unfollowed_.empty()) unfollowed_ += ' ';
    unfollowed_ += code;
  }
  /// Changes the depth of braces by `by`. A setting within braces is in force up to the closing
  /// brace.
  void enter(int by) {
    depth_ += by;
    if (is_set_at_ > 0 && depth_ < is_set_at_) has_ended_ = true;
  }

  void take_control(std::string_view& rest) {
    if (rest[1] == 'J') end_paragraph();
    if (rest[1] == 'I') append(" ");
    if (rest[1] == ' ') append("^");
    rest.remove_prefix(2);
  }

  void take_code(std::string_view& rest) {
    constexpr std::string_view kWithValue = "fFHWQTACcpS";
    const char code = rest[1];
    const std::string_view name = rest.substr(0, 2);
    rest.remove_prefix(2);
    if (code == 'P' || code == 'N' || code == 'X') {
      end_paragraph();
    } else if (code == '~') {
      append(std::string_view{&kHeldBlank, 1});
    } else if (code == '\\' || code == '{' || code == '}') {
      append(name.substr(1));
    } else if (kWithValue.find(code) != std::string_view::npos) {
      const std::size_t end = std::min(rest.find(';'), rest.size());
      take_value(name, rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    } else if (std::string_view{"lok"}.find(code) == std::string_view::npos) {
      leave_out(name);
    }
  }

  void take_value(std::string_view name, std::string_view value) {
    const char code = name[1];
    if (code == 'A') return;
    if (code == 'S') {
      std::string stack{value};
      std::ranges::replace(stack, '^', '/');
      std::ranges::replace(stack, '#', '/');
      leave_out(name);
      return append(stack);
    }
    if (has_letters_ || !is_set(code, value)) return leave_out(name);
    is_set_at_ = std::max(is_set_at_, depth_);
  }

  /// Applies a code to the line of letters. Returns false if the code is not supported.
  bool is_set(char code, std::string_view value) {
    if (code == 'f' || code == 'F') return set_font(value);
    const bool is_relative = value.ends_with('x');
    if (is_relative) value.remove_suffix(1);
    const auto number = dxf_number(value);
    if (!number) return false;
    if (code == 'H' && *number > 0.0) line_.size = is_relative ? height_ * *number : *number;
    if (code == 'W' && *number > 0.0) line_.stretch = *number;
    if (code == 'Q') line_.slant_rad = *number * kFullTurn / 360.0;
    return code == 'H' || code == 'W' || code == 'Q';
  }

  bool set_font(std::string_view value) {
    const std::size_t end = std::min(value.find('|'), value.size());
    const std::string_view family = value.substr(0, end);
    if (family.ends_with(".shx") || family.ends_with(".SHX")) return true;
    line_.font = {.family = std::string{family},
                  .weight = value.find("|b1") != std::string_view::npos ? 700U : 400U,
                  .is_slanted = value.find("|i1") != std::string_view::npos};
    return true;
  }

  LetterLine& line_;
  double height_;
  std::vector<std::string> paragraphs_;
  std::string paragraph_;
  std::string unfollowed_;
  bool has_letters_ = false;
  int depth_ = 0;
  int is_set_at_ = 0;       ///< Greatest depth of braces at which a code was applied.
  bool has_ended_ = false;  ///< True if the braces around that code were closed.
};

}  // namespace

DxfWords dxf_words(std::string_view coded) {
  DxfWords words;
  while (!coded.empty()) {
    if (is_percent_code(coded)) {
      take_percent_code(coded, words);
    } else {
      words.text += coded.front();
      coded.remove_prefix(1);
    }
  }
  return words;
}

MtextWords mtext_words(const DxfEntity& entity, LetterLine& line) {
  std::string coded;
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 101) break;  // Groups after a group 101 belong to an embedded object.
    if (group.code == 3 || group.code == 1) coded += group.raw;
  }
  return MtextReader{line}.read(coded);
}

}  // namespace sim::drawing
