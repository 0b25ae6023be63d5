#include "mlab/robot/host/shared_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>
#include <utility>

#include <fmt/core.h>

namespace mlab::robot_host {
namespace {

using robot_wire::Control;
using robot_wire::Mapping;
using robot_wire::PlaceHeader;

constexpr std::size_t kFirstPercepts = std::size_t{1} << 18;

std::string system_reason() {
  return std::generic_category().message(errno);
}

void close_file(int& file) {
  if (file >= 0) ::close(file);
  file = -1;
}

// A file in memory that nobody can make smaller under our hands.
int memory_file(const char* name, std::size_t size) {
  int file = memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING);
  if (file < 0) return file;
  if (ftruncate(file, static_cast<off_t>(size)) != 0 ||
      fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_SEAL) != 0)
    close_file(file);
  return file;
}

// Makes the file larger where it is to be, and sees all of it.
bool grow(Mapping& mapping, int file, std::size_t wanted) {
  if (wanted <= mapping.size()) return true;
  wanted = std::bit_ceil(wanted);
  return ftruncate(file, static_cast<off_t>(wanted)) == 0 && mapping.grow(wanted);
}

}  // namespace

std::expected<SharedMemory, std::string> SharedMemory::make(std::size_t frame_size) {
  SharedMemory out;
  out.frame_size_ = frame_size;
  const std::size_t frames_size = robot_wire::kFirstPlace + robot_wire::place_size(frame_size);
  const auto fail = [] { return std::unexpected(fmt::format("no memory to share: {}", system_reason())); };
  out.frames_file_ = memory_file("mlab-frames", frames_size);
  out.percepts_file_ = memory_file("mlab-percepts", kFirstPercepts);
  if (out.frames_file_ < 0 || out.percepts_file_ < 0) return fail();
  out.percepts_for_reading_ =
      open(fmt::format("/proc/self/fd/{}", out.percepts_file_).c_str(), O_RDONLY | O_CLOEXEC);
  if (out.percepts_for_reading_ < 0) return fail();
  out.frames_ = Mapping(out.frames_file_, frames_size, Mapping::May::kWrite);
  out.percepts_ = Mapping(out.percepts_file_, kFirstPercepts, Mapping::May::kWrite);
  if (out.frames_.is_empty() || out.percepts_.is_empty()) return fail();
  out.begin_anew(0);
  return out;
}

void SharedMemory::begin_anew(std::uint32_t cycle) {
  Control& control = *::new (frames_.begin()) Control;
  control.asked.set(cycle);
  control.answered.set(cycle);
  control.frames_size = frames_.size();
  control.percepts_size = percepts_.size();
}

SharedMemory::SharedMemory(SharedMemory&& other) noexcept
    : frame_size_(other.frame_size_),
      frames_file_(std::exchange(other.frames_file_, -1)),
      percepts_file_(std::exchange(other.percepts_file_, -1)),
      percepts_for_reading_(std::exchange(other.percepts_for_reading_, -1)),
      frames_(std::move(other.frames_)),
      percepts_(std::move(other.percepts_)),
      next_(other.next_.load()),
      has_overflow_(other.has_overflow_.load()),
      overflow_(std::move(other.overflow_)) {}

SharedMemory::~SharedMemory() {
  for (int* file : {&frames_file_, &percepts_file_, &percepts_for_reading_}) close_file(*file);
}

bool SharedMemory::make_room(std::size_t places) {
  const std::size_t wanted = robot_wire::kFirstPlace + places * robot_wire::place_size(frame_size_);
  if (!grow(frames_, frames_file_, wanted)) return false;
  control().frames_size = frames_.size();
  return true;
}

PlaceHeader& SharedMemory::header(std::size_t place) {
  return *reinterpret_cast<PlaceHeader*>(frames_.begin() + robot_wire::kFirstPlace +
                                         place * robot_wire::place_size(frame_size_));
}

void SharedMemory::clear_percepts() {
  next_ = 0;
  overflow_.clear();
  has_overflow_ = false;
}

std::uint64_t SharedMemory::add_percepts(const percept::Percepts& percepts) {
  const std::size_t size = (robot_wire::percepts_size(percepts) + 63) / 64 * 64;
  const std::uint64_t at = next_.fetch_add(size);
  if (at + size <= percepts_.size()) {
    robot_wire::write_percepts(percepts, percepts_.begin() + at);
  } else {
    std::vector<std::byte> bytes(size);
    robot_wire::write_percepts(percepts, bytes.data());
    const std::scoped_lock lock(overflow_mutex_);
    overflow_.emplace(at, std::move(bytes));
    has_overflow_.store(true, std::memory_order_release);
  }
  return at;
}

bool SharedMemory::finish_percepts() {
  if (overflow_.empty()) return true;
  if (!grow(percepts_, percepts_file_, next_)) return false;
  control().percepts_size = percepts_.size();
  for (const auto& [at, bytes] : overflow_) std::ranges::copy(bytes, percepts_.begin() + at);
  overflow_.clear();
  has_overflow_ = false;
  return true;
}

}  // namespace mlab::robot_host
