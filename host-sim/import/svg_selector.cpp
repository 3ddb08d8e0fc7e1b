#include "host-sim/import/svg_selector.hpp"

#include <algorithm>
#include <array>

namespace sim::drawing {
namespace {

constexpr std::string_view kCombinators = ">+~";
constexpr std::size_t kMaxCompounds = 16;

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || static_cast<unsigned char>(c) >= 0x80U;
}

/// Reads one selector, character by character.
class SelectorReader {
 public:
  explicit SelectorReader(std::string_view text) : text_{text} {}

  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }

  std::optional<SvgCompound> compound() {
    SvgCompound compound;
    const std::size_t from = at_;
    if (take('*')) {
      compound.element.clear();
    } else {
      compound.element = name();
    }
    while (!at_end() && std::string_view{".#[:"}.find(text_[at_]) != std::string_view::npos) {
      if (!simple(compound)) return {};
    }
    if (at_ == from) return {};
    return compound;
  }

  /// Consumes the next combinator and returns it; nothing if no combinator is next.
  std::optional<char> combinator() {
    const bool blank = skip_blanks();
    if (at_end()) return {};
    const char c = text_[at_];
    if (kCombinators.find(c) == std::string_view::npos) return blank ? std::optional{' '} : '\0';
    ++at_;
    skip_blanks();
    return c;
  }

 private:
  bool take(char c) {
    if (at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  bool skip_blanks() {
    const std::size_t from = at_;
    while (!at_end() && kCssBlanks.find(text_[at_]) != std::string_view::npos) ++at_;
    return at_ != from;
  }
  /// Consumes a name and returns it. A `\` escapes the next character.
  std::string name() {
    std::string name;
    while (!at_end()) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) {
        ++at_;
      } else if (!is_name_character(text_[at_])) {
        break;
      }
      name += text_[at_++];
    }
    return name;
  }

  bool simple(SvgCompound& compound) {
    const char kind = text_[at_++];
    if (kind == '[') return attribute(compound);
    const std::string word = name();
    if (word.empty()) return false;
    if (kind == '.') compound.classes.push_back(word);
    if (kind == '#') compound.ids.push_back(word);
    return kind != ':' || pseudo_class(word, compound);
  }

  static bool pseudo_class(const std::string& word, SvgCompound& compound) {
    static constexpr std::array<std::string_view, 7> kOfPointers{
        "hover", "active", "focus", "link", "visited", "target", "focus-within"};
    if (word == "first-child") {
      compound.is_first_child = true;
    } else if (word == "root") {
      compound.is_root = true;
    } else if (std::ranges::find(kOfPointers, word) != kOfPointers.end()) {
      compound.is_never = true;
    } else {
      return false;
    }
    return true;
  }

  bool attribute(SvgCompound& compound) {
    skip_blanks();
    SvgAttributeTest test{name()};
    skip_blanks();
    if (test.name.empty()) return false;
    if (!take(']')) {
      if (at_end()) return false;
      test.kind = text_[at_++];
      if (test.kind != '=' && !take('=')) return false;
      if (std::string_view{"=~|^$*"}.find(test.kind) == std::string_view::npos) return false;
      skip_blanks();
      test.value = value();
      skip_blanks();
      if (!take(']')) return false;
    }
    compound.attributes.push_back(std::move(test));
    return true;
  }

  std::string value() {
    if (at_end() || (text_[at_] != '"' && text_[at_] != '\'')) return name();
    const char quote = text_[at_++];
    const std::size_t end = std::min(text_.size(), text_.find(quote, at_));
    std::string value{text_.substr(at_, end - at_)};
    at_ = std::min(text_.size(), end + 1);
    return value;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

bool holds(const SvgAttributeTest& test, const pugi::xml_node& node) {
  const pugi::xml_attribute attribute = node.attribute(test.name.c_str());
  const std::string_view value = attribute.value();
  if (!attribute) return false;
  switch (test.kind) {
    case '\0':
      return true;
    case '=':
      return value == test.value;
    case '~':
      return has_word(value, test.value);
    case '|':
      return value == test.value || value.starts_with(test.value + "-");
    case '^':
      return !test.value.empty() && value.starts_with(test.value);
    case '$':
      return !test.value.empty() && value.ends_with(test.value);
    default:
      return !test.value.empty() && value.find(test.value) != std::string_view::npos;
  }
}

pugi::xml_node element_before(const pugi::xml_node& node) {
  pugi::xml_node before = node.previous_sibling();
  while (before && before.type() != pugi::node_element) before = before.previous_sibling();
  return before;
}

bool holds(const SvgCompound& compound, const pugi::xml_node& node) {
  if (node.type() != pugi::node_element || compound.is_never) return false;
  if (!compound.element.empty() && compound.element != local_name(node)) return false;
  const std::string_view id = node.attribute("id").value();
  if (!std::ranges::all_of(compound.ids, [&](const auto& wanted) { return wanted == id; })) {
    return false;
  }
  const std::string_view classes = node.attribute("class").value();
  const auto in_class = [&](const auto& wanted) { return has_word(classes, wanted); };
  if (!std::ranges::all_of(compound.classes, in_class)) return false;
  const auto has = [&](const SvgAttributeTest& test) { return holds(test, node); };
  if (!std::ranges::all_of(compound.attributes, has)) return false;
  if (compound.is_first_child && element_before(node)) return false;
  return !compound.is_root || node.parent().type() == pugi::node_document;
}

}  // namespace

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.substr(name.rfind(':') == std::string_view::npos ? 0 : name.rfind(':') + 1);
}

bool has_word(std::string_view list, std::string_view word) {
  if (word.empty()) return false;
  for (std::size_t at = list.find(word); at != std::string_view::npos;
       at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || kCssBlanks.find(list[at - 1]) != std::string_view::npos;
    const bool ends = end == list.size() || kCssBlanks.find(list[end]) != std::string_view::npos;
    if (begins && ends) return true;
  }
  return false;
}

std::optional<SvgSelector> SvgSelector::parse(std::string_view text) {
  SelectorReader reader{text};
  SvgSelector selector;
  char combinator = ' ';
  while (selector.compounds_.size() < kMaxCompounds) {
    auto compound = reader.compound();
    if (!compound) return {};
    compound->combinator = combinator;
    selector.compounds_.push_back(std::move(*compound));
    const auto next = reader.combinator();
    if (!next) return selector;
    if (*next == '\0') return {};
    combinator = *next;
  }
  return {};
}

std::uint32_t SvgSelector::specificity() const {
  std::size_t ids = 0;
  std::size_t classes = 0;
  std::size_t types = 0;
  for (const SvgCompound& compound : compounds_) {
    ids += compound.ids.size();
    classes += compound.classes.size() + compound.attributes.size();
    classes += (compound.is_first_child ? 1U : 0U) + (compound.is_root ? 1U : 0U);
    types += compound.element.empty() ? 0U : 1U;
  }
  constexpr std::size_t kMax = 1023;
  return static_cast<std::uint32_t>((std::min(ids, kMax) << 20U) |
                                    (std::min(classes, kMax) << 10U) | std::min(types, kMax));
}

bool SvgSelector::matches(const pugi::xml_node& node, std::size_t& steps) const {
  return matches_from(node, compounds_.size() - 1, steps);
}

// Bounded by the number of compounds. NOLINTNEXTLINE(misc-no-recursion)
bool SvgSelector::matches_from(const pugi::xml_node& node,
                               std::size_t index,
                               std::size_t& steps) const {
  if (steps == 0) return false;
  --steps;
  const SvgCompound& compound = compounds_[index];
  if (!holds(compound, node)) return false;
  if (index == 0) return true;
  const char combinator = compound.combinator;
  const bool upwards = combinator == ' ' || combinator == '>';
  const auto next = [&](const pugi::xml_node& from) {
    return upwards ? from.parent() : element_before(from);
  };
  for (pugi::xml_node other = next(node); other && steps != 0; other = next(other)) {
    if (matches_from(other, index - 1, steps)) return true;
    if (combinator == '>' || combinator == '+') return false;
  }
  return false;
}

}  // namespace sim::drawing
