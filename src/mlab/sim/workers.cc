#include "mlab/sim/workers.h"

#include <algorithm>
#include <optional>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace mlab::sim {

struct Workers::Arena {
  explicit Arena(int threads) : arena(threads) {
    // More threads than cores are of no use, but who asks for them gets them.
    if (threads > tbb::info::default_concurrency()) {
      more_than_cores.emplace(tbb::global_control::max_allowed_parallelism,
                              static_cast<std::size_t>(threads));
    }
  }
  std::optional<tbb::global_control> more_than_cores;
  tbb::task_arena arena;
};

Workers::Workers(int threads) : count_(std::max(1, threads)) {
  if (count_ > 1) arena_ = std::make_unique<Arena>(count_);
}

Workers::~Workers() = default;

void Workers::run_erased(std::size_t count, std::size_t piece, void* callee, Erased call) {
  if (count == 0) return;
  if (!arena_ || count <= piece) {
    call(callee, 0, count, 0);
    return;
  }
  arena_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, piece),
        [&](const tbb::blocked_range<std::size_t>& range) {
          call(callee, range.begin(), range.end(), tbb::this_task_arena::current_thread_index());
        },
        tbb::simple_partitioner());
  });
}

}  // namespace mlab::sim
