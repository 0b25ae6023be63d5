#include "mlab/dds/writer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "envelope.h"
#include "mlab/dds/handed_over.h"
#include "mlab/dds/writer_state.h"

namespace mlab::dds {
namespace {

bool is_key(std::string_view key) {
  return key.size() <= kMaxKey && key.find('\0') == std::string_view::npos && key != kPromptKey;
}

/// The body stays where it is: Cyclone only reads it.
mlab_dds_Envelope envelope_of(std::string_view key, std::string_view body) {
  mlab_dds_Envelope envelope{};
  std::memcpy(envelope.key, key.data(), key.size());
  envelope.body._maximum = envelope.body._length = static_cast<std::uint32_t>(body.size());
  envelope.body._buffer = reinterpret_cast<std::uint8_t*>(const_cast<char*>(body.data()));
  envelope.body._release = false;
  return envelope;
}

Written written(dds_return_t code) {
  if (code >= 0) return Written::kDone;
  return code == DDS_RETCODE_TIMEOUT ? Written::kFull : Written::kFailed;
}

}  // namespace

Writer::State::State(std::shared_ptr<ParticipantCore> core, std::shared_ptr<WaiterState> waiter,
                     std::string topic, ChannelKind kind)
    : core_(std::move(core)),
      waiter_(std::move(waiter)),
      readers_(std::move(topic), kind, "reads"),
      is_asked_after_(info(kind).is_asked_after) {}

std::expected<void, std::string> Writer::State::begin(const std::string& topic, ChannelKind kind) {
  auto made = core_->topic(topic);
  if (!made) return std::unexpected(made.error());
  topic_ = std::move(*made);
  const Qos qos = qos_of(info(kind));
  const Listener told(dds_create_listener(this));
  dds_lset_publication_matched(told.get(), on_matched);
  dds_lset_offered_incompatible_qos(told.get(), on_incompatible);
  hand_over(this);
  const dds_entity_t writer =
      dds_create_writer(core_->publisher.handle(), topic_.handle(), qos.get(), told.get());
  if (writer < 0)
    return std::unexpected(fmt::format("`{}` can't be written: {}", topic, dds_strretcode(writer)));
  writer_ = Entity(writer);
  note_those_before();
  if (!is_asked_after_) return {};
  prompts_.emplace(core_->prompter(), [this] { return prompt(); });
  const std::lock_guard lock(mutex_);
  can_prompt_ = true;
  if (!joining_.empty()) prompts_->matched();
  return {};
}

// Readers that matched while the writer was being made: Cyclone tells of them, but says nothing of them then.
void Writer::State::note_those_before() {
  std::array<dds_instance_handle_t, 1024> handles{};
  const dds_return_t count = dds_get_matched_subscriptions(writer_.handle(), handles.data(), handles.size());
  for (std::size_t i = 0; i < std::min(handles.size(), static_cast<std::size_t>(std::max(count, 0))); ++i) {
    dds_builtintopic_endpoint_t* const endpoint =
        dds_get_matched_subscription_data(writer_.handle(), handles[i]);
    if (endpoint == nullptr) continue;  // it has gone again
    {
      const std::lock_guard lock(mutex_);
      if (!readers_.find(handles[i])) {
        readers_.add(handles[i], *endpoint);
        set_there(handles[i], true);
      }
    }
    dds_builtintopic_free_endpoint(endpoint);
  }
}

Writer::State::~State() {
  {
    const std::lock_guard lock(mutex_);
    can_prompt_ = false;
  }
  prompts_.reset();
  writer_.reset();
  take_over(this);
}

void Writer::State::on_matched(dds_entity_t writer, dds_publication_matched_status_t status, void* state) {
  const ListenerCall call(state);
  auto& self = *static_cast<State*>(state);
  const bool is_there = status.current_count_change > 0;
  dds_builtintopic_endpoint_t* const endpoint =
      is_there ? dds_get_matched_subscription_data(writer, status.last_subscription_handle) : nullptr;
  {
    const std::lock_guard lock(self.mutex_);
    if (endpoint != nullptr) self.readers_.add(status.last_subscription_handle, *endpoint);
    self.set_there(status.last_subscription_handle, is_there);
    if (self.waiter_) self.waiter_->signal();
    if (!self.joining_.empty() && self.can_prompt_) self.prompts_->matched();
  }
  if (endpoint != nullptr) dds_builtintopic_free_endpoint(endpoint);
}

// Cyclone calls a reader matched before that one has heard how far its writer is. Of many messages written in
// between it may drop some, and deliver others twice (0.10.2, where packets are lost); so a reader counts
// once it has acknowledged something that was written after it matched. Under the lock.
void Writer::State::set_there(dds_instance_handle_t reader, bool is_there) {
  readers_.set_there(reader, is_there);
  if (!is_asked_after_) return;
  std::erase_if(joining_, [&](const Joining& one) { return one.reader == reader; });
  readers_.set_joining(reader, is_there);
  if (is_there)
    joining_.push_back({.reader = reader, .number = ++joined_, .until = Clock::now() + kLongestJoining});
}

/// @return  whether all have that had not
bool Writer::State::note_those_that_answered() {
  {
    const std::lock_guard lock(mutex_);
    if (joining_.empty()) return false;
  }
  const bool is_acknowledged = dds_wait_for_acks(writer_.handle(), 0) == DDS_RETCODE_OK;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  const std::size_t before = joining_.size();
  std::erase_if(joining_, [&](const Joining& one) {
    const bool is_heard = (is_acknowledged && one.number <= prompted_) || now >= one.until;
    if (is_heard) readers_.set_joining(one.reader, false);
    return is_heard;
  });
  if (joining_.size() != before && waiter_) waiter_->signal();
  return joining_.empty();
}

void Writer::State::on_incompatible(dds_entity_t /*writer*/, dds_offered_incompatible_qos_status_t status,
                                    void* state) {
  const ListenerCall call(state);
  auto& self = *static_cast<State*>(state);
  const std::lock_guard lock(self.mutex_);
  self.readers_.add_incompatible(status.last_policy_id);
  if (self.waiter_) self.waiter_->signal();
}

Written Writer::State::write(std::string_view key, std::string_view body) {
  if (!is_key(key)) return Written::kBadKey;
  if (body.size() > kMaxBody) return Written::kTooLong;
  const mlab_dds_Envelope envelope = envelope_of(key, body);
  const Written how = written(dds_write(writer_.handle(), &envelope));
  if (prompts_) prompts_->written();
  return how;
}

// It says what was written before, and so who misses that asks for it.
// @return  whether a reader has to answer yet
bool Writer::State::prompt() {
  // Then they have everything.
  if (note_those_that_answered()) return false;
  std::uint64_t joined = 0;
  bool has_to_answer = false;
  {
    const std::lock_guard lock(mutex_);
    has_to_answer = !joining_.empty();
    if (!has_to_answer && readers_.participants().empty()) return false;
    joined = joined_;
  }
  const mlab_dds_Envelope envelope = envelope_of(kPromptKey, {});
  // One that is not written is followed by the next.
  if (dds_write(writer_.handle(), &envelope) == DDS_RETCODE_OK) prompted_ = joined;
  return has_to_answer;
}

Written Writer::State::end(std::string_view key) {
  if (!is_key(key)) return Written::kBadKey;
  const mlab_dds_Envelope envelope = envelope_of(key, {});
  const Written how = written(dds_dispose(writer_.handle(), &envelope));
  if (prompts_) prompts_->written();
  return how;
}

std::vector<Guid> Writer::State::readers() const {
  const std::lock_guard lock(mutex_);
  return readers_.participants();
}

std::vector<std::string> Writer::State::mismatches() const {
  const std::lock_guard lock(mutex_);
  return readers_.mismatches();
}

Writer::Writer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Writer::Writer(Writer&&) noexcept = default;
Writer& Writer::operator=(Writer&&) noexcept = default;
Writer::~Writer() = default;

Written Writer::write(std::string_view key, std::string_view body) {
  return state_->write(key, body);
}
Written Writer::end(std::string_view key) {
  return state_->end(key);
}
std::vector<Guid> Writer::readers() const {
  return state_->readers();
}
std::vector<std::string> Writer::mismatches() const {
  return state_->mismatches();
}

}  // namespace mlab::dds
