#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::sheet {

/// The range and the unit of the numbers that a field accepts.
struct FieldRange {
  double min = 0.0;
  double max = 0.0;
  const char* unit = "";
};

/// Reads the fields of one JSON object. If a value has the wrong type or is out of range, reports a
/// fault with the pointer of the field and returns the default.
class SheetFields {
 public:
  /// Reports a fault for each key of `object` that is not in `keys`. The fault names the most
  /// similar key.
  /// @param object a JSON object, which must outlive the SheetFields
  /// @param pointer JSON pointer to the object in the file
  SheetFields(const nlohmann::json& object,
              std::string pointer,
              const std::vector<std::string>& keys,
              std::vector<drawing::Fault>& faults);

  [[nodiscard]] bool has(const char* key) const;
  [[nodiscard]] double number(const char* key, double otherwise, const FieldRange& range);
  [[nodiscard]] std::size_t whole(const char* key, std::size_t otherwise, const FieldRange& range);
  [[nodiscard]] bool flag(const char* key, bool otherwise);
  /// Returns the text of a field, or `otherwise` if the field is missing or is not a text with at
  /// least one character.
  [[nodiscard]] std::string text(const char* key, const std::string& otherwise);
  /// Return the field if it is an array (array()) or an object (object()). Otherwise they return a
  /// null value, and report a fault unless the field is missing.
  [[nodiscard]] const nlohmann::json& array(const char* key);
  [[nodiscard]] const nlohmann::json& object(const char* key);

  /// Reports a fault of the field `key`, or of the object itself if `key` is empty.
  void bad(const std::string& key, std::string reason, std::string remedy);
  [[nodiscard]] const std::string& pointer() const { return pointer_; }

 private:
  [[nodiscard]] const nlohmann::json& of_type(const char* key, bool is_type, const char* wanted);

  const nlohmann::json& object_;
  std::string pointer_;
  std::vector<drawing::Fault>& faults_;
};

}  // namespace sim::sheet
