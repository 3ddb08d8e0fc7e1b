#pragma once

/// Status codes of HTTP that this server sends (RFC 9110, section 15).
namespace sim::http_status {
inline constexpr int kFine = 200;
inline constexpr int kBadRequest = 400;
inline constexpr int kForbidden = 403;
inline constexpr int kNotFound = 404;
inline constexpr int kWrongMethod = 405;
inline constexpr int kTimeout = 408;
inline constexpr int kConflict = 409;
inline constexpr int kLengthRequired = 411;
inline constexpr int kTooLarge = 413;
inline constexpr int kUpgradeRequired = 426;
inline constexpr int kHeadTooLarge = 431;
inline constexpr int kInternalFault = 500;
}  // namespace sim::http_status
