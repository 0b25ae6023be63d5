#pragma once

#include <expected>
#include <memory>
#include <string>
#include <vector>

#include <sys/types.h>

#include "mlab/agents/missed.h"
#include "mlab/agents/roster.h"
#include "mlab/agents/siblings.h"
#include "mlab/dds/network.h"
#include "mlab/dds/waiter.h"

namespace mlab::cli {

/// An agent of which nothing is heard here, though it ought to be there.
struct UnheardAgent {
  std::string name;
  std::string machine;  ///< fit for people
  double silent = 0.0;  ///< so long [s]
  std::string by;       ///< who knows of it: `agent south`; empty: it was here, by what it keeps on the disk
  pid_t process = 0;    ///< that has its name on this machine still; 0: none
};

/// Finds them: by whom others in the fleet miss, and by what agents of this machine and user keep. Whoever
/// was stopped or cut off before somebody looks can't be found otherwise.
class UnheardAgents {
 public:
  /// @errors  a sentence: the network can't be used
  static std::expected<std::unique_ptr<UnheardAgents>, std::string> open(
      std::shared_ptr<agents::Roster> roster, const dds::Network& network);

  /// By name. One thread at a time.
  std::vector<UnheardAgent> look();

 private:
  UnheardAgents(std::shared_ptr<agents::Roster> roster, const dds::Network& network, dds::Waiter waiter,
                std::unique_ptr<agents::Hearsay> hearsay);
  void add_siblings(std::vector<UnheardAgent>& out);

  std::shared_ptr<agents::Roster> roster_;
  dds::Waiter waiter_;
  std::unique_ptr<agents::Hearsay> hearsay_;
  agents::Siblings siblings_;
  std::string fleet_;
  agents::Clock::time_point began_ = agents::Clock::now();
};

/// A sentence about each, and what helps; empty: there are none.
std::vector<std::string> about_unheard(const std::vector<UnheardAgent>& agents);

}  // namespace mlab::cli
