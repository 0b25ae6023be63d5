#pragma once

#include <expected>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/dds/participant.h"
#include "mlab/dds/reader.h"
#include "mlab/dds/writer.h"
#include "mlab/robot/remote/live_line.h"

namespace mlab::agents {

/// Either end of what passes in real time between a run and one agent.
class DdsLiveLine final : public robot_remote::LiveLine {
 public:
  struct End {
    std::string topic;
    dds::ChannelKind kind;
  };
  /// @param other  the participant at the other end: what comes from others is not taken
  /// @errors  a sentence
  static std::expected<std::shared_ptr<DdsLiveLine>, std::string> open(dds::Participant& participant,
                                                                       const End& out, const End& in,
                                                                       const dds::Guid& other);

  bool meet(robot_remote::Clock::time_point deadline) override;
  void send(std::string_view key, std::string_view body) override;
  std::vector<Message> receive(robot_remote::Clock::time_point deadline) override;
  void wake() override { waiter_.wake(); }

 private:
  DdsLiveLine(dds::Waiter waiter, dds::Reader reader, dds::Writer writer, const dds::Guid& other);

  dds::Waiter waiter_;
  dds::Reader reader_;
  dds::Writer writer_;
  dds::Guid other_;
};

/// The run's end of the conversation with an agent, and the agent's.
std::expected<std::shared_ptr<DdsLiveLine>, std::string> open_live_line_of_run(dds::Participant& participant,
                                                                               std::string_view agent,
                                                                               std::string_view conversation,
                                                                               const dds::Guid& other);
std::expected<std::shared_ptr<DdsLiveLine>, std::string> open_live_line_of_agent(
    dds::Participant& participant, std::string_view agent, std::string_view conversation,
    const dds::Guid& other);

}  // namespace mlab::agents
