#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sim::cut {

/// Returns the document of a JSON file. Throws std::invalid_argument with file, line and column if
/// the text is not JSON. Also throws std::invalid_argument if the document is not an object in
/// which the key `mark` has the value 1.
/// @param kind name for files of this kind in messages, such as `machine profile`
[[nodiscard]] nlohmann::ordered_json marked_json(const std::string& text,
                                                 const std::string& file,
                                                 const char* mark,
                                                 const char* kind);

/// Reads the fields of one JSON object. Refuses a faulty field: throws std::invalid_argument with
/// the text `FILE: /pointer: reason; remedy`.
class JsonFields {
 public:
  /// Refuses keys of `object` that are not in `keys`. The message names the most similar valid key.
  /// @param object must outlive this object
  JsonFields(const nlohmann::ordered_json& object,
             std::string file,
             std::string pointer,
             const std::vector<std::string>& keys);

  /// Returns the number of a field, or nothing if the key is missing. Refuses numbers out of the
  /// range.
  [[nodiscard]] std::optional<double> number(const char* key, double min, double max) const;
  /// Returns the two numbers of a field, or nothing if the key is missing. Refuses numbers out of
  /// the range.
  [[nodiscard]] std::optional<std::pair<double, double>> pair(const char* key,
                                                              double min,
                                                              double max) const;
  [[nodiscard]] std::optional<std::string> text(const char* key) const;
  /// Returns the texts of an array field; none if the key is missing.
  [[nodiscard]] std::vector<std::string> texts(const char* key) const;

  [[noreturn]] void refuse(const std::string& key, const std::string& reason) const;

 private:
  const nlohmann::ordered_json& object_;
  std::string file_;
  std::string pointer_;
};

}  // namespace sim::cut
