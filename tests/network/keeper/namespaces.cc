#include "keeper/namespaces.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "address.h"
#include "descriptor.h"
#include "keeper/failure.h"

namespace mlab::network {
namespace {

namespace fs = std::filesystem;

constexpr int kNewTime = 0x00000080;  // CLONE_NEWTIME, which not every <sched.h> has
constexpr int kOfHost = CLONE_NEWNET | CLONE_NEWNS | CLONE_NEWIPC | CLONE_NEWUTS | CLONE_NEWPID;

void write_file(const std::string& path, const std::string& text) {
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  check(file.is_open() && ::write(file.number(), text.data(), text.size()) >= 0, "writing " + path);
}

void enter_user_namespace() {
  const std::string user = std::to_string(::geteuid());
  const std::string group = std::to_string(::getegid());
  check(::unshare(CLONE_NEWUSER) == 0, "making a user namespace");
  write_file("/proc/self/setgroups", "deny");
  write_file("/proc/self/uid_map", user + " " + user + " 1");
  write_file("/proc/self/gid_map", group + " " + group + " 1");
}

// In a chroot `/` need not be a mount; then each that can be seen is asked.
void keep_mounts_private() {
  if (::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0) return;
  std::ifstream mounts("/proc/self/mountinfo");
  for (std::string line; std::getline(mounts, line);) {
    std::istringstream words(line);
    std::string skipped;
    std::string place;
    words >> skipped >> skipped >> skipped >> skipped >> place;
    check(::mount(nullptr, place.c_str(), nullptr, MS_PRIVATE, nullptr) == 0,
          "keeping " + place + " private");
  }
}

void mount_memory(const char* folder, const char* options) {
  check(::mount("host", folder, "tmpfs", MS_NOSUID | MS_NODEV, options) == 0,
        std::string("mounting ") + folder);
}

// They are held open while /tmp is hidden, and shown in the new one at their old places.
void make_temporary_files(const KeeperSetup& setup) {
  std::vector<std::pair<std::string, Descriptor>> shared;
  for (const std::string& folder : setup.shared) {
    Descriptor file(::open(folder.c_str(), O_PATH | O_CLOEXEC));
    check(file.is_open(), "sharing " + folder);
    shared.emplace_back(folder, std::move(file));
  }
  mount_memory("/tmp", "mode=1777");
  for (const auto& [folder, file] : shared) {
    fs::create_directories(folder);
    const std::string from = "/proc/self/fd/" + std::to_string(file.number());
    check(::mount(from.c_str(), folder.c_str(), nullptr, MS_BIND | MS_REC, nullptr) == 0,
          "sharing " + folder);
  }
}

// Shown in place of one of the machine's, where that has one.
void replace_file(const char* path, const std::string& text) {
  const fs::path ours = kHarnessFolder / fs::path(path).filename();
  std::ofstream(ours) << text;
  if (::access(path, F_OK) != 0) return;
  check(::mount(ours.c_str(), path, nullptr, MS_BIND, nullptr) == 0, std::string("mounting ") + path);
}

void name_hosts(const KeeperSetup& setup) {
  std::string names = "127.0.0.1 localhost\n";
  for (std::size_t i = 0; i < setup.names.size(); ++i)
    names += address_of(static_cast<int>(i) + 1) + " " + setup.names[i] + "\n";
  replace_file("/etc/hosts", names);
  // Who asks for another name is told at once that nobody knows it.
  replace_file("/etc/resolv.conf", "nameserver 127.0.0.1\n");
}

}  // namespace

void leave_machine(const KeeperSetup& setup) {
  if (setup.means.needs_user_namespace) enter_user_namespace();
  if (::unshare(kOfHost) != 0) {
    if (errno != EPERM || setup.means.needs_user_namespace) fail("making namespaces");
    enter_user_namespace();
    check(::unshare(kOfHost) == 0, "making namespaces in a user namespace");
  }
  if (setup.uptime.count() != 0) {
    check(::unshare(kNewTime) == 0, "making a time namespace");
    const auto seconds = setup.uptime / std::chrono::seconds(1);
    const std::string offset =
        std::to_string(seconds) + " " + std::to_string((setup.uptime % std::chrono::seconds(1)).count());
    write_file("/proc/self/timens_offsets", "monotonic " + offset + "\nboottime " + offset + "\n");
  }
  const std::string& name = setup.names.at(static_cast<std::size_t>(setup.number) - 1);
  check(::sethostname(name.c_str(), name.size()) == 0, "naming the host");
}

void make_file_systems(const KeeperSetup& setup) {
  keep_mounts_private();
  check(::mount("proc", "/proc", "proc", MS_NOSUID | MS_NODEV | MS_NOEXEC, nullptr) == 0, "mounting /proc");
  make_temporary_files(setup);
  mount_memory("/dev/shm", "mode=1777");
  fs::create_directory(kHarnessFolder);
  constexpr std::int64_t kNoOffset = 0;
  std::ofstream(kClockFile, std::ios::binary)
      .write(reinterpret_cast<const char*>(&kNoOffset), sizeof kNoOffset);
  name_hosts(setup);
}

void mount_disk(const std::string& folder, const std::string& bytes) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  mount_memory(folder.c_str(), ("mode=1777,size=" + bytes).c_str());
}

}  // namespace mlab::network
