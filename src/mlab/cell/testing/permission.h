#pragma once

#include "mlab/cell/permission.h"

namespace mlab::cell::testing {

/// What somebody at this machine has who trusts all that lies here.
inline Permission all_permitted() {
  return Permission::decide({.purpose = Grounds::Purpose::kRun,
                             .people = Grounds::People::kHere,
                             .allows_native = true,
                             .without_cell = false,
                             .is_trusted = true,
                             .known = nullptr},
                            means());
}

/// What the same has who said no `--allow-native`.
inline Permission code_permitted() {
  return Permission::decide({.purpose = Grounds::Purpose::kRun,
                             .people = Grounds::People::kHere,
                             .allows_native = false,
                             .without_cell = false,
                             .is_trusted = true,
                             .known = nullptr},
                            means());
}

/// What `mlab check` has.
inline Permission check_permitted() {
  return Permission::decide({.purpose = Grounds::Purpose::kCheck,
                             .people = Grounds::People::kHere,
                             .allows_native = false,
                             .without_cell = false,
                             .is_trusted = true,
                             .known = nullptr},
                            means());
}

}  // namespace mlab::cell::testing
