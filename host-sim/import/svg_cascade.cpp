#include "host-sim/import/svg_cascade.hpp"

#include <algorithm>

namespace sim::drawing {

std::string_view SvgProperties::styled(std::string_view name) const {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : candidates_) {
    if (candidate.declaration->name != name) continue;
    if (best == nullptr || candidate.priority >= best->priority) best = &candidate;
  }
  return best == nullptr ? std::string_view{} : best->declaration->value;
}

std::string_view SvgProperties::get(const char* name) const {
  const std::string_view value = styled(name);
  return value.empty() ? css_trimmed(node_.attribute(name).value()) : value;
}

void SvgCascade::add(std::vector<SvgRule> rules) {
  for (SvgRule& rule : rules) {
    const SvgCompound& last = rule.selector.last();
    const std::size_t index = rules_.size();
    if (!last.ids.empty()) {
      by_id_[last.ids.front()].push_back(index);
    } else if (!last.classes.empty()) {
      by_class_[last.classes.front()].push_back(index);
    } else {
      by_element_[last.element].push_back(index);
    }
    rules_.push_back(std::move(rule));
  }
}

void SvgCascade::take(const Buckets& buckets, std::string_view key, SvgProperties& properties) {
  const auto found = buckets.find(key);
  if (found == buckets.end()) return;
  for (const std::size_t index : found->second) {
    const SvgRule& rule = rules_[index];
    if (!rule.selector.matches(properties.node_, steps_)) continue;
    for (const SvgDeclaration& declaration : *rule.declarations) {
      properties.candidates_.push_back(
          {&declaration, {declaration.is_important, false, rule.selector.specificity(), index}});
    }
  }
}

SvgProperties SvgCascade::properties_of(const pugi::xml_node& node) {
  SvgProperties properties{node};
  if (!rules_.empty() && steps_ != 0) {
    take(by_element_, "", properties);
    take(by_element_, local_name(node), properties);
    const std::string_view id = node.attribute("id").value();
    if (!id.empty()) take(by_id_, id, properties);
    std::string_view classes = css_trimmed(node.attribute("class").value());
    while (!classes.empty()) {
      const std::string_view one = classes.substr(0, classes.find_first_of(" \t\r\n\f"));
      take(by_class_, one, properties);
      classes = css_trimmed(classes.substr(one.size()));
    }
  }
  const std::string_view style = node.attribute("style").value();
  if (style.empty()) return properties;
  properties.inline_ = svg_declarations(style);
  for (const SvgDeclaration& declaration : properties.inline_) {
    properties.candidates_.push_back({&declaration, {declaration.is_important, true, 0, 0}});
  }
  return properties;
}

}  // namespace sim::drawing
