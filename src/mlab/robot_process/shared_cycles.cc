#include "mlab/robot_process/shared_cycles.h"

#include <linux/futex.h>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <ctime>
#include <utility>

namespace mlab::robot_process {
namespace {

using robot_wire::Control;
using robot_wire::PlaceHeader;

// So often it looks whether there is a new cycle before it sleeps: some ten microseconds.
constexpr int kLooks = 4000;
constexpr int kYieldEvery = 400;  // the run may need this processor

// Like futex(2) on a word that two processes share.
int32_t futex(std::atomic<std::uint32_t>& word, int operation, std::uint32_t value, const timespec* timeout) {
  return static_cast<int32_t>(syscall(SYS_futex, &word, operation, value, timeout, nullptr, 0));
}

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

bool has_ended(int in) {
  pollfd input{in, POLLIN, 0};
  return poll(&input, 1, 0) > 0 && (input.revents & (POLLHUP | POLLERR | POLLNVAL | POLLIN)) != 0;
}

// False: nobody will ask any more.
bool wait_for_cycle(Control& control, std::uint32_t last, int in) {
  for (int look = 1; look <= kLooks; ++look) {
    if (control.asked.load(std::memory_order_acquire) != last) return true;
    if (look % kYieldEvery == 0) sched_yield();
    relax();
  }
  constexpr timespec kPatience{1, 0};
  while (control.asked.load(std::memory_order_acquire) == last) {
    control.program_sleeps.store(1);
    if (control.asked.load() == last) futex(control.asked, FUTEX_WAIT, last, &kPatience);
    control.program_sleeps.store(0);
    if (control.asked.load() == last && has_ended(in)) return false;
  }
  return true;
}

void answer(Control& control, std::uint32_t cycle) {
  control.answered.store(cycle);
  if (control.run_sleeps.load() != 0) futex(control.answered, FUTEX_WAKE, 1, nullptr);
}

std::byte* mapped(int file, std::size_t size, int protection) {
  void* at = mmap(nullptr, size, protection, MAP_SHARED, file, 0);
  return at == MAP_FAILED ? nullptr : static_cast<std::byte*>(at);
}

bool grow_mapping(std::byte*& at, std::size_t& size, std::size_t wanted) {
  if (wanted <= size) return true;
  void* moved = mremap(at, size, wanted, MREMAP_MAYMOVE);
  if (moved == MAP_FAILED) return false;
  at = static_cast<std::byte*>(moved);
  size = wanted;
  return true;
}

}  // namespace

std::expected<SharedFiles, std::string> SharedFiles::open(int frames, int percepts) {
  struct stat about_frames{};
  struct stat about_percepts{};
  SharedFiles out;
  if (fstat(frames, &about_frames) != 0 || fstat(percepts, &about_percepts) != 0 ||
      static_cast<std::size_t>(about_frames.st_size) < robot_wire::kFirstPlace || about_percepts.st_size <= 0)
    return std::unexpected("nothing is shared with this program");
  out.frames_size_ = static_cast<std::size_t>(about_frames.st_size);
  out.percepts_size_ = static_cast<std::size_t>(about_percepts.st_size);
  out.control_ = reinterpret_cast<Control*>(mapped(frames, robot_wire::kFirstPlace, PROT_READ | PROT_WRITE));
  out.frames_ = mapped(frames, out.frames_size_, PROT_READ | PROT_WRITE);
  out.percepts_ = mapped(percepts, out.percepts_size_, PROT_READ);
  if (out.control_ == nullptr || out.frames_ == nullptr || out.percepts_ == nullptr)
    return std::unexpected("what is shared with this program can't be mapped");
  return out;
}

SharedFiles::SharedFiles(SharedFiles&& other) noexcept
    : control_(std::exchange(other.control_, nullptr)),
      frames_(std::exchange(other.frames_, nullptr)),
      frames_size_(other.frames_size_),
      percepts_(std::exchange(other.percepts_, nullptr)),
      percepts_size_(other.percepts_size_) {}

SharedFiles::~SharedFiles() {
  if (control_ != nullptr) munmap(control_, robot_wire::kFirstPlace);
  if (frames_ != nullptr) munmap(frames_, frames_size_);
  if (percepts_ != nullptr) munmap(percepts_, percepts_size_);
}

bool SharedFiles::grow() {
  const std::size_t frames = control().frames_size;
  const std::size_t percepts = control().percepts_size;
  return grow_mapping(frames_, frames_size_, frames) && grow_mapping(percepts_, percepts_size_, percepts);
}

int serve_shared(SharedFiles& files, const flow::Program& program, int in) {
  robot_wire::ReadPercepts read;
  const std::size_t size = robot_wire::place_size(program.frame_size());
  std::uint32_t done = files.control().answered.load();
  while (wait_for_cycle(files.control(), done, in)) {
    done = files.control().asked.load(std::memory_order_acquire);
    if (!files.grow()) return 1;
    for (std::uint32_t i = 0; i < files.control().count; ++i) {
      std::byte* const place = files.place(i, size);
      auto& header = *reinterpret_cast<PlaceHeader*>(place);
      files.control().place.store(i, std::memory_order_relaxed);
      percept::Action action;
      program.step(place + sizeof(PlaceHeader), read.read(files.percepts(header.percepts)), action,
                   header.seed, header.robot);
      std::memcpy(header.action.data(), &action, sizeof action);
    }
    files.control().place.store(Control::kNobody, std::memory_order_relaxed);
    answer(files.control(), done);
  }
  return 0;
}

}  // namespace mlab::robot_process
