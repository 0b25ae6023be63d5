#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/designer/latest_jobs.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::designer {

/// What compiling a configuration found.
struct Compiled {
  text::SourcePtr source;  ///< that was compiled
  text::Diagnostics problems;
  std::vector<std::vector<assist::Fix>> fixes;  ///< of each problem; shorter where they were not looked for
  double took_ms = 0.0;                         ///< without looking for mends
  std::string code;                             ///< which C++ it uses; empty: none
};

/// What the C++ compiler says of the procedures that a configuration uses.
struct CheckedCode {
  std::string code;  ///< as Compiled::code
  text::Diagnostics problems;
};

/// Compiles configurations in the background, all robots of them down to their programs, and gives the C++ of
/// what they use to the compiler. The newest text of a document wins; the C++ compiler, which takes its time,
/// never makes the rest wait. Functions may be called from any thread and return at once.
class Compiler {
 public:
  struct Task {
    std::string document;
    text::SourcePtr source;
    std::shared_ptr<const text::Files> files;  ///< what it may use; read on other threads
  };
  /// Called on threads of the compiler. First without mends, then with them.
  using TakeCompiled = std::function<void(const std::string& document, std::shared_ptr<const Compiled>)>;
  using TakeCode = std::function<void(const std::string& document, std::shared_ptr<const CheckedCode>)>;

  /// @param programs  where headers are, and whether C++ may be given to the compiler
  Compiler(robot::ProgramSources programs, TakeCompiled found, TakeCode found_code);

  /// Jobs that are being done end soon: a C++ compiler at work is stopped.
  ~Compiler() { ends_.request_stop(); }
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;

  void start(Task task);

 private:
  void compile(const Task& task, const LatestJobs::IsStale& is_stale);
  void check_code(const Task& task, const std::string& code);
  robot::ProgramSources programs_of(const Task& task, bool checks_code) const;

  std::stop_source ends_;
  const robot::ProgramSources programs_;
  const TakeCompiled found_;
  const TakeCode found_code_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const CheckedCode>, std::less<>> checked_;  // by the code
  LatestJobs codes_;
  LatestJobs configurations_;  // ends first: it starts what codes_ does
};

}  // namespace mlab::designer
