#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "connection.h"
#include "link.h"
#include "process.h"
#include "relay.h"
#include "seen.h"

namespace mlab::network {

struct HostSetup {
  std::string name = {};  ///< other hosts know it by this
  Duration uptime{
      0};  ///< that its monotonic clock is ahead of this machine's; machines started at different times
};

/// A machine of a TestNetwork, out of namespaces: it has a network, processes with numbers of their own, /tmp
/// and /dev/shm of its own (both empty at first), a monotonic and a wall clock. All other files are this
/// machine's, and so are its users. One thread at a time, but for signals and what says otherwise.
class Host {
 public:
  /// By TestNetwork.
  Host(KeeperSetup setup, Relay& relay, std::shared_ptr<EventLoop> loop);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  const std::string& name() const;
  int number() const { return setup_.number; }
  std::string address() const;

  /// @param command  its program, searched as a shell does, and its words
  Process start(const std::vector<std::string>& command, const ProcessSetup& setup = {});
  /// All that runs on it, whoever started it.
  std::vector<Seen> processes() const;

  /// How the test itself gets at a file of the host.
  std::filesystem::path path(const std::filesystem::path& on_host) const;
  /// Puts a disk of so many bytes (whole pages) at a folder, which is made where it is missing; what is
  /// written beyond fails with ENOSPC. Goes with the host's power.
  /// @return  why it could not; empty: it could
  std::string mount_disk(const std::string& folder, std::size_t bytes);
  /// From now on the wall clock is ahead of this machine's by so much (or behind it), for processes that were
  /// started with `follows_clock`, those that run, too. From any thread.
  void set_clock(Duration ahead);

  /// Kills all at once. /tmp, /dev/shm, small disks and the clock are as of a new machine when it comes back.
  void power_off();
  /// @errors  std::runtime_error
  void power_on();
  bool is_on() const { return connection_ != nullptr && connection_->is_open(); }

  /// What its processes should have cleaned up, in words: files in /tmp and /dev/shm, and processes whose
  /// parent has ended. Those that were started by start() are none of them, nor what runs under them.
  std::vector<std::string> leftovers() const;
  /// What its kernel dropped because the machine was too busy, not by seed: frames that the relay did not
  /// come to take, and datagrams that a program did not come to read. A test that counts packets wants 0.
  std::uint64_t overruns() const;
  /// Of its first process; `processes_in` finds who is there.
  std::string network_namespace() const { return network_namespace_; }

 private:
  /// The clock's file, in memory of host and test.
  void map_clock();
  void unmap_clock();

  KeeperSetup setup_;
  Relay& relay_;
  std::shared_ptr<EventLoop> loop_;
  std::shared_ptr<Connection> connection_;
  std::string network_namespace_;
  std::vector<Victim> started_;
  std::mutex clock_mutex_;
  std::int64_t* clock_ = nullptr;  ///< [ns]
};

}  // namespace mlab::network
