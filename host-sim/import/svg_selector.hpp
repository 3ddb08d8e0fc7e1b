#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sim::drawing {

inline constexpr std::string_view kCssBlanks = " \t\r\n\f";

/// `[name]`, `[name=value]`, `[name~=value]` and so on.
struct SvgAttributeTest {
  std::string name;
  char kind = '\0';  ///< 0: is there; else the sign before `=`, or `=` alone.
  std::string value{};
};

/// What one element has to be: `rect.cut#a[id]:first-child`.
struct SvgCompound {
  char combinator = ' ';  ///< How it follows the one before: blank, `>`, `+` or `~`.
  std::string element{};  ///< Empty: any.
  std::vector<std::string> ids{};
  std::vector<std::string> classes{};
  std::vector<SvgAttributeTest> attributes{};
  bool is_first_child = false;
  bool is_root = false;
  bool is_never = false;  ///< Only while a pointer is over it, and the like.
};

/// A selector of a style sheet: elements by type, class, id and attribute, within, directly within
/// or behind others.
class SvgSelector {
 public:
  /// Nothing where it has something that is not known.
  [[nodiscard]] static std::optional<SvgSelector> parse(std::string_view text);

  /// Returns whether the element is meant. Counts down `steps`, and says no when none are left.
  [[nodiscard]] bool matches(const pugi::xml_node& node, std::size_t& steps) const;
  /// Returns ids, then classes and attributes, then types, in one number that compares.
  [[nodiscard]] std::uint32_t specificity() const;
  /// Returns what the last element has to be. @pre parse() made it
  [[nodiscard]] const SvgCompound& last() const { return compounds_.back(); }

 private:
  [[nodiscard]] bool matches_from(const pugi::xml_node& node,
                                  std::size_t index,
                                  std::size_t& steps) const;

  std::vector<SvgCompound> compounds_;
};

/// Returns the name of an element without its prefix.
[[nodiscard]] std::string_view local_name(const pugi::xml_node& node);

/// Returns whether a list of words, separated by blanks, has the word.
[[nodiscard]] bool has_word(std::string_view list, std::string_view word);

}  // namespace sim::drawing
