// Anything on the standard input of a robot program, and anything that such a program answers. Each piece is
// preceded by its length, in two bytes, little endian. Whatever arrives: the program answers once, and what
// it took for percepts or an action goes through the encoding once more without losing a bit.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include <google/protobuf/stubs/logging.h>

#include "mlab/flow/testing/behaviors.h"
#include "mlab/robot/process/conversation.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/framing.h"
#include "mlab/robot/wire/testing/same_bits.h"

namespace {

using namespace mlab;

void fail(const char* why) {
  std::fprintf(stderr, "%s\n", why);
  std::abort();
}

std::shared_ptr<const flow::Program> program() {
  static const std::shared_ptr<const flow::Program> kProgram = [] {
    flow::Network network;
    network.parameters.push_back({"gain", "double", "", "", {}, flow::test::constant("2"), 0.0, 10.0, {}});
    network.nodes.push_back(flow::test::node(
        "total", "Add", {{"a", flow::test::name("gain")}, {"b", flow::test::constant("1")}}));
    network.nodes.push_back(flow::test::node("sink", "Show", {{"value", flow::test::name("total")}}));
    text::Diagnostics sink;
    return flow::build_program(network, flow::test::library(), sink);
  }();
  return kProgram;
}

void try_percepts(std::string_view bytes) {
  wire::Percepts message;
  robot_wire::DecodedPercepts decoded;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())) || decoded.decode(message))
    return;
  wire::Percepts again;
  robot_wire::encode(decoded.percepts(), again);
  robot_wire::DecodedPercepts decoded_again;
  if (decoded_again.decode(again)) fail("encoded percepts are refused");
  if (!robot_wire::testing::same(decoded.percepts(), decoded_again.percepts())) fail("percepts lost a bit");
}

void try_action(std::string_view bytes) {
  wire::Action message;
  percept::Action action;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())) ||
      robot_wire::decode(message, action))
    return;
  wire::Action again;
  robot_wire::encode(action, again);
  percept::Action decoded_again;
  if (robot_wire::decode(again, decoded_again)) fail("an encoded action is refused");
  if (!robot_wire::testing::same(action, decoded_again)) fail("an action lost a bit");
}

// The same bytes as a stream that arrives in pieces.
void try_framing(std::string_view bytes) {
  robot_wire::FrameReader reader;
  for (std::size_t at = 0; at < bytes.size(); at += 7) {
    const std::string_view piece = bytes.substr(at, 7);
    std::ranges::copy(piece, reader.room(piece.size()).begin());
    reader.advance(piece.size());
    while (reader.next()) {
    }
  }
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  static const auto kLog = google::protobuf::SetLogHandler(nullptr);
  static_cast<void>(kLog);
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  try_framing(all);
  try_percepts(all);
  try_action(all);
  robot_process::Conversation conversation(program(), "fuzz");
  for (std::size_t at = 0; at + 2 <= size;) {
    const std::size_t length = std::min<std::size_t>(data[at] + 256U * data[at + 1], size - at - 2);
    const wire::FromRobot& answer = conversation.answer(all.substr(at + 2, length));
    if (answer.body_case() == wire::FromRobot::BODY_NOT_SET) fail("a message is not answered");
    at += 2 + length;
  }
  return 0;
}
