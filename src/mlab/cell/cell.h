#pragma once

#include <expected>
#include <string>
#include <vector>

#include "mlab/cell/means.h"
#include "mlab/cell/policy.h"
#include "mlab/cell/system_calls.h"

namespace mlab::cell {

/// What is to run in a cell.
struct Program {
  std::string path;                      ///< of the executable: it is not looked for in PATH
  std::vector<std::string> arguments;    ///< without its name
  std::vector<std::string> environment;  ///< all of it, `NAME=value`: nothing is handed on by itself
  /// Descriptors below stay open; all others are closed. 3 or more, where it gets more than the first three.
  int descriptors = 3;
};

/// A program and the walls around it, ready before the fork: what is left to do in the child neither
/// allocates nor locks.
///
///     auto room = Cell::prepare(program, policy_for(program.path), wall);
///     const pid_t child = tied_fork([&] {
///       setpgid(0, 0);
///       ... dup2 of its descriptors ...
///       report(room->become());  // only comes back where it failed
///     });
///
/// Under kBubblewrap the child is `bwrap`, which waits for the program in a process of its own: end the
/// group, not the child alone, and read its end with `ending_of`.
///
/// A program that may start processes is killed with its whole group once the cell is no more, or this
/// process: what it started is tied to nobody otherwise. It keeps a descriptor for that.
class Cell {
 public:
  /// @errors  a sentence for a person
  static std::expected<Cell, std::string> prepare(const Program& program, const Policy& policy, Wall wall);

  Cell(Cell&& other) noexcept;
  Cell& operator=(Cell&& other) noexcept;
  Cell(const Cell&) = delete;
  Cell& operator=(const Cell&) = delete;
  ~Cell();

  /// In a child, after fork: takes on the limits and the walls and becomes the program. Also sets signals to
  /// what every program starts with, and writes no core files. Safe between fork and exec.
  /// @return  why it did not (errno); never comes back otherwise
  int become() noexcept;

  Wall wall() const { return wall_; }

 private:
  Cell() = default;
  int enter() noexcept;
  int hold_lifeline() const noexcept;
  void set_limits() const noexcept;

  Wall wall_ = Wall::kNone;
  Policy policy_;
  int descriptors_ = 3;
  int rules_ = -1;        // kLandlock
  int filter_file_ = -1;  // kBubblewrap: the filter as it reads it
  int lifeline_ = -1;     // of a program that may start processes: our end, and
  int held_end_ = -1;     // the one that it holds with all that it starts
  CallFilter filter_;
  std::vector<std::string> words_;
  std::vector<std::string> environment_;
  std::vector<char*> word_pointers_;
  std::vector<char*> environment_pointers_;
};

/// The program's own end, as `waitpid` tells it of a child: bubblewrap says signal 11 as exit status 139.
int ending_of(int wait_status, Wall wall);

}  // namespace mlab::cell
