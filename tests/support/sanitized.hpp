#pragma once

namespace proof {

/// Whether this build runs with a sanitizer, which makes it several times slower.
#ifdef __has_feature
#if __has_feature(address_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace proof
