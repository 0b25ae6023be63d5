#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace mlab::binding {

/// A fixed number of threads that share out loops. With one thread everything runs on the caller's.
class Workers {
 public:
  /// @param threads  >= 1; smaller counts as 1
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int count() const { return count_; }

  /// Calls body(begin, end, worker) for pieces of 0 .. count - 1 until all are done, in any order, on all
  /// threads. `worker` is below count() and never used by two threads at a time: an index for scratch memory.
  /// The pieces differ from run to run, so what body writes must depend on the element alone.
  template <class Body>
  void run(std::size_t count, std::size_t piece, Body&& body) {
    using Callee = std::remove_reference_t<Body>;
    run_erased(count, piece, const_cast<void*>(static_cast<const void*>(&body)),
               [](void* callee, std::size_t begin, std::size_t end, int worker) {
                 (*static_cast<Callee*>(callee))(begin, end, worker);
               });
  }

 private:
  using Erased = void (*)(void* callee, std::size_t begin, std::size_t end, int worker);
  void run_erased(std::size_t count, std::size_t piece, void* callee, Erased call);

  struct Arena;  // oneTBB's headers stay in one translation unit
  int count_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace mlab::binding
