#include "mlab/dds/complaints.h"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "mlab/text/shown.h"

namespace mlab::dds {
namespace {

constexpr std::size_t kMaxComplaints = 50;
constexpr std::size_t kLongestComplaint = 400;

/// Who listens to which domain. Never destroyed: threads of Cyclone may speak until the process ends.
struct Listeners {
  std::mutex mutex;
  std::map<std::uint32_t, Complaints*> by_domain;
};

Listeners& listeners() {
  static auto* const kListeners = new Listeners;
  return *kListeners;
}

thread_local Complaints* opening = nullptr;

void hear(void* /*argument*/, const dds_log_data_t* said) {
  std::string_view words(said->message, said->size);
  while (!words.empty() && (words.back() == '\n' || words.back() == ' ')) words.remove_suffix(1);
  Listeners& all = listeners();
  const std::lock_guard lock(all.mutex);
  const auto found = all.by_domain.find(said->domid);
  Complaints* const who = found == all.by_domain.end() ? opening : found->second;
  if (who != nullptr) who->add(text::shown(words, kLongestComplaint));
}

}  // namespace

Complaints::Complaints(std::uint32_t domain) : domain_(domain) {
  static std::once_flag is_heard;
  std::call_once(is_heard, [] {
    dds_set_log_sink(hear, nullptr);
    dds_set_trace_sink(hear, nullptr);
  });
  const std::lock_guard lock(listeners().mutex);
  listeners().by_domain[domain] = this;
  opening = this;
}

Complaints::~Complaints() {
  opened();
  const std::lock_guard lock(listeners().mutex);
  listeners().by_domain.erase(domain_);
}

void Complaints::opened() {
  if (opening == this) opening = nullptr;
}

void Complaints::add(std::string complaint) {
  const std::lock_guard lock(mutex_);
  // Cyclone hands a warning to both of its outlets.
  if (!said_.empty() && said_.back() == complaint) return;
  said_.push_back(std::move(complaint));
  if (said_.size() > kMaxComplaints) said_.pop_front();
}

std::vector<std::string> Complaints::take() {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> taken(std::make_move_iterator(said_.begin()),
                                 std::make_move_iterator(said_.end()));
  said_.clear();
  return taken;
}

}  // namespace mlab::dds
