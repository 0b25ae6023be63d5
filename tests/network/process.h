#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "connection.h"
#include "link.h"
#include "output.h"
#include "victim.h"

namespace mlab::network {

/// How a process ended.
struct Ending {
  std::optional<int> status = {};  ///< its exit status
  int signal = 0;                  ///< or the one that killed it
  bool went_with_host = false;     ///< nobody knows: its host's power went

  bool is_success() const { return status == 0; }
  /// `exit status 3`, `killed by SIGKILL`.
  std::string words() const;
};

/// How one is started.
struct ProcessSetup {
  /// What differs from the test's own environment; an empty value: the name is not there.
  std::vector<std::pair<std::string, std::string>> environment = {};
  std::string folder = {};  ///< that it begins in, on the host; empty: /
  bool follows_clock =
      false;  ///< its wall clock is that which Host::set_clock sets; see shifted_clock.cc for how far
};

/// A process on a host, in a session of its own. With this object it ends, and all that it started. One
/// thread at a time, except for signal().
class Process {
 public:
  /// By Host::start.
  Process(std::shared_ptr<Connection> host, std::shared_ptr<EventLoop> loop,
          const std::vector<std::string>& command, const ProcessSetup& setup);
  ~Process();
  Process(Process&&) = default;
  Process& operator=(Process&&) = delete;

  /// That of its program, without folders.
  const std::string& name() const { return name_; }
  /// The machine's number; -1: it could not be started.
  pid_t id() const { return victim_.id(); }
  const Victim& victim() const { return victim_; }

  /// What it has written so far.
  std::string output() const;
  std::string errors() const;
  /// Waits until it has written this to one of the two.
  bool prints(std::string_view text, Duration limit) const { return output_->has(text, limit); }
  /// To its standard input, which is open until it is closed.
  bool write(std::string_view text);
  void close_input() { input_.close(); }

  bool signal(int number) const { return victim_.signal(number); }
  bool is_running() { return !wait(Duration(0)); }
  /// @return  nothing: it is still there after this time. One that could not be started ended with status 127
  ///          and the reason among its errors, as of a shell.
  std::optional<Ending> wait(Duration limit);
  /// Kills it, and all that it started.
  void end();

 private:
  std::string name_;
  std::string failure_;  ///< why it could not be started
  std::shared_ptr<Connection> host_;
  std::shared_ptr<EventLoop> loop_;
  std::string id_on_host_;
  Victim victim_;
  Descriptor input_;
  Descriptor status_;
  std::unique_ptr<Output> output_;
  std::optional<Ending> ending_;
};

}  // namespace mlab::network
