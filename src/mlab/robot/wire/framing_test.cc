#include "mlab/robot/wire/framing.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "mlab/robot.pb.h"

namespace mlab::robot_wire {
namespace {

// What comes out of a stream that arrives in pieces of these sizes, again and again.
std::vector<std::string> cut(const std::string& stream, const std::vector<std::size_t>& pieces) {
  std::vector<std::string> out;
  FrameReader reader;
  std::size_t at = 0;
  for (std::size_t n = 0; at < stream.size(); ++n) {
    const std::size_t count = std::min(pieces[n % pieces.size()], stream.size() - at);
    const std::span<char> room = reader.room(count);
    std::copy_n(stream.begin() + static_cast<std::ptrdiff_t>(at), count, room.begin());
    reader.advance(count);
    at += count;
    while (const auto message = reader.next()) out.emplace_back(*message);
  }
  EXPECT_TRUE(reader.is_empty());
  return out;
}

TEST(FrameReader, FindsTheSameMessagesInWhateverPiecesTheyArrive) {
  EXPECT_TRUE(rc::check("cut(join(messages)) == messages", [] {
    const auto texts = *rc::gen::container<std::vector<std::string>>(rc::gen::string<std::string>());
    const auto pieces = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 40)));
    std::string stream;
    std::vector<std::string> messages;
    for (const std::string& text : texts) {
      wire::Problem problem;
      // A `string` field is UTF-8; these are any bytes.
      problem.set_text(std::string(text.size(), 'x'));
      append_framed(problem, stream);
      messages.push_back(problem.SerializeAsString());
    }
    RC_ASSERT(cut(stream, pieces) == messages);
  }));
}

TEST(FrameReader, TakesNoLengthThatNoMessageHas) {
  FrameReader reader;
  const std::string text = "usage: something else\n";
  std::ranges::copy(text, reader.room(text.size()).begin());
  reader.advance(text.size());
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.is_nonsense());
}

TEST(AppendFramed, PutsTheLengthInFrontLeastSignificantByteFirst) {
  wire::Problem problem;
  problem.set_text(std::string(300, 'x'));
  std::string out;
  append_framed(problem, out);
  ASSERT_EQ(out.size(), 4 + problem.ByteSizeLong());
  EXPECT_EQ(out.substr(0, 4), std::string("\x2f\x01\0\0", 4));
}

}  // namespace
}  // namespace mlab::robot_wire
