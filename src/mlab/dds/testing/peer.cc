// A participant in a process of its own, which tests kill, stop and count. It ends with who started it.
//
//     dds_peer FLEET LOST presence KEY          is there, and gives signs of life all the time
//     dds_peer FLEET LOST echo OUT BACK         answers each of lock-step percepts with an action of its key
//     and body dds_peer FLEET LOST send TOPIC COUNT      writes 0, 1, 2, ... as events once somebody reads
//     dds_peer FLEET LOST read TOPIC            reads commands, and takes none

#include <sys/prctl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "mlab/dds/participant.h"

namespace mlab::dds {
namespace {

using std::chrono::milliseconds;

template <class Value>
Value need(std::expected<Value, std::string> value) {
  if (value) return std::move(*value);
  std::fprintf(stderr, "dds_peer: %s\n", value.error().c_str());
  ::_exit(1);
}

void write_surely(Writer& writer, const std::string& key, const std::string& body) {
  while (writer.write(key, body) == Written::kFull) {
  }
}

void be_there(Participant& participant, const std::string& key) {
  Writer presence = need(participant.writer("presence", ChannelKind::kPresence));
  Writer life = need(participant.writer("life", ChannelKind::kSignsOfLife));
  write_surely(presence, key, "here");
  while (true) {
    static_cast<void>(life.write(key, "alive"));
    std::this_thread::sleep_for(milliseconds(50));
  }
}

void echo(Participant& participant, const std::string& out, const std::string& back) {
  Waiter waiter = need(Waiter::make());
  Writer actions = need(participant.writer(back, ChannelKind::kActions, &waiter));
  Reader percepts = need(participant.reader(out, ChannelKind::kLockStepPercepts, waiter));
  // Whoever asks may know of this writer before this writer knows of him.
  while (actions.readers().empty()) waiter.wait(milliseconds(1000));
  while (true) {
    for (const Arrival& arrival : percepts.take()) {
      if (arrival.kind == Arrival::Kind::kMessage) write_surely(actions, arrival.key, arrival.body);
    }
    waiter.wait(milliseconds(-1));
  }
}

void send(Participant& participant, const std::string& topic, int count) {
  Waiter waiter = need(Waiter::make());
  Writer events = need(participant.writer(topic, ChannelKind::kEvents, &waiter));
  while (events.readers().empty()) waiter.wait(milliseconds(1000));
  for (int i = 0; i < count; ++i) write_surely(events, "", std::to_string(i));
  while (true) ::pause();
}

void read_nothing(Participant& participant, const std::string& topic) {
  const Waiter waiter = need(Waiter::make());
  [[maybe_unused]] const Reader reader = need(participant.reader(topic, ChannelKind::kCommands, waiter));
  while (true) ::pause();
}

void run(const std::vector<std::string>& words) {
  Participant participant = need(Participant::open(
      {.fleet = words[1], .interface_name = {}, .peers = {}, .lost_of_thousand = std::stoi(words[2])}));
  const std::string& role = words[3];
  if (role == "presence") be_there(participant, words.at(4));
  if (role == "echo") echo(participant, words.at(4), words.at(5));
  if (role == "send") send(participant, words.at(4), std::stoi(words.at(5)));
  if (role == "read") read_nothing(participant, words.at(4));
}

}  // namespace
}  // namespace mlab::dds

int main(int count, char** words) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (count < 5) return 2;
  mlab::dds::run(std::vector<std::string>(words, words + count));
  return 2;
}
