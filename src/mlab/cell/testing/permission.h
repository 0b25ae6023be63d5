#pragma once

#include <memory>
#include <utility>

#include "mlab/cell/permission.h"
#include "mlab/cell/sanitized.h"

/// Permissions of somebody at this machine who trusts all that lies here, where nothing else is said. What
/// sanitizers watch runs without a cell.
namespace mlab::cell::testing {

inline Permission permitted(Grounds::Purpose purpose, bool allows_native, bool without_cell = kIsSanitized) {
  return Permission::decide({.purpose = purpose,
                             .people = Grounds::People::kHere,
                             .allows_native = allows_native,
                             .without_cell = without_cell,
                             .is_trusted = true,
                             .known = nullptr},
                            means());
}

/// `mlab run --allow-native`.
inline Permission all_permitted() {
  return permitted(Grounds::Purpose::kRun, true);
}

/// `mlab run`.
inline Permission code_permitted() {
  return permitted(Grounds::Purpose::kRun, false);
}

/// `mlab run --allow-native --no-cell`.
inline Permission permitted_without_cell() {
  return permitted(Grounds::Purpose::kRun, true, true);
}

/// `mlab run --listen`, begun while these texts lay on disk: of people on other machines.
inline Permission permitted_elsewhere(Texts known) {
  return Permission::decide({.purpose = Grounds::Purpose::kRun,
                             .people = Grounds::People::kElsewhere,
                             .allows_native = false,
                             .without_cell = kIsSanitized,
                             .is_trusted = true,
                             .known = std::make_shared<const Texts>(std::move(known))},
                            means());
}

/// `mlab check`.
inline Permission check_permitted() {
  return permitted(Grounds::Purpose::kCheck, false);
}

}  // namespace mlab::cell::testing
