#include "mlab/cell/landlock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

#include <fmt/core.h>

namespace mlab::cell {
namespace {

// Numbers of the kernel's interface, which never change. Debian 12's headers know the first two versions.
constexpr long kCreateRuleset = 444;  // the same on every architecture
constexpr long kAddRule = 445;
constexpr long kRestrictSelf = 446;
constexpr unsigned kAskVersion = 1;
constexpr int kPathBeneath = 1;

constexpr std::uint64_t kExecute = 1U << 0;
constexpr std::uint64_t kWriteFile = 1U << 1;
constexpr std::uint64_t kReadFile = 1U << 2;
constexpr std::uint64_t kReadFolder = 1U << 3;
constexpr std::uint64_t kRemoveFolder = 1U << 4;
constexpr std::uint64_t kRemoveFile = 1U << 5;
constexpr std::uint64_t kMakeFolder = 1U << 7;
constexpr std::uint64_t kMakeFile = 1U << 8;
constexpr std::uint64_t kAllOfVersion1 = (1U << 13) - 1;
constexpr std::uint64_t kRefer = 1U << 13;     // version 2
constexpr std::uint64_t kTruncate = 1U << 14;  // version 3
constexpr std::uint64_t kControl = 1U << 15;   // version 5: ioctl of devices
constexpr std::uint64_t kOfFiles = kExecute | kWriteFile | kReadFile | kTruncate | kControl;

constexpr std::uint64_t kAllOfNetwork = 3;  // version 4: bind and connect of TCP
constexpr std::uint64_t kAllOfScope = 3;    // version 6: abstract sockets, signals

struct RulesetAttributes {
  std::uint64_t files = 0;
  std::uint64_t network = 0;
  std::uint64_t scope = 0;
};
// The kernel takes as much of it as its version knows.
constexpr std::size_t kSizeOfVersion1 = 8;
constexpr std::size_t kSizeOfVersion4 = 16;
constexpr std::size_t kSizeOfVersion6 = 24;

struct __attribute__((packed)) PathRule {
  std::uint64_t allowed;
  std::int32_t parent;
};

std::uint64_t handled_files(int version) {
  return kAllOfVersion1 | (version >= 2 ? kRefer : 0) | (version >= 3 ? kTruncate : 0) |
         (version >= 5 ? kControl : 0);
}

std::string path_failure(const std::string& path) {
  return fmt::format("`{}`: {}", path, std::generic_category().message(errno));
}

/// Rules on their way; the descriptor is closed unless it is taken.
class Rules {
 public:
  explicit Rules(int version) : handled_(handled_files(version)) {
    const RulesetAttributes all{handled_, version >= 4 ? kAllOfNetwork : 0, version >= 6 ? kAllOfScope : 0};
    const std::size_t size = version >= 6   ? kSizeOfVersion6
                             : version >= 4 ? kSizeOfVersion4
                                            : kSizeOfVersion1;
    set_ = static_cast<int>(syscall(kCreateRuleset, &all, size, 0));
  }
  Rules(const Rules&) = delete;
  Rules& operator=(const Rules&) = delete;
  ~Rules() {
    if (set_ >= 0) close(set_);
  }

  bool is_there() const { return set_ >= 0; }
  int take() { return std::exchange(set_, -1); }

  // True, too, where there is no such file and none is needed.
  bool allow(const std::string& path, std::uint64_t what, bool is_needed) const {
    const int file = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (file < 0) return !is_needed && (errno == ENOENT || errno == ENOTDIR);
    struct stat state{};
    bool done = fstat(file, &state) == 0;
    if (done) {
      const PathRule rule{what & handled_ & (S_ISDIR(state.st_mode) ? ~std::uint64_t{0} : kOfFiles), file};
      done = syscall(kAddRule, set_, kPathBeneath, &rule, 0) == 0;
    }
    const int failure = errno;
    close(file);
    errno = failure;
    return done;
  }

 private:
  std::uint64_t handled_;
  int set_ = -1;
};

}  // namespace

int landlock_version() {
  const long version = syscall(kCreateRuleset, nullptr, 0, kAskVersion);
  return version > 0 ? static_cast<int>(version) : 0;
}

std::expected<int, std::string> landlock_rules(const Policy& policy, int version) {
  Rules rules(version);
  if (!rules.is_there()) return std::unexpected(std::generic_category().message(errno));
  constexpr std::uint64_t kRead = kReadFile | kReadFolder;
  constexpr std::uint64_t kChange =
      kRead | kWriteFile | kRemoveFolder | kRemoveFile | kMakeFolder | kMakeFile | kTruncate;
  for (const std::string& path : policy.readable) {
    if (!rules.allow(path, kRead, false)) return std::unexpected(path_failure(path));
  }
  for (const std::string& path : policy.executable) {
    if (!rules.allow(path, kRead | kExecute, false)) return std::unexpected(path_failure(path));
  }
  for (const std::string& path : policy.writable) {
    if (!rules.allow(path, kChange, true)) return std::unexpected(path_failure(path));
  }
  // Everybody's, and harmless.
  if (!rules.allow("/dev/null", kReadFile | kWriteFile | kTruncate, false))
    return std::unexpected(path_failure("/dev/null"));
  return rules.take();
}

int enter_landlock(int rules) noexcept {
  return syscall(kRestrictSelf, rules, 0) == 0 ? 0 : errno;
}

}  // namespace mlab::cell
