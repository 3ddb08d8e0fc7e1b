#include "host-sim/import/svg_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace sim::drawing {
namespace {

constexpr std::size_t kDeepestBlock = 4;

/// Returns a style sheet in which blanks replace comments and the marks of XML comments, so that
/// positions in the text do not change.
std::string without_comments(std::string_view text) {
  std::string bare{text};
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      if (bare[i] != '\n') bare[i] = ' ';
    }
  };
  for (std::size_t at = bare.find("/*"); at != std::string::npos; at = bare.find("/*", at)) {
    const std::size_t end = bare.find("*/", at + 2);
    blank(at, end == std::string::npos ? bare.size() : end + 2);
  }
  for (const std::string_view mark : {"<!--", "-->"}) {
    for (std::size_t at = bare.find(mark); at != std::string::npos; at = bare.find(mark, at)) {
      blank(at, at + mark.size());
    }
  }
  return bare;
}

/// Returns the first position, outside of quotes, brackets and braces, of any character of
/// `wanted`; the size of the text if there is none.
std::size_t find_outside(std::string_view text, std::string_view wanted, std::size_t from) {
  char quote = '\0';
  std::size_t depth = 0;
  for (std::size_t i = from; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (depth == 0 && wanted.find(c) != std::string_view::npos) {
      return i;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '(' || c == '[' || c == '{') {
      ++depth;
    } else if ((c == ')' || c == ']' || c == '}') && depth != 0) {
      --depth;
    }
  }
  return text.size();
}

std::string lower(std::string_view text) {
  std::string result{text};
  std::ranges::transform(
      result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// Returns whether a list of media includes screens (`all`, `screen` or `only screen`).
bool is_seen(std::string_view media) {
  while (!media.empty()) {
    const std::string_view one = media.substr(0, media.find(','));
    media.remove_prefix(std::min(media.size(), one.size() + 1));
    const std::string word = lower(css_trimmed(one));
    if (word == "all" || word == "screen" || word == "only screen") return true;
  }
  return false;
}

class SheetReader {
 public:
  SheetReader(std::string_view text, const SvgSheetReport& report) : text_{text}, report_{report} {}

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read(std::size_t from, std::size_t to, std::size_t depth) {
    at_ = from;
    while (skip_blanks(to)) {
      if (text_[at_] == '@') {
        at_rule(to, depth);
      } else {
        rule(to);
      }
    }
  }

  std::vector<SvgRule> rules;

 private:
  bool skip_blanks(std::size_t to) {
    while (at_ < to && (kCssBlanks.find(text_[at_]) != std::string_view::npos ||
                        text_[at_] == '}' || text_[at_] == ';')) {
      ++at_;
    }
    return at_ < to;
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void at_rule(std::size_t to, std::size_t depth) {
    const std::size_t from = at_;
    const std::size_t head = std::min(to, find_outside(text_, ";{", from));
    const std::string_view words = css_trimmed(text_.substr(from, head - from));
    const bool has_block = head < to && text_[head] == '{';
    const std::size_t end = has_block ? std::min(to, find_outside(text_, "}", head + 1)) : head;
    const std::string name = lower(words.substr(0, words.find_first_of(kCssBlanks)));
    if (name == "@media" && has_block && depth < kDeepestBlock && is_seen(words.substr(6))) {
      read(head + 1, end, depth + 1);
    } else if (name != "@charset" && name != "@namespace") {
      report_(from, fmt::format("`{:.40}` of the style sheet is not read", words));
    }
    at_ = std::min(to, end + 1);
  }

  void rule(std::size_t to) {
    const std::size_t from = at_;
    const std::size_t head = std::min(to, find_outside(text_, "{", from));
    const std::size_t end = std::min(to, find_outside(text_, "}", std::min(to, head + 1)));
    at_ = std::min(to, end + 1);
    const std::string_view selectors = text_.substr(from, head - from);
    if (head == to)
      return report_(from, fmt::format("`{:.40}` is no rule", css_trimmed(selectors)));
    const auto declarations = std::make_shared<const SvgDeclarations>(
        svg_declarations(text_.substr(head + 1, end - head - 1)));
    std::vector<SvgRule> found;
    for (std::size_t i = 0; i <= selectors.size();) {
      const std::size_t comma = find_outside(selectors, ",", i);
      const std::string_view one = css_trimmed(selectors.substr(i, comma - i));
      auto selector = SvgSelector::parse(one);
      if (!selector) {
        return report_(from,
                       fmt::format("a rule is left out: its selector `{:.40}` is not known", one));
      }
      found.push_back({std::move(*selector), declarations});
      i = comma + 1;
    }
    rules.insert(rules.end(), found.begin(), found.end());
  }

  std::string_view text_;
  const SvgSheetReport& report_;
  std::size_t at_ = 0;
};

}  // namespace

std::string_view css_trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(kCssBlanks);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(kCssBlanks) - from + 1);
}

SvgDeclarations svg_declarations(std::string_view text) {
  SvgDeclarations declarations;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = find_outside(text, ";", from);
    const std::string_view one = text.substr(from, end - from);
    from = end + 1;
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) continue;
    SvgDeclaration declaration{lower(css_trimmed(one.substr(0, colon))), {}};
    std::string_view value = css_trimmed(one.substr(colon + 1));
    const std::size_t mark = value.rfind('!');
    if (mark != std::string_view::npos &&
        lower(css_trimmed(value.substr(mark + 1))) == "important") {
      declaration.is_important = true;
      value = css_trimmed(value.substr(0, mark));
    }
    if (declaration.name.empty() || value.empty()) continue;
    declaration.value = value;
    declarations.push_back(std::move(declaration));
  }
  return declarations;
}

std::vector<SvgRule> svg_rules(std::string_view text, const SvgSheetReport& report) {
  const std::string bare = without_comments(text);
  SheetReader reader{bare, report};
  reader.read(0, bare.size(), 0);
  return std::move(reader.rules);
}

}  // namespace sim::drawing
