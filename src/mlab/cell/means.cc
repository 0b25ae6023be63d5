#include "mlab/cell/means.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

#include "mlab/cell/landlock.h"

namespace mlab::cell {
namespace {

// Whether it ends with status 0; it prints nothing.
bool succeeds(std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int descriptor : {0, 1, 2}) {
    posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", O_RDWR, 0);
  }
  pid_t child = -1;
  const bool is_started = posix_spawn(&child, pointers[0], &actions, nullptr, pointers.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  if (!is_started) return false;
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return false;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::string find_bubblewrap() {
  // Not out of PATH: what keeps others out must not be somebody else's file.
  for (const char* path : {"/usr/bin/bwrap", "/bin/bwrap", "/usr/local/bin/bwrap"}) {
    if (access(path, X_OK) != 0) continue;
    // In containers it is often there and may not do its work.
    if (succeeds({path, "--unshare-all", "--die-with-parent", "--cap-drop", "ALL", "--ro-bind", "/", "/",
                  "--remount-ro", "/", "--", path, "--version"}))
      return path;
  }
  return "";
}

Means find_means() {
  Means out;
  out.landlock = landlock_version();
  if (out.landlock == 0) out.bubblewrap = find_bubblewrap();
  return out;
}

const Means& means() {
  static const Means kFound = find_means();
  return kFound;
}

std::expected<Wall, std::string> choose_wall(const Means& means, bool without_cell) {
  if (without_cell) return Wall::kNone;
  if (means.landlock > 0) return Wall::kLandlock;
  if (!means.bubblewrap.empty()) return Wall::kBubblewrap;
  return std::unexpected(
      "code that files bring runs in a cell, and this machine has nothing to make one of: its kernel has no "
      "Landlock, and there is no bubblewrap that works; install bubblewrap, or say --no-cell to run it with "
      "everything that you may do yourself");
}

}  // namespace mlab::cell
