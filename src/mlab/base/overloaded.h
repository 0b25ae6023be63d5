#pragma once

namespace mlab::base {

/// Several functions as one, for `std::visit`: each takes one of the kinds.
template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

}  // namespace mlab::base
