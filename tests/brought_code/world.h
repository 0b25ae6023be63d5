#pragma once

#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

/// What attacks of a test may reach.
namespace mlab::brought_code {

namespace fs = std::filesystem;

inline volatile long marker_of_process = 0;
inline volatile std::sig_atomic_t signals_of_process = 0;

/// The number of a socket that listens, or is sent to; it is there as long as this.
class Ear {
 public:
  Ear(int family, int kind) : socket_(socket(family, kind | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)), kind_(kind) {}
  ~Ear() { close(socket_); }
  Ear(const Ear&) = delete;
  Ear& operator=(const Ear&) = delete;

  template <class Address>
  void open(const Address& address) const {
    ASSERT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ASSERT_TRUE(kind_ != SOCK_STREAM || listen(socket_, 5) == 0);
  }
  int port() const {
    sockaddr_in here{};
    socklen_t size = sizeof here;
    getsockname(socket_, reinterpret_cast<sockaddr*>(&here), &size);
    return ntohs(here.sin_port);
  }
  /// Somebody came, or sent something.
  bool hears() const {
    char byte = 0;
    if (kind_ == SOCK_DGRAM) return recv(socket_, &byte, 1, 0) >= 0;
    const int end = accept(socket_, nullptr, nullptr);
    if (end >= 0) close(end);
    return end >= 0;
  }

 private:
  int socket_;
  int kind_;
};

/// All that attacks may reach, and what shows that one did. One in a process.
class World {
 public:
  World() {
    fs::remove_all(root_);
    for (const char* folder : {"outside", "home", "project"}) fs::create_directories(root_ / folder);
    for (const char* file : {"outside/secret", "outside/whole"})
      std::ofstream(root_ / file) << "the_secret_word\n";
    fs::permissions(root_ / "outside/whole", fs::perms::owner_read | fs::perms::owner_write);
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    tcp_.open(here);
    udp_.open(here);
    sockaddr_un named{};
    named.sun_family = AF_UNIX;
    std::strncpy(named.sun_path, path("socket").c_str(), sizeof named.sun_path - 1);
    unix_.open(named);
    marker_of_process = 0;
    signals_of_process = 0;
    std::signal(SIGUSR1, [](int) { signals_of_process = 1; });
    getrlimit(RLIMIT_CORE, &core_);
    const rlimit some{std::min<rlim_t>(core_.rlim_max, 4096), core_.rlim_max};
    setrlimit(RLIMIT_CORE, &some);
  }
  ~World() {
    setrlimit(RLIMIT_CORE, &core_);
    std::error_code ignored;
    fs::remove_all(root_, ignored);
    fs::remove(shared_memory(), ignored);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  std::string path(const std::string& name) const { return (root_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(root_ / name) << text; }
  /// As parameters of a robot, and as words of C++.
  std::string parameters() const {
    return fmt::format("room = {}, tcp = {}, udp = {}, marker = {}", getpid(), tcp_.port(), udp_.port(),
                       address());
  }
  std::string in_code() const {
    return fmt::format("hostile::World{{{}, {}, {}, {}}}", getpid(), tcp_.port(), udp_.port(), address());
  }

  /// What somebody did to it.
  std::set<std::string> traces() const {
    std::set<std::string> out;
    const auto note = [&](bool is_there, const char* what) {
      if (is_there) out.insert(what);
    };
    for (const char* made : {"made", "home/made", "project/made"})
      note(fs::exists(fs::symlink_status(root_ / made)), "made");
    note(fs::exists(shared_memory()), "made");
    struct stat about{};
    const bool is_whole = stat(path("outside/whole").c_str(), &about) == 0 && about.st_size == 16 &&
                          (about.st_mode & 0777) == 0600;
    note(!is_whole, "changed");
    note(tcp_.hears() || udp_.hears() || unix_.hears(), "heard");
    note(marker_of_process != 0, "marked");
    note(signals_of_process != 0, "signalled");
    rlimit now{};
    getrlimit(RLIMIT_CORE, &now);
    note(now.rlim_cur == 0, "limited");
    return out;
  }

 private:
  static std::uintptr_t address() { return reinterpret_cast<std::uintptr_t>(&marker_of_process); }
  static std::string shared_memory() { return fmt::format("/dev/shm/mlab_hostile_{}", getpid()); }

  fs::path root_ = fmt::format("/tmp/mlab_hostile_{}", getpid());  // attacks.h says so, too
  Ear tcp_{AF_INET, SOCK_STREAM};
  Ear udp_{AF_INET, SOCK_DGRAM};
  Ear unix_{AF_UNIX, SOCK_STREAM};
  rlimit core_{};
};

}  // namespace mlab::brought_code
