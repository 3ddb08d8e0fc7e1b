#include "host-sim/import/svg_markup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sim::drawing {
namespace {

constexpr std::size_t kMaxExpandedBytes = std::size_t{16} << 20;
constexpr std::size_t kDeepestEntity = 16;
constexpr std::size_t kLongestName = 200;
constexpr std::string_view kXmlBlanks = " \t\r\n";

bool is_xml_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view{"_-.:"}.find(c) != std::string_view::npos ||
         static_cast<unsigned char>(c) >= 0x80U;
}

/// Returns the name of the reference `&name;` at the beginning of a text; empty if there is none.
std::string_view reference_name(std::string_view text) {
  std::size_t end = 1;
  while (end < text.size() && end < kLongestName && is_xml_name_character(text[end])) ++end;
  if (end == 1 || end >= text.size() || text[end] != ';') return {};
  return text.substr(1, end - 1);
}

bool is_predefined(std::string_view name) {
  static constexpr std::array<std::string_view, 5> kNames{"lt", "gt", "amp", "quot", "apos"};
  return std::ranges::find(kNames, name) != kNames.end();
}

/// Returns the position after the first `mark` at or after `from`; the end of the text if there is
/// none.
std::size_t past(std::string_view text, std::string_view mark, std::size_t from) {
  const std::size_t end = text.find(mark, from);
  return end == std::string_view::npos ? text.size() : end + mark.size();
}

/// Returns the position after the `>` of a declaration of the DOCTYPE. A `>` within quotes does not
/// end it.
std::size_t past_declaration(std::string_view text, std::size_t from) {
  char quote = '\0';
  for (std::size_t i = from; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i + 1;
    }
  }
  return text.size();
}

std::string_view next_word(std::string_view& text) {
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(kXmlBlanks)));
  const std::string_view word = text.substr(0, text.find_first_of(kXmlBlanks));
  text.remove_prefix(word.size());
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(kXmlBlanks)));
  return word;
}

}  // namespace

SvgMarkup::SvgMarkup(const std::string& source, Sketch& sketch)
    : source_{source},
      sketch_{sketch},
      lines_{source},
      max_bytes_{source.size() + sketch.share_of(kMaxExpandedBytes)} {
  read_prologue();
  text_.reserve(source.size());
  expand_all();
}

std::pair<std::size_t, std::size_t> SvgMarkup::at(std::size_t offset) const {
  const auto after = std::ranges::upper_bound(stretches_, offset, {}, &Stretch::out);
  if (after == stretches_.begin()) return lines_.at(offset);
  const Stretch& stretch = *(after - 1);
  return lines_.at(stretch.is_verbatim ? stretch.in + (offset - stretch.out) : stretch.in);
}

void SvgMarkup::read_prologue() {
  while (at_ < source_.size()) {
    const std::size_t from = source_.find('<', at_);
    const std::string_view rest = from == std::string_view::npos ? "" : source_.substr(from);
    if (rest.starts_with("<!--")) {
      copy(at_, past(source_, "-->", from));
    } else if (rest.starts_with("<?")) {
      if (rest.starts_with("<?xml-stylesheet")) {
        const auto [line, column] = lines_.at(from);
        sketch_.ignore("a style sheet of another file is not read",
                       {.name = "xml-stylesheet", .line = line, .column = column},
                       "embed it in a style element");
      }
      copy(at_, past(source_, "?>", from));
    } else if (rest.starts_with("<!DOCTYPE")) {
      copy(at_, from);
      at_ = from;
      read_subset();
      return;
    } else {
      return;
    }
  }
}

void SvgMarkup::read_subset() {
  const std::size_t bracket = source_.find('[', at_);
  const std::size_t end = past_declaration(source_, at_);
  if (bracket == std::string_view::npos || bracket >= end) {
    at_ = end;
    return;
  }
  at_ = bracket + 1;
  while (at_ < source_.size()) {
    const char c = source_[at_];
    if (c == ']') {
      at_ = past(source_, ">", at_);
      return;
    }
    if (c == '<') {
      read_declaration();
    } else {
      ++at_;
    }
  }
}

void SvgMarkup::read_declaration() {
  const std::string_view rest = source_.substr(at_);
  if (rest.starts_with("<!--")) {
    at_ = past(source_, "-->", at_);
  } else if (rest.starts_with("<?")) {
    at_ = past(source_, "?>", at_);
  } else {
    const std::size_t end = past_declaration(source_, at_);
    constexpr std::string_view kEntity = "<!ENTITY";
    if (rest.starts_with(kEntity)) {
      read_entity(source_.substr(at_ + kEntity.size(), end - at_ - kEntity.size()), at_);
    }
    at_ = end;
  }
}

void SvgMarkup::read_entity(std::string_view declaration, std::size_t at) {
  const std::string_view name = next_word(declaration);
  const char quote = declaration.empty() ? '\0' : declaration.front();
  if (name != "%" && (quote == '"' || quote == '\'')) {
    const std::size_t end = declaration.find(quote, 1);
    if (end == std::string_view::npos) return;
    // If a name is declared more than once, the first declaration counts.
    entities_.emplace(name, declaration.substr(1, end - 1));
    return;
  }
  const auto [line, column] = lines_.at(at);
  sketch_.ignore("entities of other files and parameter entities are not read",
                 {.name = fmt::format("ENTITY {:.60}", name == "%" ? declaration : name),
                  .line = line,
                  .column = column},
                 "write its content into the drawing");
}

void SvgMarkup::copy(std::size_t from, std::size_t to) {
  at_ = to;
  if (to <= from) return;
  stretches_.push_back({text_.size(), from, true});
  text_.append(source_.substr(from, to - from));
}

void SvgMarkup::expand_all() {
  bool in_tag = false;
  std::size_t from = at_;
  std::size_t i = at_;
  while (i < source_.size() && !too_long_) {
    const std::string_view rest = source_.substr(i);
    if (rest.front() == '&') {
      copy(from, i);
      i = from = put_reference(i, in_tag);
    } else if (rest.starts_with("<!--")) {
      i = past(source_, "-->", i);
    } else if (rest.starts_with("<![CDATA[")) {
      i = past(source_, "]]>", i);
    } else {
      if (rest.front() == '<') in_tag = true;
      if (rest.front() == '>') in_tag = false;
      ++i;
    }
  }
  if (!too_long_) copy(from, source_.size());
}

std::size_t SvgMarkup::put_reference(std::size_t at, bool in_tag) {
  const std::string_view name = reference_name(source_.substr(at));
  const std::size_t end = at + (name.empty() ? 1 : name.size() + 2);
  const auto found = entities_.find(name);
  if (found == entities_.end()) {
    copy(at, end);
    if (!name.empty() && !is_predefined(name)) undeclared(name, at);
    return end;
  }
  stretches_.push_back({text_.size(), at, false});
  put(found->second, in_tag, 0, at);
  return end;
}

// Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
void SvgMarkup::put(std::string_view text, bool in_tag, std::size_t depth, std::size_t at) {
  for (std::size_t i = 0; i < text.size() && !too_long_; ++i) {
    const std::string_view name =
        text[i] == '&' ? reference_name(text.substr(i)) : std::string_view{};
    const auto found = name.empty() ? entities_.end() : entities_.find(name);
    if (found != entities_.end() && depth < kDeepestEntity) {
      put(found->second, in_tag, depth + 1, at);
      i += name.size() + 1;
    } else {
      if (!name.empty() && !is_predefined(name)) undeclared(name, at);
      put_character(text[i], in_tag);
    }
    if (text_.size() <= max_bytes_ || too_long_) continue;
    too_long_ = true;
    const auto [line, column] = lines_.at(at);
    sketch_.refuse(line,
                   column,
                   fmt::format("its entities expand to more than {} bytes", max_bytes_),
                   "write their content into the drawing");
  }
}

void SvgMarkup::put_character(char c, bool in_tag) {
  // By XML, quotes that come from an entity are data within an attribute and do not end its value.
  if (in_tag && c == '"') {
    text_ += "&quot;";
  } else if (in_tag && c == '\'') {
    text_ += "&apos;";
  } else if (in_tag && c == '<') {
    text_ += "&lt;";
  } else {
    text_ += c;
  }
}

void SvgMarkup::undeclared(std::string_view name, std::size_t at) {
  if (!undeclared_.emplace(name, true).second) return;
  const auto [line, column] = lines_.at(at);
  const bool is_deep = entities_.contains(name);
  sketch_.report(
      {FaultKind::kBadEntity,
       {.name = fmt::format("entity &{:.60};", name), .line = line, .column = column},
       {},
       is_deep ? fmt::format("it contains itself, or entities that are nested deeper than {}",
                             kDeepestEntity)
               : "it is not declared in the DOCTYPE",
       "replace it by the text for which it stands"});
}

}  // namespace sim::drawing
