#pragma once

#include <deque>
#include <expected>
#include <memory>
#include <string>

#include "mlab/agents/roster.h"
#include "mlab/agents/topics.h"
#include "mlab/dds/reader.h"
#include "mlab/dds/writer.h"
#include "mlab/robot/remote/link.h"
#include "mlab/robot/remote/live_line.h"

namespace mlab::agents {

/// A conversation with an agent of a fleet.
class DdsLink final : public robot_remote::Link {
 public:
  /// @param agent    one of the roster
  /// @param is_live  for robots in real time: it bears longer silences, and has a LiveLine
  /// @errors  a sentence without its subject, as `failure`: it does not answer
  static std::expected<std::unique_ptr<DdsLink>, std::string> open(std::shared_ptr<Roster> roster,
                                                                   const Member& agent, bool is_live);

  void send(std::string_view message) override;
  std::optional<std::string_view> receive(robot_remote::Clock::time_point deadline) override;
  void look() override { look_after_agent(); }
  const std::string& failure() const override { return failure_; }
  void fail(std::string why) override;
  bool is_cut() override;
  double silence() const override;
  double patience_with_silence() const override;
  std::shared_ptr<robot_remote::LiveLine> live() override { return live_; }

 private:
  /// Why it is lost: that this process stood still for so long that it was given up, where that is so.
  std::string why_lost(std::string otherwise) const;
  DdsLink(std::shared_ptr<Roster> roster, const Member& agent, std::string key, dds::Waiter waiter,
          dds::Reader answers, dds::Writer requests);
  bool is_met() const;
  void take_arrivals();
  void look_after_agent();

  std::shared_ptr<Roster> roster_;
  std::string agent_;
  dds::Guid guid_;
  std::string key_;  // of the conversation
  dds::Waiter waiter_;
  dds::Reader answers_;
  dds::Writer requests_;
  Assembly assembly_;
  std::deque<std::string> came_;
  std::string last_;
  std::string failure_;
  std::shared_ptr<robot_remote::LiveLine> live_;  // null: in lock-step
};

}  // namespace mlab::agents
