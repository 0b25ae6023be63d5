#include "mlab/agents/signs_of_life.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <utility>

#include "mlab/agents/topics.h"

namespace mlab::agents {
namespace {

// Twelve in the lease of their channel: where every fifth is lost, all of them are once in years.
constexpr std::chrono::milliseconds kSignEvery(50);

}  // namespace

std::expected<std::unique_ptr<SignsOfLife>, std::string> SignsOfLife::open(dds::Participant& participant,
                                                                           std::string name) {
  auto writer = participant.writer(kLifeTopic, dds::ChannelKind::kSignsOfLife);
  if (!writer) return std::unexpected(writer.error());
  return std::unique_ptr<SignsOfLife>(new SignsOfLife(std::move(*writer), std::move(name)));
}

SignsOfLife::SignsOfLife(dds::Writer writer, std::string name)
    : writer_(std::move(writer)), name_(std::move(name)) {}

void SignsOfLife::begin() {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any ends;
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      static_cast<void>(writer_.write(name_, ""));
      ends.wait_for(lock, stop, kSignEvery, [] { return false; });
    }
  });
}

}  // namespace mlab::agents
