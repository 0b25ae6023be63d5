#include "mlab/agents/signs_of_life.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <utility>

#include "mlab/agents/topics.h"

namespace mlab::agents {
namespace {

// Twelve in the lease of their channel: where every fifth is lost, all of them are once in years. Where none
// is lost on its way six are enough for a machine that is busy.
constexpr std::chrono::milliseconds kSignEvery(50);
constexpr std::chrono::milliseconds kSignOnLoopbackEvery(100);

}  // namespace

std::expected<std::unique_ptr<SignsOfLife>, std::string> SignsOfLife::open(dds::Participant& participant,
                                                                           const dds::Network& network,
                                                                           std::string name) {
  auto writer = participant.writer(kLifeTopic, dds::ChannelKind::kSignsOfLife);
  if (!writer) return std::unexpected(writer.error());
  const bool is_sure = dds::is_loopback_only(network) && network.lost_of_thousand == 0;
  return std::unique_ptr<SignsOfLife>(
      new SignsOfLife(std::move(*writer), std::move(name), is_sure ? kSignOnLoopbackEvery : kSignEvery));
}

SignsOfLife::SignsOfLife(dds::Writer writer, std::string name, std::chrono::milliseconds every)
    : writer_(std::move(writer)), name_(std::move(name)), every_(every) {}

void SignsOfLife::begin() {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any ends;
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      static_cast<void>(writer_.write(name_, ""));
      ends.wait_for(lock, stop, every_, [] { return false; });
    }
  });
}

}  // namespace mlab::agents
