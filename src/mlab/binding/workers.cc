#include "mlab/binding/workers.h"

#include <algorithm>
#include <optional>

#ifdef MLAB_SANITIZE_THREAD
#include <atomic>
#include <thread>
#include <vector>
#else
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace mlab::binding {

#ifdef MLAB_SANITIZE_THREAD

/// The thread sanitizer can't see how oneTBB, which isn't built with it, orders its tasks, and would report
/// nearly everything. So what runs under it are threads that it understands.
struct Workers::Arena {
  explicit Arena(int wanted) : threads(static_cast<std::size_t>(wanted)) {}

  void run(std::size_t count, std::size_t piece, void* callee, Erased call) const {
    std::atomic<std::size_t> next = 0;
    const auto work = [&](std::size_t worker) {
      for (;;) {
        const std::size_t begin = next.fetch_add(piece, std::memory_order_relaxed);
        if (begin >= count) return;
        call(callee, begin, std::min(count, begin + piece), static_cast<int>(worker));
      }
    };
    std::vector<std::jthread> others;
    for (std::size_t worker = 1; worker < threads; ++worker) others.emplace_back(work, worker);
    work(0);
  }
  std::size_t threads;
};

#else

struct Workers::Arena {
  explicit Arena(int threads) : arena(threads) {
    // More threads than cores are of no use, but who asks for them gets them.
    if (threads > tbb::info::default_concurrency()) {
      more_than_cores.emplace(tbb::global_control::max_allowed_parallelism,
                              static_cast<std::size_t>(threads));
    }
  }

  void run(std::size_t count, std::size_t piece, void* callee, Erased call) {
    arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, count, piece),
          [&](const tbb::blocked_range<std::size_t>& range) {
            call(callee, range.begin(), range.end(), tbb::this_task_arena::current_thread_index());
          },
          tbb::simple_partitioner());
    });
  }
  std::optional<tbb::global_control> more_than_cores;
  tbb::task_arena arena;
};

#endif

Workers::Workers(int threads) : count_(std::max(1, threads)) {
  if (count_ > 1) arena_ = std::make_unique<Arena>(count_);
}

Workers::~Workers() = default;

void Workers::run_erased(std::size_t count, std::size_t piece, void* callee, Erased call) {
  if (count == 0) return;
  if (!arena_ || count <= piece) {
    call(callee, 0, count, 0);
  } else {
    arena_->run(count, piece, callee, call);
  }
}

}  // namespace mlab::binding
