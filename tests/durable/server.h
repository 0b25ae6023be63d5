#pragma once

#include <sys/types.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace mlab::durable {

/// An `mlab` that serves pages, in a process of its own. Killed with this, unless it has ended.
class Server {
 public:
  struct Setup {
    std::vector<std::string> arguments;              ///< `run`, `m.mdl`
    std::string folder;                              ///< where it is started
    std::map<std::string, std::string> environment;  ///< changed variables; empty: not set
    std::function<bool()> before = {};               ///< in the new process, first; false: it ends with 97
    bool is_on_any_port = true;                      ///< else where it chooses
  };
  /// Starts it on any port, and waits for the address that it prints, or for its end.
  explicit Server(const Setup& setup);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// 0: it printed no address.
  int port() const { return port_; }
  const std::string& token() const { return token_; }
  /// What it has printed up to now, errors included.
  const std::string& printed() const { return printed_; }
  /// Reads on until it has printed this; false where it ends first, or does not in half a minute.
  bool prints(const std::string& text);
  /// As `kill -9`.
  void kill();
  /// As Ctrl-C. @return its exit status
  int end();

 private:
  bool read_more(double seconds);
  int wait();

  pid_t process_ = -1;
  int output_ = -1;
  std::string printed_;
  int port_ = 0;
  std::string token_;
};

}  // namespace mlab::durable
