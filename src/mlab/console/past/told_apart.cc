#include "mlab/console/past/told_apart.h"

#include <algorithm>
#include <string_view>

#include "mlab/text/kept_lines.h"

namespace mlab::console {
namespace {

using Entries = std::vector<const Log::Entry*>;

Entries events_of(const EventLog& log) {
  Entries out;
  for (std::uint64_t number = 1; number <= log.last(); ++number) {
    const Log::Entry* const entry = log.find(number);
    if (entry != nullptr && entry->kind() != Log::STATE) out.push_back(entry);
  }
  return out;
}

std::vector<std::string_view> words_of(const Entries& entries) {
  std::vector<std::string_view> out;
  for (const Log::Entry* const entry : entries) out.push_back(entry->text());
  return out;
}

// Alerts first where there are too many.
std::vector<Log::Entry> listed(Entries alone, std::uint64_t& left_out) {
  if (alone.size() > ToldApart::kMost) {
    left_out += alone.size() - ToldApart::kMost;
    std::ranges::stable_partition(alone, [](const Log::Entry* entry) { return entry->is_alert(); });
    alone.resize(ToldApart::kMost);
    std::ranges::sort(alone, {}, [](const Log::Entry* entry) { return entry->number(); });
  }
  std::vector<Log::Entry> out;
  for (const Log::Entry* const entry : alone) out.push_back(*entry);
  return out;
}

}  // namespace

ToldApart told_apart(const EventLog& own, const EventLog& other) {
  const std::array<Entries, 2> events = {events_of(own), events_of(other)};
  const std::vector<int> kept = text::kept_lines(words_of(events[0]), words_of(events[1]));
  std::array<Entries, 2> alone;
  std::vector<bool> is_in_both(events[1].size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] < 0)
      alone[0].push_back(events[0][i]);
    else
      is_in_both[static_cast<std::size_t>(kept[i])] = true;
  }
  for (std::size_t i = 0; i < is_in_both.size(); ++i) {
    if (!is_in_both[i]) alone[1].push_back(events[1][i]);
  }
  ToldApart out;
  for (const std::size_t side : {0U, 1U}) out.alone[side] = listed(std::move(alone[side]), out.left_out);
  return out;
}

}  // namespace mlab::console
