// Preloaded into programs of tests (LD_PRELOAD): a wall clock that is ahead of the machine's by as many
// nanoseconds as the file MLAB_CLOCK_FILE says at that moment, which may change while the program runs. Linux
// has no CLOCK_REALTIME for each namespace.
//
// What follows it: clock_gettime, gettimeofday, time and timespec_get, so also std::chrono::system_clock; and
// waiting for a moment of the wall clock: condition variables, mutexes, semaphores, clock_nanosleep. A wait
// for which the clock is set goes on for longer, or ends, as it would. What does not: system calls made
// directly, timerfd and timer_settime with absolute moments of CLOCK_REALTIME, times of files, programs that
// are linked statically or are started without LD_PRELOAD (robots in their cells).

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <semaphore.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <ctime>

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kSlice = 50'000'000;  // after so long a wait looks whether the clock was set [ns]

std::int64_t* open_file() {
  const char* const path =
      std::getenv("MLAB_CLOCK_FILE");  // NOLINT(concurrency-mt-unsafe): before there are threads
  const int file = path == nullptr ? -1 : ::open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return nullptr;
  void* const memory = ::mmap(nullptr, sizeof(std::int64_t), PROT_READ, MAP_SHARED, file, 0);
  ::close(file);
  return memory == MAP_FAILED ? nullptr : static_cast<std::int64_t*>(memory);
}

std::int64_t offset() {
  static std::int64_t* const kFile = open_file();
  return kFile == nullptr ? 0 : __atomic_load_n(kFile, __ATOMIC_RELAXED);
}

bool is_wall(clockid_t clock) {
  return clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE || clock == CLOCK_TAI;
}

timespec split(std::int64_t nanoseconds) {
  std::int64_t seconds = nanoseconds / kSecond;
  std::int64_t rest = nanoseconds % kSecond;
  if (rest < 0) {
    --seconds;
    rest += kSecond;
  }
  return {seconds, rest};
}

std::int64_t joined(const timespec& time) {
  return time.tv_sec * kSecond + time.tv_nsec;
}

// Not by the name that others find this library under.
template <class Function>
Function* next(const char* name, const char* version = nullptr) {
  void* found = version == nullptr ? nullptr : ::dlvsym(RTLD_NEXT, name, version);
  if (found == nullptr) found = ::dlsym(RTLD_NEXT, name);
  return reinterpret_cast<Function*>(found);
}

int machine_time(clockid_t clock, timespec* out) {
  static auto* const kReal = next<int(clockid_t, timespec*)>("clock_gettime");
  return kReal(clock, out);
}

std::int64_t wall_now() {
  timespec now{};
  machine_time(CLOCK_REALTIME, &now);
  return joined(now) + offset();
}

/// Until when to wait now, of the machine's wall clock, for a moment of the shifted one.
struct Slice {
  explicit Slice(const timespec& until) {
    const std::int64_t left = joined(until) - wall_now();
    is_last = left <= kSlice;
    timespec now{};
    machine_time(CLOCK_REALTIME, &now);
    end = split(joined(now) + (is_last ? left : kSlice));
  }
  bool is_last = false;
  timespec end{};
};

// `wait` gives ETIMEDOUT where its time is over, as pthread functions do.
template <class Wait>
int wait_in_slices(const timespec* until, Wait wait) {
  for (;;) {
    const Slice slice(*until);
    const int result = wait(&slice.end);
    if (result != ETIMEDOUT || slice.is_last) return result;
  }
}

// Whoever woke others while nobody waited is not heard by a second wait: as if it had been for nothing, which
// may happen at any time.
template <class Wait>
int wait_one_slice(const timespec* until, Wait wait) {
  const Slice slice(*until);
  const int result = wait(&slice.end);
  return result == ETIMEDOUT && !slice.is_last ? 0 : result;
}

bool is_monotonic(const pthread_cond_t* condition) {
  constexpr unsigned kMonotonic = 2;  // as glibc keeps it: nptl/pthread_cond_common.c, COND_CLOCK_MONOTONIC
  return (condition->__data.__wrefs & kMonotonic) != 0;
}

#if defined(__x86_64__)
constexpr const char* kConditionVersion = "GLIBC_2.3.2";  // the default is one of Linux 2.4's threads
#else
constexpr const char* kConditionVersion = nullptr;
#endif

}  // namespace

// The standard library's own names.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" {

int clock_gettime(clockid_t clock, timespec* out) {
  const int result = machine_time(clock, out);
  if (result == 0 && is_wall(clock)) *out = split(joined(*out) + offset());
  return result;
}

int gettimeofday(timeval* out, void*) {
  const timespec now = split(wall_now());
  *out = {now.tv_sec, now.tv_nsec / 1000};
  return 0;
}

time_t time(time_t* out) {
  const time_t now = split(wall_now()).tv_sec;
  if (out != nullptr) *out = now;
  return now;
}

int timespec_get(timespec* out, int base) {
  if (base != TIME_UTC) return 0;
  *out = split(wall_now());
  return base;
}

int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex, const timespec* until) {
  static auto* const kReal = next<int(pthread_cond_t*, pthread_mutex_t*, const timespec*)>(
      "pthread_cond_timedwait", kConditionVersion);
  if (is_monotonic(condition)) return kReal(condition, mutex, until);
  return wait_one_slice(until, [&](const timespec* end) { return kReal(condition, mutex, end); });
}

int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                           const timespec* until) {
  static auto* const kReal =
      next<int(pthread_cond_t*, pthread_mutex_t*, clockid_t, const timespec*)>("pthread_cond_clockwait");
  if (!is_wall(clock)) return kReal(condition, mutex, clock, until);
  return wait_one_slice(until, [&](const timespec* end) { return kReal(condition, mutex, clock, end); });
}

int pthread_mutex_timedlock(pthread_mutex_t* mutex, const timespec* until) {
  static auto* const kReal = next<int(pthread_mutex_t*, const timespec*)>("pthread_mutex_timedlock");
  return wait_in_slices(until, [&](const timespec* end) { return kReal(mutex, end); });
}

int sem_timedwait(sem_t* semaphore, const timespec* until) {
  static auto* const kReal = next<int(sem_t*, const timespec*)>("sem_timedwait");
  const int failure =
      wait_in_slices(until, [&](const timespec* end) { return kReal(semaphore, end) == 0 ? 0 : errno; });
  if (failure != 0) errno = failure;
  return failure == 0 ? 0 : -1;
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* request, timespec* remaining) {
  static auto* const kReal = next<int(clockid_t, int, const timespec*, timespec*)>("clock_nanosleep");
  if (!is_wall(clock) || (flags & TIMER_ABSTIME) == 0) return kReal(clock, flags, request, remaining);
  const int result = wait_in_slices(request, [&](const timespec* end) {
    const int failure = kReal(clock, flags, end, remaining);
    return failure == 0 ? ETIMEDOUT : failure;
  });
  return result == ETIMEDOUT ? 0 : result;
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
