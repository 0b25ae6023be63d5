#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string_view>

#include "mlab/base/table.h"

namespace mlab::dds {

/// What is said on a topic, and so how it has to arrive. Who writes and who reads a topic say the same.
enum class ChannelKind : std::uint8_t {
  kCommands,
  kLockStepPercepts,
  kLivePercepts,
  kActions,
  kStatus,
  kEvents,
  kPresence,
  kSignsOfLife,
  kEmergencyStop,
  kEchoes,
};

/// How what is said on a channel arrives. `tools/tables` writes the documentation from it.
struct ChannelInfo {
  ChannelKind kind;
  std::string_view name;  ///< goes over the wire: a reader takes nothing that is written as another kind
  /// Whether what is lost on the way is sent again, and arrives in the order in which it was written.
  bool is_reliable;
  /// Whether what is lost is noticed within milliseconds, because somebody may be waiting for it; else with
  /// what is written next, or some tenths of a second later. Of reliable ones only.
  bool is_asked_after;
  /// Whether of each key only the newest is kept, on both sides, where nobody has taken it yet.
  bool is_newest_only;
  /// Whether who comes late is told the newest of each key.
  bool is_for_latecomers;
  /// How long a writer may be silent before it counts as lost [ms]; 0: as long as its participant is there.
  std::chrono::milliseconds lease;
  /// How long a write waits for place where readers don't keep up [ms].
  std::chrono::milliseconds longest_wait;
  std::string_view reason;  ///< for the documentation, in Markdown
};

/// By their numbers.
inline constexpr std::array kChannels = {
    ChannelInfo{
        .kind = ChannelKind::kCommands,
        .name = "commands",
        .is_reliable = true,
        .is_asked_after = true,
        .is_newest_only = false,
        .is_for_latecomers = false,
        .lease = std::chrono::milliseconds{0},
        .longest_wait = std::chrono::milliseconds{20},
        .reason =
            "each one counts, and in its order. Who comes late must not carry out what was meant for "
            "somebody before it. The wait is short: one robot that hears nothing must not keep commands "
            "from the others"},
    ChannelInfo{
        .kind = ChannelKind::kLockStepPercepts,
        .name = "lock-step percepts",
        .is_reliable = true,
        .is_asked_after = true,
        .is_newest_only = false,
        .is_for_latecomers = false,
        .lease = std::chrono::milliseconds{0},
        .longest_wait = std::chrono::milliseconds{100},
        .reason = "a cycle that is lost would stop the run, and a robot that skips one would end elsewhere"},
    ChannelInfo{
        .kind = ChannelKind::kLivePercepts,
        .name = "live percepts",
        .is_reliable = false,
        .is_asked_after = false,
        .is_newest_only = true,
        .is_for_latecomers = false,
        .lease = std::chrono::milliseconds{0},
        .longest_wait = std::chrono::milliseconds{0},
        .reason =
            "what a robot sensed a moment ago is worth nothing once there is something newer; sending it "
            "again would only delay that"},
    ChannelInfo{
        .kind = ChannelKind::kActions,
        .name = "actions",
        .is_reliable = true,
        .is_asked_after = true,
        .is_newest_only = true,
        .is_for_latecomers = false,
        .lease = std::chrono::milliseconds{0},
        .longest_wait = std::chrono::milliseconds{100},
        .reason = "in lock-step a robot acts once and waits, so nothing is overtaken and all must arrive; in "
                  "real time only its newest action counts"},
    ChannelInfo{
        .kind = ChannelKind::kStatus,
        .name = "status",
        .is_reliable = true,
        .is_asked_after = false,
        .is_newest_only = true,
        .is_for_latecomers = true,
        .lease = std::chrono::milliseconds{0},
        .longest_wait = std::chrono::milliseconds{20},
        .reason =
            "a console that comes late, or comes back, has to show what is true without asking anybody"},
    ChannelInfo{
        .kind = ChannelKind::kEvents,
        .name = "events",
        .is_reliable = true,
        .is_asked_after = true,
        .is_newest_only = false,
        .is_for_latecomers = false,
        .lease = std::chrono::milliseconds{0},
        .longest_wait = std::chrono::milliseconds{100},
        .reason =
            "the executive and the report count them: one that is lost or out of order makes both untrue"},
    ChannelInfo{
        .kind = ChannelKind::kPresence,
        .name = "presence",
        .is_reliable = true,
        .is_asked_after = false,
        .is_newest_only = true,
        .is_for_latecomers = true,
        .lease = std::chrono::milliseconds{0},
        .longest_wait = std::chrono::milliseconds{20},
        .reason =
            "who is there, with its versions, has to be known to who comes late. All tell it all, so it is "
            "said seldom"},
    ChannelInfo{
        .kind = ChannelKind::kSignsOfLife,
        .name = "signs of life",
        .is_reliable = false,
        .is_asked_after = false,
        .is_newest_only = true,
        .is_for_latecomers = false,
        .lease = std::chrono::milliseconds{600},
        .longest_wait = std::chrono::milliseconds{0},
        .reason =
            "who is gone has to be known within a second. It is written many times in that, so one that "
            "is lost does not matter; only those read it who have to know so soon, since all who hear "
            "it from all would take more of the machines than their work"},
    ChannelInfo{
        .kind = ChannelKind::kEmergencyStop,
        .name = "emergency stop",
        .is_reliable = false,
        .is_asked_after = false,
        .is_newest_only = true,
        .is_for_latecomers = false,
        .lease = std::chrono::milliseconds{0},
        .longest_wait = std::chrono::milliseconds{0},
        .reason =
            "it is written again and again until it is acknowledged. Written once and reliably, it would "
            "come too late where a packet is lost, and would wait for robots that don't listen"},
    ChannelInfo{
        .kind = ChannelKind::kEchoes,
        .name = "echoes",
        .is_reliable = false,
        .is_asked_after = false,
        .is_newest_only = false,
        .is_for_latecomers = false,
        .lease = std::chrono::milliseconds{0},
        .longest_wait = std::chrono::milliseconds{0},
        .reason =
            "the way there and back is measured by them, and what of it is lost. Sent again they would tell "
            "neither, and one whose place a newer one took would count as lost: an agent answers all who "
            "ask"},
};
static_assert(base::has_a_row_for_each<kChannels, &ChannelInfo::kind>());

constexpr const ChannelInfo& info(ChannelKind kind) {
  return base::row_of(kChannels, &ChannelInfo::kind, kind);
}

}  // namespace mlab::dds
