#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

#include "descriptor.h"
#include "message.h"

namespace mlab::network {

/// The processes of a host, seen by the first of them: it starts those that the test wants, and asks how all
/// ended, orphans too.
class Children {
 public:
  /// @param request  words: its folder (empty: `/`), how many words its command line has, those words, then
  ///                 its whole environment; files: its standard input, output and errors, and where four
  ///                 bytes shall be written once it has ended: its status as of wait(2)
  /// @return  what to answer: `started`, with a file that stands for the process; or `failed` and why
  Message start(Message request);
  /// Kills all that are in the process's group.
  void kill_group(pid_t process) const;
  /// To be called whenever one may have ended.
  void reap();

 private:
  std::map<pid_t, Descriptor> status_of_;  ///< of those that were started and have not ended
};

/// What SIGPIPE does: nothing to the keeper, and to all that it starts what it usually does.
void set_broken_pipe(void (*handler)(int));

}  // namespace mlab::network
