#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

namespace mlab::flow {

/// All the values of one robot, contiguous. Copying it is a checkpoint: restored, the robot goes on exactly
/// from there, provided that its percepts are restored as well. Belongs to the program that made it.
class Frame {
 public:
  static constexpr std::size_t kAlignment = 64;

  Frame() = default;
  /// All bytes zero.
  explicit Frame(std::size_t size) : size_(size), bytes_(allocate(size)) {
    if (size > 0) std::memset(bytes_.get(), 0, size);
  }
  Frame(const Frame& other) : size_(other.size_), bytes_(allocate(other.size_)) { copy(other); }
  Frame& operator=(const Frame& other) {
    if (this == &other) return *this;
    if (size_ != other.size_) *this = Frame(other.size_);
    copy(other);
    return *this;
  }
  Frame(Frame&&) noexcept = default;
  Frame& operator=(Frame&&) noexcept = default;
  ~Frame() = default;

  std::byte* data() { return bytes_.get(); }
  const std::byte* data() const { return bytes_.get(); }
  std::size_t size() const { return size_; }

  friend bool operator==(const Frame& a, const Frame& b) {
    return a.size_ == b.size_ && (a.size_ == 0 || std::memcmp(a.data(), b.data(), a.size_) == 0);
  }

 private:
  struct Free {
    void operator()(std::byte* p) const { ::operator delete(p, std::align_val_t{kAlignment}); }
  };
  using Bytes = std::unique_ptr<std::byte[], Free>;

  static Bytes allocate(std::size_t size) {
    return Bytes(size == 0 ? nullptr
                           : static_cast<std::byte*>(::operator new(size, std::align_val_t{kAlignment})));
  }
  void copy(const Frame& other) {
    if (size_ > 0) std::memcpy(bytes_.get(), other.bytes_.get(), size_);
  }

  std::size_t size_ = 0;
  Bytes bytes_;
};

}  // namespace mlab::flow
