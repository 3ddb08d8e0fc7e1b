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

/// A condition on an attribute: `[name]`, `[name=value]`, `[name~=value]` and so on.
struct SvgAttributeTest {
  std::string name;
  /// Kind of the condition. 0: the attribute must exist. Otherwise it is the character before `=`,
  /// or `=` if no such character exists.
  char kind = '\0';
  std::string value{};
};

/// The conditions on one element, for example `rect.cut#a[id]:first-child`.
struct SvgCompound {
  char combinator = ' ';  ///< Relation to the preceding compound: blank, `>`, `+` or `~`.
  std::string element{};  ///< Name of the element; empty if any element matches.
  std::vector<std::string> ids{};
  std::vector<std::string> classes{};
  std::vector<SvgAttributeTest> attributes{};
  bool is_first_child = false;
  bool is_root = false;
  /// True if the conditions are satisfied only during interaction, for example while a pointer is
  /// over the element.
  bool is_never = false;
};

/// A selector of a style sheet. It selects elements by type, class, id and attribute, and by their
/// position: within, directly within or after other elements.
class SvgSelector {
 public:
  /// Returns the selector that a text describes; nothing if the text has a construct that is not
  /// supported.
  [[nodiscard]] static std::optional<SvgSelector> parse(std::string_view text);

  /// Returns whether the selector matches an element. Each comparison decrements `steps`; when
  /// `steps` is 0, returns false.
  [[nodiscard]] bool matches(const pugi::xml_node& node, std::size_t& steps) const;
  /// Returns the specificity of the selector as one number for comparisons. Its highest bits are
  /// the count of ids, the middle bits the count of classes and attributes, and the lowest bits the
  /// count of types.
  [[nodiscard]] std::uint32_t specificity() const;
  /// Returns the conditions for the selected element itself.
  /// @pre parse() made the selector
  [[nodiscard]] const SvgCompound& last() const { return compounds_.back(); }

 private:
  [[nodiscard]] bool matches_from(const pugi::xml_node& node,
                                  std::size_t index,
                                  std::size_t& steps) const;

  std::vector<SvgCompound> compounds_;
};

/// Returns the name of an element without its prefix.
[[nodiscard]] std::string_view local_name(const pugi::xml_node& node);

/// Returns whether a list of words that are separated by blanks contains `word`.
[[nodiscard]] bool has_word(std::string_view list, std::string_view word);

}  // namespace sim::drawing
