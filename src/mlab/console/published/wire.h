#pragma once

#include <bit>
#include <string>
#include <type_traits>

namespace mlab::console {

// Packed values in `bytes` fields are little endian, and so are all machines that this runs on.
static_assert(std::endian::native == std::endian::little);

/// Appends a number, or a packed record of numbers, as it stands in memory.
template <class T>
void append(std::string& bytes, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace mlab::console
