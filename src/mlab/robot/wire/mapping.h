#pragma once

#include <cstddef>
#include <utility>

namespace mlab::robot_wire {

/// A file that two processes share, as this one sees it in its memory.
class Mapping {
 public:
  enum class May { kRead, kWrite };

  Mapping() = default;
  /// The first `size` bytes of a file; empty where the system refuses, which errno says.
  Mapping(int file, std::size_t size, May may);

  Mapping(Mapping&& other) noexcept
      : begin_(std::exchange(other.begin_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  Mapping& operator=(Mapping&& other) noexcept {
    std::swap(begin_, other.begin_);
    std::swap(size_, other.size_);
    return *this;
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;
  ~Mapping();

  bool is_empty() const { return begin_ == nullptr; }
  std::byte* begin() const { return begin_; }
  std::size_t size() const { return size_; }

  /// Sees this much of the file, which may be elsewhere then. False: it can't, and what was seen stays.
  bool grow(std::size_t wanted);

 private:
  std::byte* begin_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace mlab::robot_wire
