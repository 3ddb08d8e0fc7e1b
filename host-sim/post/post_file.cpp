#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "host-sim/cut/named_values.hpp"
#include "host-sim/post/post.hpp"
#include "host-sim/post/program_words.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::post {
namespace {

using surface::without_blanks_around;

constexpr double kMaxLineNumber = 999'999'999.0;
constexpr double kMinPostDecimals = 3.0;
constexpr double kMaxPostDecimals = 6.0;

/// The texts that a key accepts, each with the value that it means.
template <typename Value>
using Choices = std::vector<std::pair<std::string_view, Value>>;

/// Reader of one post file, which reads it line by line.
class PostReader {
 public:
  PostReader(std::string_view text, std::string name) : lines_{text}, name_{std::move(name)} {}

  Post read() {
    while (const std::optional<std::string_view> line = lines_.next()) {
      if (is_section(*line)) {
        begin_section(*line);
      } else if (texts_of_section() != nullptr) {
        add_text(*line);
      } else if (!line->empty() && line->front() != '#') {
        read_pair(*line);
      }
    }
    for (auto* const texts : {&post_.header, &post_.footer, &post_.before_cut, &post_.after_cut}) {
      while (!texts->empty() && texts->back().empty()) texts->pop_back();
    }
    return std::move(post_);
  }

 private:
  using Apply = void (PostReader::*)(std::string_view);
  struct Key {
    std::string_view name;
    Apply apply;
  };
  static constexpr std::array<std::string_view, 6> kSections{
      "[format]", "[words]", "[header]", "[footer]", "[before-cut]", "[after-cut]"};

  /// Returns the list that receives the lines of the current section unchanged; null for a section
  /// with keys.
  [[nodiscard]] std::vector<std::string>* texts_of_section() {
    if (section_ == "[header]") return &post_.header;
    if (section_ == "[footer]") return &post_.footer;
    if (section_ == "[before-cut]") return &post_.before_cut;
    return section_ == "[after-cut]" ? &post_.after_cut : nullptr;
  }

  static bool is_section(std::string_view line) {
    return line.size() > 1 && line.front() == '[' && line.back() == ']';
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", name_, lines_.number(), reason));
  }

  void begin_section(std::string_view line) {
    if (std::ranges::find(kSections, line) == kSections.end()) {
      refuse(
          fmt::format("there is no section {}; sections are {}", line, fmt::join(kSections, ", ")));
    }
    if (std::ranges::find(begun_, line) != begun_.end()) {
      refuse(fmt::format("{} begins a second time; put its lines together", line));
    }
    begun_.emplace_back(line);
    section_ = line;
  }

  void add_text(std::string_view line) {
    check_plain(line);
    texts_of_section()->emplace_back(line);
  }

  void read_pair(std::string_view line) {
    if (section_.empty()) refuse("this line is before the first section; begin with [format]");
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
      refuse(fmt::format("`{}` is not of the form KEY = VALUE; change it", line));
    }
    const std::string_view key = without_blanks_around(line.substr(0, equals));
    const std::string_view value = without_blanks_around(line.substr(equals + 1));
    if (section_ == "[words]") return add_word(key, value);
    read_format(key, without_comment(value));
  }

  /// Returns a value without the comment that follows it.
  static std::string_view without_comment(std::string_view value) {
    return without_blanks_around(value.substr(0, value.find(" #")));
  }

  void read_format(std::string_view key, std::string_view value) {
    if (std::ranges::find(keys_, key) != keys_.end()) {
      refuse(fmt::format("{} has two values; leave one of them out", key));
    }
    keys_.emplace_back(key);
    static constexpr std::array<Key, 12> kKeys{{
        {"line-numbers", &PostReader::read_numbers},
        {"decimals", &PostReader::read_decimals},
        {"centre-decimals", &PostReader::read_centre_decimals},
        {"points", &PostReader::read_points},
        {"arcs", &PostReader::read_arcs},
        {"arc-planes", &PostReader::read_planes},
        {"arc-tolerance", &PostReader::read_tolerance},
        {"comments", &PostReader::read_comments},
        {"repeat", &PostReader::read_repeat},
        {"blanks", &PostReader::read_blanks},
        {"line-end", &PostReader::read_line_end},
        {"dwell", &PostReader::read_dwell},
    }};
    const auto* const found = std::ranges::find(kKeys, key, &Key::name);
    if (found == kKeys.end()) {
      std::vector<std::string_view> names;
      names.reserve(kKeys.size());
      for (const Key& known : kKeys) names.push_back(known.name);
      refuse(fmt::format("there is no key {}; keys are {}", key, fmt::join(names, ", ")));
    }
    (this->*found->apply)(value);
  }

  void add_word(std::string_view word, std::string_view value) {
    if (std::ranges::find(kProgramWords, word) == kProgramWords.end()) {
      refuse(fmt::format(
          "no program contains the word {}; words are {}", word, fmt::join(kProgramWords, " ")));
    }
    check_plain(value);
    if (word == "S" && !value.empty()) refuse("S may be left out, `S =`, but not replaced");
    if (!post_.words.emplace(word, value).second) {
      refuse(fmt::format("{} is replaced already; leave one of them out", word));
    }
  }

  void check_plain(std::string_view value) const {
    const auto is_plain = [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; };
    if (!std::ranges::all_of(value, is_plain)) {
      refuse("a character is not plain ASCII, and controllers do not read it; leave it out");
    }
  }

  double number(
      std::string_view key, std::string_view text, double least, double most, const char* unit) {
    try {
      return cut::number_from(key, text, least, most, unit);
    } catch (const std::invalid_argument& error) {
      refuse(error.what());
    }
  }

  std::uint32_t whole(std::string_view key, std::string_view text, double least, double most) {
    const double value = number(key, text, least, most, "");
    if (value != std::floor(value))
      refuse(fmt::format("{} = {} is not a whole number; write one", key, text));
    return static_cast<std::uint32_t>(value);
  }

  template <typename Value>
  Value chosen(std::string_view key, std::string_view text, const Choices<Value>& choices) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : choices) {
      if (name == text) return value;
      names.push_back(name);
    }
    refuse(fmt::format("{} = {}: must be one of {}", key, text, fmt::join(names, ", ")));
  }

  bool yes(std::string_view key, std::string_view text) {
    return chosen<bool>(key, text, {{"yes", true}, {"no", false}});
  }

  /// Returns the words of a value. Blanks and commas separate them.
  static std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
      const std::size_t end = text.find_first_of(" \t,");
      if (end != 0) words.push_back(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return words;
  }

  void read_numbers(std::string_view text) {
    if (text == "none") return;
    const std::vector<std::string_view> words = words_of(text);
    if (words.empty() || words.size() > 3) {
      refuse(fmt::format("line-numbers = {}: must be none, or the first number, step and limit",
                         text));
    }
    LineNumbers numbers;
    numbers.first = whole("line-numbers", words[0], 0.0, kMaxLineNumber);
    if (words.size() > 1) numbers.step = whole("line-numbers", words[1], 1.0, kMaxLineNumber);
    if (words.size() > 2) numbers.most = whole("line-numbers", words[2], 1.0, kMaxLineNumber);
    if (numbers.first > numbers.most) {
      refuse(fmt::format("line-numbers = {}: the first number is greater than the greatest, {}",
                         text,
                         numbers.most));
    }
    post_.numbers = numbers;
  }
  void read_decimals(std::string_view text) {
    post_.decimals =
        static_cast<std::uint8_t>(whole("decimals", text, kMinPostDecimals, kMaxPostDecimals));
  }
  void read_centre_decimals(std::string_view text) {
    post_.centre_decimals =
        static_cast<std::uint8_t>(whole("centre-decimals", text, 2.0, kMaxPostDecimals));
  }
  void read_points(std::string_view text) { post_.has_points = yes("points", text); }
  void read_arcs(std::string_view text) {
    post_.arcs = chosen<ArcForm>("arcs",
                                 text,
                                 {{"centre", ArcForm::kFromStart},
                                  {"absolute-centre", ArcForm::kAbsolute},
                                  {"radius", ArcForm::kRadius},
                                  {"lines", ArcForm::kLines}});
  }
  void read_planes(std::string_view text) {
    post_.arc_planes = {false, false, false};
    for (const std::string_view word : words_of(text)) {
      const auto plane = chosen<cnc::Plane>(
          "arc-planes",
          word,
          {{"G17", cnc::Plane::kXY}, {"G18", cnc::Plane::kZX}, {"G19", cnc::Plane::kYZ}});
      post_.arc_planes[static_cast<std::size_t>(plane)] = true;
    }
  }
  void read_tolerance(std::string_view text) {
    post_.arc_tolerance_mm = number("arc-tolerance", text, 1.0e-4, 1.0, "mm");
  }
  void read_comments(std::string_view text) {
    post_.comments = chosen<CommentForm>("comments",
                                         text,
                                         {{"brackets", CommentForm::kBrackets},
                                          {"semicolon", CommentForm::kSemicolon},
                                          {"none", CommentForm::kNone}});
  }
  void read_repeat(std::string_view text) {
    post_.repeat = chosen<Repeat>(
        "repeat",
        text,
        {{"nothing", Repeat::kNothing}, {"motion", Repeat::kMotion}, {"all", Repeat::kAll}});
  }
  void read_blanks(std::string_view text) { post_.has_blanks = yes("blanks", text); }
  void read_line_end(std::string_view text) {
    post_.line_end = chosen<std::string>("line-end", text, {{"lf", "\n"}, {"crlf", "\r\n"}});
  }
  void read_dwell(std::string_view text) {
    constexpr double kMilliseconds = 1000.0;
    post_.dwell = chosen<DwellForm>("dwell",
                                    text,
                                    {{"P s", {'P', 1.0}},
                                     {"P ms", {'P', kMilliseconds}},
                                     {"X s", {'X', 1.0}},
                                     {"U s", {'U', 1.0}},
                                     {"S s", {'S', 1.0}}});
  }

  surface::TextLines lines_;
  std::string name_;
  std::string section_;
  std::vector<std::string> begun_;
  std::vector<std::string> keys_;
  Post post_;
};

}  // namespace

Post read_post(std::string_view text, const std::string& name) {
  return PostReader{text, name}.read();
}

}  // namespace sim::post
