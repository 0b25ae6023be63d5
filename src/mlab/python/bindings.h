#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <unistd.h>

#include <chrono>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "mlab/cell/permission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::python {

namespace py = pybind11;

/// Problems as `mlab.Error`, with the place of each.
[[noreturn]] void raise(const text::Diagnostics& problems);
[[noreturn]] void raise(const text::Diagnostic& problem);
/// One that is a sentence.
[[noreturn]] void raise(const std::string& sentence);
/// Warnings, and what people should know, as dictionaries.
py::list said_of(const text::Diagnostics& sink);

/// Where Python ends while other threads still compute, those stay where they are: what they would go on with
/// is being taken away.
inline void stay_where_python_ends() {
  while (_Py_IsFinalizing() != 0) ::pause();
}

/// Asks Python, every now and then, whether a signal has come whose handler raises something, as Ctrl-C does.
class Signals {
 public:
  /// Without the interpreter's lock. Python handles signals on its main thread; on others nobody ever wants
  /// an end.
  bool wants_end() {
    stay_where_python_ends();
    if (has_raised_ || !is_on_main_thread_) return has_raised_;
    const auto now = std::chrono::steady_clock::now();
    if (now - asked_ < kBetween) return false;
    asked_ = now;
    const py::gil_scoped_acquire locked;
    has_raised_ = PyErr_CheckSignals() != 0;
    return has_raised_;
  }
  /// With the lock: goes on with what was raised.
  void raise_again() const {
    if (has_raised_) throw py::error_already_set();
  }

 private:
  static constexpr auto kBetween = std::chrono::milliseconds(30);
  std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();
  const bool is_on_main_thread_ = gettid() == getpid();
  bool has_raised_ = false;
};

/// Does what may take long while Python's other threads go on.
/// @param work  takes Signals&
template <class Work>
auto without_lock(Work work) {
  Signals signals;
  std::optional<decltype(work(signals))> out;
  std::exception_ptr failure;
  // Not pybind11's own guard: where Python ends, its destructor would end the process.
  PyThreadState* const state = PyEval_SaveThread();
  try {
    out.emplace(work(signals));
  } catch (...) {
    failure = std::current_exception();
  }
  stay_where_python_ends();
  PyEval_RestoreThread(state);
  if (failure) std::rethrow_exception(failure);
  signals.raise_again();
  return std::move(*out);
}

/// The same on a thread of its own, for work that does not ask anybody.
/// @param work  takes a std::stop_token, which says when nobody waits for it any more
template <class Work>
auto beside(Work work) {
  return without_lock([&](Signals& signals) {
    // A source of its own: programs keep the token, and a thread that ends stops its own one.
    std::stop_source ends;
    std::packaged_task<decltype(work(std::stop_token{}))()> task([&] { return work(ends.get_token()); });
    auto out = task.get_future();
    const std::jthread thread(std::move(task));
    while (out.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) {
      if (signals.wants_end()) ends.request_stop();
    }
    return out.get();
  });
}

/// Lets one thread at a time, of the process that made it, use something.
class OneUser {
 public:
  /// @errors  RuntimeError: another thread uses it; this process was forked from the one that made it
  std::unique_lock<std::mutex> take(const char* what) {
    if (getpid() != owner_)
      throw std::runtime_error(std::string(what) +
                               " belongs to the process that this one was forked from; make "
                               "one here");
    std::unique_lock out(mutex_, std::try_to_lock);
    if (!out) throw std::runtime_error(std::string(what) + " is in use by another thread");
    return out;
  }
  bool is_here() const { return getpid() == owner_; }

 private:
  std::mutex mutex_;
  pid_t owner_ = getpid();
};

/// In a process that was forked, robots' processes are still those of the one that it was forked from, so
/// what belongs to them is left alone.
template <class Owned>
void leave_where_forked(const OneUser& user, std::unique_ptr<Owned>& owned) {
  if (user.is_here()) return;
  [[maybe_unused]] const Owned* const left = owned.release();
}

/// An array of its own: nothing in it changes any more, and it lives as long as somebody has it.
inline py::array_t<double> array_of(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

class MissionFile;
/// Of a `_core.Mission`.
const MissionFile& file_of(const py::object& mission);

// What each of them adds to the module.
void bind_missions(py::module_& module);
void bind_batches(py::module_& module);
void bind_stages(py::module_& module);

/// What files bring may be done with, as the command decides.
cell::Permission permission_for(const std::string& path, bool allows_native, bool has_cell);

}  // namespace mlab::python
