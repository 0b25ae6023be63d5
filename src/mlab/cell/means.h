#pragma once

#include <expected>
#include <string>

namespace mlab::cell {

/// What cells can be made of on a machine.
struct Means {
  int landlock = 0;        ///< version of the kernel's Landlock; 0: it has none, or it is switched off
  std::string bubblewrap;  ///< path of a `bwrap` that works here; empty: there is none
};

/// Asks the kernel, and, where it has no Landlock, finds and tries bubblewrap.
Means find_means();
/// The same, found once.
const Means& means();
/// Path of a `bwrap` that was tried just now; empty: none works here.
std::string find_bubblewrap();

/// What keeps a program in.
enum class Wall {
  kLandlock,    ///< Landlock for files, seccomp for all else
  kBubblewrap,  ///< namespaces for files, seccomp for all else
  kNone,        ///< nothing but limits: somebody said `--no-cell`
};

/// @param without_cell  somebody said `--no-cell`
/// @errors  a sentence for a person: nothing here can make a cell
std::expected<Wall, std::string> choose_wall(const Means& means, bool without_cell = false);

}  // namespace mlab::cell
