#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/agents/roster.h"
#include "mlab/dds/reader.h"
#include "mlab/dds/waiter.h"
#include "mlab/dds/writer.h"

namespace mlab::agents {

/// The way to an agent and back, and its clock, as measured from here.
struct LinkQuality {
  double round_trip = 0.0;    ///< the shortest of the last measurements, without the agent's own time [s]
  double clock_offset = 0.0;  ///< of the agent's wall clock against this machine's; more than 0: ahead [s]
  double lost = 0.0;          ///< share of the last questions without an answer, 0 .. 1
};

/// The clocks differ by more than the measurement can be wrong by, and by more than anybody would care for.
bool is_clock_known(const LinkQuality& link);

/// Puts measurements of one link together: of those that lately came back, the fastest tells the offset,
/// since it waited for nobody (the minimum filter of NTP, RFC 5905 section 10).
class LinkHistory {
 public:
  static constexpr std::size_t kKept = 20;             ///< questions
  static constexpr std::chrono::seconds kPatience{1};  ///< after it a question counts as lost

  void asked(std::uint64_t number, Clock::time_point now);
  /// @param round_trip  [s]; what is less than 0 or more than a minute is nonsense and not kept
  void answered(std::uint64_t number, double round_trip, double clock_offset);
  /// Nothing before the first answer, and of what was asked before that nothing counts; a question that no
  /// later one's answer has overtaken is not lost as long as its own may be on its way.
  std::optional<LinkQuality> quality(Clock::time_point now) const;

 private:
  struct Question {
    std::uint64_t number = 0;
    Clock::time_point asked;
    bool has_answer = false;
    double round_trip = 0.0;
    double clock_offset = 0.0;
  };
  std::deque<Question> questions_;  // by number
  bool has_met_ = false;            // an answer has come
};

/// Asks all agents of a fleet for an echo, and measures the links by the four times of each answer. One
/// thread.
class EchoProbe {
 public:
  /// @errors  a sentence: the network can't be used
  static std::expected<std::unique_ptr<EchoProbe>, std::string> open(std::shared_ptr<Roster> roster);

  /// Asks once more, and takes what came back within some time.
  void measure(std::chrono::milliseconds time);
  std::optional<LinkQuality> quality(const std::string& agent) const;

 private:
  struct Asked {
    Clock::time_point steady;
    std::chrono::system_clock::time_point wall;
  };
  EchoProbe(std::shared_ptr<Roster> roster, dds::Waiter waiter, dds::Reader reader, dds::Writer writer);
  void ask();
  void take(const dds::Arrival& arrival);

  std::shared_ptr<Roster> roster_;
  dds::Waiter waiter_;
  dds::Reader reader_;
  dds::Writer writer_;
  std::string key_;  // tells this asker from others
  std::uint64_t number_ = 0;
  std::map<std::uint64_t, Asked> asked_;  // the newest LinkHistory::kKept
  std::map<std::string, LinkHistory> links_;
};

/// The agent's side.
class EchoAnswerer {
 public:
  /// @param waiter  is signalled whenever there is something to answer
  /// @errors  a sentence
  static std::expected<EchoAnswerer, std::string> open(dds::Participant& participant,
                                                       const dds::Waiter& waiter, std::string name);
  /// Answers what has arrived; what can't be written now is lost, as on the way.
  void answer();

 private:
  EchoAnswerer(dds::Reader reader, dds::Writer writer, std::string name);
  dds::Reader reader_;
  dds::Writer writer_;
  std::string name_;
};

}  // namespace mlab::agents
