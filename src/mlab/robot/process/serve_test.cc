#include "mlab/robot/process/serve.h"

#include <fcntl.h>
#include <unistd.h>

#include <string>

#include <gtest/gtest.h>

#include "mlab/robot/process/conversation.h"
#include "mlab/robot/process/testing/programs.h"
#include "mlab/robot/wire/framing.h"

namespace mlab::robot_process {
namespace {

struct Served {
  int status = 0;
  std::vector<wire::FromRobot> answers;
};

// What comes back for a whole standard input.
Served serve_bytes(const std::string& bytes) {
  int to[2];
  int from[2];
  EXPECT_EQ(pipe(to), 0);
  EXPECT_EQ(pipe(from), 0);
  EXPECT_EQ(write(to[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  close(to[1]);
  Conversation conversation(wandering_program(), "1");
  Served out;
  out.status = serve(conversation, to[0], from[1]);
  close(from[1]);
  robot_wire::FrameReader reader;
  for (;;) {
    const auto room = reader.room();
    const ssize_t count = read(from[0], room.data(), room.size());
    if (count <= 0) break;
    reader.advance(static_cast<std::size_t>(count));
    while (const auto message = reader.next())
      EXPECT_TRUE(out.answers.emplace_back().ParseFromString(std::string(*message)));
  }
  EXPECT_TRUE(reader.is_empty());
  close(to[0]);
  close(from[0]);
  return out;
}

std::string hello() {
  wire::ToRobot message;
  message.mutable_hello()->set_protocol(robot_wire::kProtocol);
  std::string bytes;
  robot_wire::append_framed(message, bytes);
  return bytes;
}

TEST(Serve, AnswersEachMessageAndEndsWithItsInput) {
  const Served served = serve_bytes(hello() + hello());
  EXPECT_EQ(served.status, 0);
  ASSERT_EQ(served.answers.size(), 2U);
  EXPECT_EQ(served.answers[1].welcome().protocol(), 1U);
}

TEST(Serve, TellsThatItsInputEndedWithinAMessage) {
  const Served served = serve_bytes(hello() + hello().substr(0, 5));
  EXPECT_EQ(served.status, 1);
  EXPECT_EQ(served.answers.size(), 1U);
}

TEST(Serve, EndsWhereNoMessagesArrive) {
  EXPECT_EQ(serve_bytes("drive, please\n").status, 1);
}

}  // namespace
}  // namespace mlab::robot_process
