#include "mlab/dds/testing/fleet.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

extern char** environ;

namespace mlab::dds {
namespace {

template <class Value>
Value surely(std::expected<Value, std::string> value) {
  if (!value) {
    ADD_FAILURE() << value.error();
    std::abort();
  }
  return std::move(*value);
}

}  // namespace

std::string fleet_of_this_process() {
  return fmt::format("test-{}", ::getpid());
}

Participant participant(int lost_of_thousand, const std::string& fleet) {
  return surely(Participant::open(
      {.fleet = fleet, .interface_name = {}, .peers = {}, .lost_of_thousand = lost_of_thousand}));
}

Participant avoiding_participant(const std::string& fleet) {
  return surely(Participant::open(
      {.fleet = fleet, .interface_name = {}, .peers = {}, .lost_of_thousand = 0, .avoids_neighbours = true}));
}

Waiter waiter() {
  return surely(Waiter::make());
}

Writer writer(Participant& participant, const std::string& topic, ChannelKind kind, const Waiter* waiter) {
  return surely(participant.writer(topic, kind, waiter));
}

Reader reader(Participant& participant, const std::string& topic, ChannelKind kind, const Waiter& waiter) {
  return surely(participant.reader(topic, kind, waiter));
}

bool comes_true(Waiter& waiter, const std::function<bool()>& condition, std::chrono::milliseconds limit) {
  const auto until = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > until) return false;
    waiter.wait(std::chrono::milliseconds(50));
  }
  return true;
}

std::vector<Arrival> arrivals(Waiter& waiter, Reader& reader, Arrival::Kind kind, std::size_t count,
                              std::chrono::milliseconds limit) {
  std::vector<Arrival> all;
  std::size_t found = 0;
  comes_true(
      waiter,
      [&] {
        for (Arrival& arrival : reader.take()) {
          if (arrival.kind == kind) ++found;
          all.push_back(std::move(arrival));
        }
        return found >= count;
      },
      limit);
  return all;
}

std::vector<std::string> bodies(const std::vector<Arrival>& arrivals) {
  std::vector<std::string> found;
  for (const Arrival& arrival : arrivals) {
    if (arrival.kind == Arrival::Kind::kMessage) found.push_back(arrival.body);
  }
  return found;
}

Arrival first_of(const std::vector<Arrival>& arrivals, Arrival::Kind kind) {
  for (const Arrival& arrival : arrivals) {
    if (arrival.kind == kind) return arrival;
  }
  return {};
}

void write_surely(Writer& writer, const std::string& key, const std::string& body) {
  Written how = Written::kFull;
  while (how == Written::kFull) how = writer.write(key, body);
  EXPECT_EQ(how, Written::kDone);
}

Peer::Peer(std::vector<std::string> words, int lost_of_thousand) {
  std::vector<std::string> all = {MLAB_DDS_PEER, fleet_of_this_process(), std::to_string(lost_of_thousand)};
  all.insert(all.end(), std::make_move_iterator(words.begin()), std::make_move_iterator(words.end()));
  std::vector<char*> pointers;
  for (std::string& word : all) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  EXPECT_EQ(::posix_spawn(&child_, MLAB_DDS_PEER, nullptr, nullptr, pointers.data(), environ), 0);
}

Peer::~Peer() {
  if (child_ < 0) return;
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

void Peer::signal(int number) const {
  ::kill(child_, number);
}

}  // namespace mlab::dds
