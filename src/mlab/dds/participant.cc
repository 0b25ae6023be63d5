#include "mlab/dds/participant.h"

#include <utility>

#include <fmt/format.h>

#include "mlab/dds/participant_core.h"
#include "mlab/dds/reader_state.h"
#include "mlab/dds/writer_state.h"

namespace mlab::dds {

std::string Guid::text() const {
  std::string digits;
  for (const std::uint8_t byte : bytes) digits += fmt::format("{:02x}", byte);
  return digits;
}

Participant::Participant(std::shared_ptr<ParticipantCore> core) : core_(std::move(core)) {}
Participant::Participant(Participant&&) noexcept = default;
Participant& Participant::operator=(Participant&&) noexcept = default;
Participant::~Participant() = default;

std::expected<Participant, std::string> Participant::open(const Network& network) {
  auto core = ParticipantCore::open(network);
  if (!core) return std::unexpected(core.error());
  return Participant(std::move(*core));
}

Guid Participant::guid() const {
  return core_->guid;
}

std::expected<Writer, std::string> Participant::writer(std::string_view topic, ChannelKind kind,
                                                       const Waiter* waiter) {
  const std::string name(topic);
  auto state =
      std::make_unique<Writer::State>(core_, waiter != nullptr ? waiter->state_ : nullptr, name, kind);
  if (const auto begun = state->begin(name, kind); !begun) return std::unexpected(begun.error());
  return Writer(std::move(state));
}

std::expected<Reader, std::string> Participant::reader(std::string_view topic, ChannelKind kind,
                                                       const Waiter& waiter) {
  const std::string name(topic);
  auto state = std::make_unique<Reader::State>(core_, waiter.state_, name, kind);
  if (const auto begun = state->begin(name, kind); !begun) return std::unexpected(begun.error());
  return Reader(std::move(state));
}

bool Participant::has_run_out() const {
  return core_->has_run_out();
}

std::vector<std::string> Participant::complaints() {
  return core_->complaints.take();
}

}  // namespace mlab::dds
