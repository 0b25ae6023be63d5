#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace mlab::network {

/// A process of this machine, on whichever host, as /proc told of it a moment ago. Numbers are the machine's.
struct Seen {
  pid_t id = 0;
  pid_t parent = 0;
  char state = 'Z';          ///< as ps(1) has it; Z: it has ended, and nobody has asked how
  std::string name;          ///< of its program, the first 15 letters
  std::string command_line;  ///< all words, with blanks between

  std::string words() const;
};

/// All that a process started, and what those started; without such as have ended.
std::vector<Seen> descendants_of(pid_t process);

/// All that a process started itself, those that have ended and wait to be asked for, too.
std::vector<Seen> children_of(pid_t process);

/// Who is in a network namespace, of those that this process may look at.
/// @param name  as network_namespace_of says it
std::vector<Seen> processes_in(const std::string& name);

/// Of a process, such as `net:[4026532279]`; empty: there is no such process.
std::string network_namespace_of(pid_t process);

}  // namespace mlab::network
