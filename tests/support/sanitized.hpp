#pragma once

namespace proof {

/// Whether a sanitizer watches this build, which makes it some times slower.
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
