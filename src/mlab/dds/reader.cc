#include "mlab/dds/reader.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "envelope.h"
#include "mlab/dds/handed_over.h"
#include "mlab/dds/reader_state.h"

namespace mlab::dds {
namespace {

/// How much of what has arrived is asked for at once.
constexpr std::uint32_t kBatch = 16;

bool is_prompt(const mlab_dds_Envelope& envelope) {
  return std::string_view(envelope.key, strnlen(envelope.key, kMaxKey)) == kPromptKey;
}

Arrival arrival_of(const mlab_dds_Envelope& envelope, const dds_sample_info_t& sample) {
  using std::chrono::nanoseconds;
  Arrival arrival;
  arrival.key.assign(envelope.key, strnlen(envelope.key, kMaxKey));
  arrival.sent = std::chrono::sys_time<nanoseconds>(nanoseconds(sample.source_timestamp));
  if (sample.valid_data)
    arrival.body.assign(reinterpret_cast<const char*>(envelope.body._buffer), envelope.body._length);
  else if (sample.instance_state == DDS_IST_NOT_ALIVE_DISPOSED)
    arrival.kind = Arrival::Kind::kEnded;
  else
    arrival.kind = Arrival::Kind::kOrphaned;
  return arrival;
}

}  // namespace

void Waiting::add(Arrival arrival) {
  const std::size_t size = arrival.key.size() + arrival.body.size();
  const bool is_message = arrival.kind == Arrival::Kind::kMessage;
  if (is_newest_only_ && is_message) {
    if (const auto found = newest_.find(arrival.key); found != newest_.end()) {
      Arrival& older = arrivals_[found->second];
      bytes_ = bytes_ - older.key.size() - older.body.size() + size;
      older = std::move(arrival);
      return;
    }
  }
  if (arrivals_.size() >= Reader::kMaxWaiting || bytes_ + size > Reader::kMaxWaitingBytes) {
    ++lost_;
    lost_at_ = arrival.noticed;
    return;
  }
  bytes_ += size;
  if (is_newest_only_ && is_message) newest_[arrival.key] = arrivals_.size();
  // What comes after its end is not what it ended.
  if (is_newest_only_ && !is_message) newest_.erase(arrival.key);
  arrivals_.push_back(std::move(arrival));
}

std::vector<Arrival> Waiting::take() {
  std::vector<Arrival> taken = std::exchange(arrivals_, {});
  newest_.clear();
  bytes_ = 0;
  if (lost_ != 0) {
    taken.push_back({.kind = Arrival::Kind::kLost,
                     .key = {},
                     .body = {},
                     .sender = {},
                     .sent = {},
                     .noticed = lost_at_,
                     .lost = std::exchange(lost_, 0)});
  }
  return taken;
}

Reader::State::State(std::shared_ptr<ParticipantCore> core, std::shared_ptr<WaiterState> waiter,
                     std::string topic, ChannelKind kind)
    : core_(std::move(core)),
      waiter_(std::move(waiter)),
      writers_(std::move(topic), kind, "writes"),
      waiting_(info(kind).is_newest_only),
      is_newest_only_(info(kind).is_newest_only),
      are_messages_quiet_(info(kind).lease.count() > 0) {}

std::expected<void, std::string> Reader::State::begin(const std::string& topic, ChannelKind kind) {
  auto made = core_->topic(topic);
  if (!made) return std::unexpected(made.error());
  topic_ = std::move(*made);
  const Qos qos = qos_of(info(kind));
  const Listener told = listener();
  hand_over(this);
  const dds_entity_t reader =
      dds_create_reader(core_->subscriber.handle(), topic_.handle(), qos.get(), told.get());
  if (reader < 0)
    return std::unexpected(fmt::format("`{}` can't be read: {}", topic, dds_strretcode(reader)));
  reader_ = Entity(reader);
  return {};
}

Reader::State::~State() {
  reader_.reset();
  take_over(this);
}

Listener Reader::State::listener() {
  Listener made(dds_create_listener(this));
  dds_lset_data_available(made.get(), on_data);
  dds_lset_subscription_matched(made.get(), on_matched);
  dds_lset_liveliness_changed(made.get(), on_liveliness);
  dds_lset_requested_incompatible_qos(made.get(), on_incompatible);
  return made;
}

void Reader::State::on_data(dds_entity_t reader, void* state) {
  const ListenerCall call(state);
  auto& self = *static_cast<State*>(state);
  while (self.fetch(reader)) {
  }
}

/// @return  whether there may be more
bool Reader::State::fetch(dds_entity_t reader) {
  // Lent by Cyclone, which reads the next ones into the same memory.
  std::array<void*, kBatch> samples{};
  std::array<dds_sample_info_t, kBatch> about{};
  const dds_return_t count = dds_take(reader, samples.data(), about.data(), kBatch, kBatch);
  if (count <= 0) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (is_prompt(*static_cast<const mlab_dds_Envelope*>(samples[i]))) continue;
    const auto who = sender(reader, about[i].publication_handle);
    if (!who) continue;
    Arrival arrival = arrival_of(*static_cast<const mlab_dds_Envelope*>(samples[i]), about[i]);
    arrival.sender = *who;
    tell(std::move(arrival));
  }
  dds_return_loan(reader, samples.data(), count);
  return count == static_cast<dds_return_t>(kBatch);
}

std::optional<Guid> Reader::State::sender(dds_entity_t reader, dds_instance_handle_t writer) {
  std::optional<Counterparts::Counterpart> known;
  {
    const std::lock_guard lock(mutex_);
    known = writers_.find(writer);
  }
  // The first message may come before it is told that its writer has.
  if (!known) known = look_up(reader, writer);
  if (!known) core_->complaints.add("a message was dropped whose writer is not known");
  if (known && known->fits) return known->participant;
  return std::nullopt;
}

std::optional<Counterparts::Counterpart> Reader::State::look_up(dds_entity_t reader,
                                                                dds_instance_handle_t writer) {
  dds_builtintopic_endpoint_t* const endpoint = dds_get_matched_publication_data(reader, writer);
  if (endpoint == nullptr) return std::nullopt;
  const std::lock_guard lock(mutex_);
  const Counterparts::Counterpart known = writers_.add(writer, *endpoint);
  dds_builtintopic_free_endpoint(endpoint);
  return known;
}

void Reader::State::on_matched(dds_entity_t reader, dds_subscription_matched_status_t status, void* state) {
  const ListenerCall call(state);
  auto& self = *static_cast<State*>(state);
  const bool is_there = status.current_count_change > 0;
  if (is_there) self.look_up(reader, status.last_publication_handle);
  std::optional<Counterparts::Counterpart> known;
  {
    const std::lock_guard lock(self.mutex_);
    self.writers_.set_there(status.last_publication_handle, is_there);
    known = self.writers_.find(status.last_publication_handle);
  }
  if (!known || !known->fits) return;
  self.tell({.kind = is_there ? Arrival::Kind::kMatched : Arrival::Kind::kUnmatched,
             .key = {},
             .body = {},
             .sender = known->participant,
             .sent = {},
             .noticed = {},
             .lost = 0});
}

void Reader::State::on_liveliness(dds_entity_t /*reader*/, dds_liveliness_changed_status_t status,
                                  void* state) {
  const ListenerCall call(state);
  auto& self = *static_cast<State*>(state);
  const bool is_silent = status.not_alive_count_change > 0;
  const bool is_alive = status.alive_count_change > 0 && status.not_alive_count_change < 0;
  if (!is_silent && !is_alive) return;
  std::optional<Counterparts::Counterpart> known;
  {
    const std::lock_guard lock(self.mutex_);
    self.writers_.set_silent(status.last_publication_handle, is_silent);
    known = self.writers_.find(status.last_publication_handle);
  }
  if (!known || !known->fits) return;
  self.tell({.kind = is_silent ? Arrival::Kind::kSilent : Arrival::Kind::kAlive,
             .key = {},
             .body = {},
             .sender = known->participant,
             .sent = {},
             .noticed = {},
             .lost = 0});
}

void Reader::State::on_incompatible(dds_entity_t /*reader*/, dds_requested_incompatible_qos_status_t status,
                                    void* state) {
  const ListenerCall call(state);
  auto& self = *static_cast<State*>(state);
  const std::lock_guard lock(self.mutex_);
  self.writers_.add_incompatible(status.last_policy_id);
  self.waiter_->signal();
}

void Reader::State::tell(Arrival arrival) {
  arrival.noticed = std::chrono::steady_clock::now();
  const std::lock_guard lock(mutex_);
  const auto branch = std::ranges::find_if(branches_, [&](const auto& one) {
    return arrival.kind == Arrival::Kind::kMessage && one->sender == arrival.sender &&
           one->key == arrival.key;
  });
  if (branch == branches_.end()) {
    const bool is_quiet = are_messages_quiet_ && arrival.kind == Arrival::Kind::kMessage;
    waiting_.add(std::move(arrival));
    if (!is_quiet) waiter_->signal();
    return;
  }
  (*branch)->waiting.add(std::move(arrival));
  (*branch)->waiter->signal();
}

std::shared_ptr<Reader::Branch::Queue> Reader::State::add_branch(const Guid& sender, std::string_view key,
                                                                 std::shared_ptr<WaiterState> waiter) {
  auto made = std::make_shared<Branch::Queue>(
      Branch::Queue{sender, std::string(key), std::move(waiter), Waiting(is_newest_only_)});
  const std::lock_guard lock(mutex_);
  return branches_.emplace_back(std::move(made));
}

void Reader::State::end_branch(const std::shared_ptr<Branch::Queue>& branch) {
  const std::lock_guard lock(mutex_);
  std::erase(branches_, branch);
}

std::vector<Arrival> Reader::State::take(Branch::Queue& branch) {
  const std::lock_guard lock(mutex_);
  return branch.waiting.take();
}

std::vector<Arrival> Reader::State::take() {
  const std::lock_guard lock(mutex_);
  return waiting_.take();
}

std::vector<Guid> Reader::State::senders() const {
  const std::lock_guard lock(mutex_);
  return writers_.participants();
}

std::vector<std::string> Reader::State::mismatches() const {
  const std::lock_guard lock(mutex_);
  return writers_.mismatches();
}

Reader::Reader(std::unique_ptr<State> state) : state_(std::move(state)) {}
Reader::Reader(Reader&&) noexcept = default;
Reader& Reader::operator=(Reader&&) noexcept = default;
Reader::~Reader() = default;

std::vector<Arrival> Reader::take() {
  return state_->take();
}
Reader::Branch Reader::branch(const Guid& sender, std::string_view key, const Waiter& waiter) {
  return {*state_, state_->add_branch(sender, key, waiter.state_)};
}

Reader::Branch::Branch(State& reader, std::shared_ptr<Queue> queue)
    : reader_(&reader), queue_(std::move(queue)) {}
Reader::Branch::Branch(Branch&& other) noexcept
    : reader_(std::exchange(other.reader_, nullptr)), queue_(std::move(other.queue_)) {}
Reader::Branch::~Branch() {
  if (reader_ != nullptr) reader_->end_branch(queue_);
}
std::vector<Arrival> Reader::Branch::take() {
  return reader_->take(*queue_);
}

std::vector<Guid> Reader::senders() const {
  return state_->senders();
}
std::vector<std::string> Reader::mismatches() const {
  return state_->mismatches();
}

}  // namespace mlab::dds
