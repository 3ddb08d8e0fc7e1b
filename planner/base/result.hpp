#pragma once

#include <optional>
#include <type_traits>

#include "planner/base/contract.hpp"

namespace cnc {

/// A value, or the reason why there is no value.
///
/// Functions return it for every failure that input can cause: a user, a cable, a G-code file. A
/// Result never allocates, and the compiler warns if it is ignored. `Error` is a small enum owned
/// by the module that fails. Where the location matters too, it is a plain struct around such an
/// enum (a G-code fault contains its column).
template <typename Value, typename Error>
class [[nodiscard]] Result {
  static_assert(std::is_trivially_destructible_v<Value>, "a Result owns nothing");
  static_assert(std::is_trivially_copyable_v<Error>, "an error is a name and a place");

 public:
  // These constructors are implicit, so that a function can return a value or an error directly.
  constexpr Result(const Value& value) : value_{value} {}  // NOLINT(google-explicit-constructor)
  constexpr Result(const Error& error) : error_{error} {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] constexpr bool ok() const { return value_.has_value(); }

  /// @pre ok()
  [[nodiscard]] constexpr const Value& value() const {
    CNC_ASSERT(ok());
    return *value_;
  }

  /// @pre !ok()
  [[nodiscard]] constexpr const Error& error() const {
    CNC_ASSERT(!ok());
    return error_;
  }

 private:
  std::optional<Value> value_;
  Error error_{};
};

}  // namespace cnc
