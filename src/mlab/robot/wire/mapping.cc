#include "mlab/robot/wire/mapping.h"

#include <sys/mman.h>

namespace mlab::robot_wire {

Mapping::Mapping(int file, std::size_t size, May may) {
  void* at =
      mmap(nullptr, size, may == May::kWrite ? PROT_READ | PROT_WRITE : PROT_READ, MAP_SHARED, file, 0);
  if (at == MAP_FAILED) return;
  begin_ = static_cast<std::byte*>(at);
  size_ = size;
}

Mapping::~Mapping() {
  if (begin_ != nullptr) munmap(begin_, size_);
}

bool Mapping::grow(std::size_t wanted) {
  if (wanted <= size_) return true;
  void* moved = mremap(begin_, size_, wanted, MREMAP_MAYMOVE);
  if (moved == MAP_FAILED) return false;
  begin_ = static_cast<std::byte*>(moved);
  size_ = wanted;
  return true;
}

}  // namespace mlab::robot_wire
