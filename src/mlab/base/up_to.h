#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

namespace mlab::base {

/// Some values, N at most, in their order and in place: for lists that are made anew each cycle. What isn't
/// used of the room is never written.
template <class T, std::size_t N>
class UpTo {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  static constexpr std::size_t capacity() { return N; }
  std::size_t size() const { return size_; }
  bool is_full() const { return size_ == N; }
  /// Dropped where there is no room for it.
  void add(const T& value) {
    if (size_ < N) std::construct_at(place(size_++), value);
  }
  const T& operator[](std::size_t i) const { return *place(i); }
  const T* begin() const { return place(0); }
  const T* end() const { return place(0) + size_; }
  std::span<const T> all() const { return {begin(), size_}; }

 private:
  T* place(std::size_t i) { return reinterpret_cast<T*>(room_.data()) + i; }
  const T* place(std::size_t i) const { return reinterpret_cast<const T*>(room_.data()) + i; }

  alignas(T) std::array<std::byte, N * sizeof(T)> room_;
  std::size_t size_ = 0;
};

}  // namespace mlab::base
