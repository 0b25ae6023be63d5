#pragma once

#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/flow/library.h"
#include "mlab/flow/port_types.h"
#include "mlab/flow/probe.h"
#include "mlab/library/library.h"

namespace mlab::library_test {

inline void expect_near(geom::Vector a, geom::Vector b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
}

/// A heading [rad].
inline constexpr double kNorth = std::numbers::pi / 2.0;

/// The component library, made once.
inline const flow::Library& library() {
  static const flow::Library kMade = [] {
    flow::Library library;
    flow::add_port_types(library);
    library.add(mlab_library_behaviors());
    return library;
  }();
  return kMade;
}

/// The behavior of that name or historic name. Ends the test program where there is none.
inline const flow::Behavior& behavior(std::string_view name) {
  const flow::Behavior* found = library().find(name).behavior;
  if (found == nullptr) {
    fmt::print(stderr, "no behavior `{}` in the library\n", name);
    std::abort();
  }
  return *found;
}

/// A probe of that behavior.
inline flow::BehaviorProbe probe(std::string_view name) {
  return flow::BehaviorProbe(behavior(name));
}

/// The requests of that kind that were asked for.
inline std::vector<percept::Request> asked(const flow::BehaviorProbe& p, percept::Request::Kind kind) {
  std::vector<percept::Request> out;
  for (std::uint8_t i = 0; i < p.action.request_count; ++i) {
    if (p.action.requests[i].kind == kind) out.push_back(p.action.requests[i]);
  }
  return out;
}

/// On wires: the first `count` readings of the cycle.
template <class List>
List all(std::size_t count) {
  List list;
  for (std::size_t i = 0; i < count; ++i) list.add(i);
  return list;
}

}  // namespace mlab::library_test
