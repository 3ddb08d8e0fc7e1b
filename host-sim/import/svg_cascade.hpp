#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/svg_sheet.hpp"

namespace sim::drawing {

/// The properties of one element, from style sheets, its `style` attribute and its other
/// attributes.
class SvgProperties {
 public:
  explicit SvgProperties(const pugi::xml_node& node) : node_{node} {}
  // The candidates contain pointers to declarations, including those in `inline_`. A move keeps
  // these declarations at their addresses, but a copy does not.
  SvgProperties(const SvgProperties&) = delete;
  SvgProperties& operator=(const SvgProperties&) = delete;
  SvgProperties(SvgProperties&&) noexcept = default;
  SvgProperties& operator=(SvgProperties&&) noexcept = default;
  ~SvgProperties() = default;

  /// Returns the value of a property without blanks at its ends; empty if the element has none.
  [[nodiscard]] std::string_view get(const char* name) const;
  /// Returns the value of an attribute as it is written in the file.
  [[nodiscard]] std::string_view attribute(const char* name) const {
    return node_.attribute(name).value();
  }
  /// Returns whether a property has a value, even an empty one.
  [[nodiscard]] bool has(const char* name) const {
    return !styled(name).empty() || node_.attribute(name);
  }
  /// Returns the value that the `style` attribute or a style sheet gives. Ignores presentation
  /// attributes.
  [[nodiscard]] std::string_view styled(std::string_view name) const;

 private:
  friend class SvgCascade;

  struct Priority {
    bool is_important = false;
    bool is_inline = false;
    std::uint32_t specificity = 0;
    std::size_t order = 0;
    auto operator<=>(const Priority&) const = default;
  };
  struct Candidate {
    const SvgDeclaration* declaration = nullptr;
    Priority priority{};
  };

  pugi::xml_node node_;
  SvgDeclarations inline_;
  std::vector<Candidate> candidates_;
};

/// The rules of all style sheets of a document.
class SvgCascade {
 public:
  /// @param steps greatest number of comparisons of elements with selectors in the whole document
  explicit SvgCascade(std::size_t steps) : steps_{steps} {}

  /// Adds the rules of a sheet after the rules of earlier sheets.
  void add(std::vector<SvgRule> rules);

  [[nodiscard]] SvgProperties properties_of(const pugi::xml_node& node);

  /// Returns whether all steps are used up. Later elements then do not get the rules of style
  /// sheets.
  [[nodiscard]] bool is_exhausted() const { return steps_ == 0; }

 private:
  using Buckets = std::map<std::string, std::vector<std::size_t>, std::less<>>;

  void take(const Buckets& buckets, std::string_view key, SvgProperties& properties);

  std::vector<SvgRule> rules_;
  Buckets by_id_;
  Buckets by_class_;
  /// Rules, keyed by the name of the element that they select. Rules for any element have the empty
  /// name.
  Buckets by_element_;
  std::size_t steps_;
};

}  // namespace sim::drawing
