#pragma once

#include "mlab/cell/permission.h"

namespace mlab::cell::testing {

/// Sanitizers want more of a process than a cell gives: what they watch runs without one.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kIsSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif
#else
inline constexpr bool kIsSanitized = false;
#endif

/// What somebody at this machine has who trusts all that lies here.
inline Permission all_permitted() {
  return Permission::decide({.purpose = Grounds::Purpose::kRun,
                             .people = Grounds::People::kHere,
                             .allows_native = true,
                             .without_cell = kIsSanitized,
                             .is_trusted = true,
                             .known = nullptr},
                            means());
}

/// What the same has who said no `--allow-native`.
inline Permission code_permitted() {
  return Permission::decide({.purpose = Grounds::Purpose::kRun,
                             .people = Grounds::People::kHere,
                             .allows_native = false,
                             .without_cell = kIsSanitized,
                             .is_trusted = true,
                             .known = nullptr},
                            means());
}

/// What the same has who said `--allow-native --no-cell`.
inline Permission permitted_without_cell() {
  return Permission::decide({.purpose = Grounds::Purpose::kRun,
                             .people = Grounds::People::kHere,
                             .allows_native = true,
                             .without_cell = true,
                             .is_trusted = true,
                             .known = nullptr},
                            means());
}

/// What `mlab check` has.
inline Permission check_permitted() {
  return Permission::decide({.purpose = Grounds::Purpose::kCheck,
                             .people = Grounds::People::kHere,
                             .allows_native = false,
                             .without_cell = kIsSanitized,
                             .is_trusted = true,
                             .known = nullptr},
                            means());
}

}  // namespace mlab::cell::testing
