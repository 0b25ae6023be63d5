#include "mlab/console/run/event_log.h"

#include <utility>

#include "mlab/text/shown.h"

namespace mlab::console {

void EventLog::add(double time, Entry entry) {
  constexpr std::size_t kMostCharacters = 1000;  // of a text that a mission's author had a hand in
  ++counts_[static_cast<std::size_t>(entry.kind)];
  Log::Entry told;
  told.set_time(time);
  told.set_kind(entry.kind);
  told.set_text(text::shown(entry.text, kMostCharacters));
  told.set_robot(entry.robot);
  told.set_unit(text::shown(entry.unit));
  told.set_is_alert(entry.is_alert);
  if (entry.place) {
    told.mutable_place()->set_x(entry.place->x);
    told.mutable_place()->set_y(entry.place->y);
  }
  add_told(std::move(told));
}

void EventLog::add_told(Log::Entry told) {
  told.set_number(++last_);
  entries_.push_back(std::move(told));
  if (entries_.size() > kMost) entries_.pop_front();
}

const Log::Entry* EventLog::find(std::uint64_t number) const {
  const std::uint64_t first = last_ - entries_.size() + 1;
  if (number < first || number > last_) return nullptr;
  return &entries_[static_cast<std::size_t>(number - first)];
}

void EventLog::put_before(std::vector<Log::Entry> earlier, std::uint64_t alerts_after) {
  const std::deque<Log::Entry> present = std::exchange(entries_, {});
  ++last_;  // a gap: what anybody has seen is not the beginning of this
  alerts_after_ = last_;
  for (Log::Entry& one : earlier) {
    const std::uint64_t number = one.number();
    add_told(std::move(one));
    if (number <= alerts_after) alerts_after_ = last_;
  }
  for (const Log::Entry& one : present) add_told(one);
}

void EventLog::encode_since(std::uint64_t number, Log& out) const {
  const std::uint64_t first = last_ - entries_.size() + 1;
  out.set_alerts_after(alerts_after_);
  out.set_is_whole(number + 1 < first || number == 0);
  for (std::uint64_t n = std::max(number + 1, first); n <= last_; ++n)
    *out.add_entries() = entries_[static_cast<std::size_t>(n - first)];
}

}  // namespace mlab::console
