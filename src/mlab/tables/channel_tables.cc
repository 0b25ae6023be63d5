#include "mlab/tables/channel_tables.h"

#include <string_view>

#include <fmt/core.h>

#include "mlab/dds/channel.h"

namespace mlab::tables {

namespace {

std::string_view how_lost(const dds::ChannelInfo& channel) {
  if (!channel.is_reliable) return "stay lost";
  return channel.is_asked_after ? "are sent again at once" : "are sent again";
}

}  // namespace

std::string channel_documentation() {
  std::string out =
      "| channel | lost packets | waiting for who reads | who comes late | full after | why "
      "|\n|---|---|---|---|---|---|\n";
  for (const dds::ChannelInfo& one : dds::kChannels) {
    const std::string lease =
        one.lease.count() > 0
            ? fmt::format("; silent after {} s", static_cast<double>(one.lease.count()) / 1000)
            : "";
    const std::string full =
        one.longest_wait.count() > 0 ? fmt::format("{} ms", one.longest_wait.count()) : "never";
    out += fmt::format("| {} | {} | {} | {}{} | {} | {} |\n", one.name, how_lost(one),
                       one.is_newest_only ? "the newest of each key" : "all, in order",
                       one.is_for_latecomers ? "gets the newest of each key" : "gets what comes from then on",
                       lease, full, one.reason);
  }
  return out;
}

}  // namespace mlab::tables
