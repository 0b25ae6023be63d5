#pragma once

#include <cstddef>
#include <deque>
#include <expected>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "mlab/agents/roster.h"
#include "mlab/robot/program/said.h"

namespace mlab::agents {

/// The last lines that an agent has told, for those who ask it from elsewhere. By any thread.
class AgentLog {
 public:
  static constexpr std::size_t kMost = 200;  ///< lines

  /// @param tell  gets each line, too
  explicit AgentLog(std::function<void(const std::string&)> tell) : tell_(std::move(tell)) {}
  void add(const std::string& line);
  std::vector<robot::LogLine> lines() const;

 private:
  struct Told {
    Clock::time_point when;
    std::string text;
  };
  std::function<void(const std::string&)> tell_;
  mutable std::mutex mutex_;
  std::deque<Told> told_;
};

/// Asks an agent of a fleet for its log.
/// @errors  a sentence: nobody of that name is there, it is of another version, it gives no answer
std::expected<std::vector<robot::LogLine>, std::string> read_log(const std::shared_ptr<Roster>& roster,
                                                                 const std::string& agent);

}  // namespace mlab::agents
