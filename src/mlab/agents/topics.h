#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "mlab/dds/message.h"
#include "mlab/dds/writer.h"

/// The topics of a fleet, and how messages of any length pass through them.

namespace mlab::agents {

inline constexpr std::string_view kPresenceTopic = "agents";   ///< proto/mlab/presence.proto, by agent
inline constexpr std::string_view kLifeTopic = "agents/life";  ///< nothing in it, by agent

inline constexpr std::string_view kStopTopic = "stop";  ///< EmergencyStop of that file, by kStopKey
inline constexpr std::string_view kStopKey = "fleet";

inline constexpr std::string_view kMissedTopic = "missed";  ///< MissedAgents of that file, by who says it

inline constexpr std::string_view kEchoQuestionTopic = "echo/asked";  ///< EchoQuestion, by asker
inline constexpr std::string_view kEchoTopic = "echo/answered";       ///< Echo, by agent

/// Of one agent: proto/mlab/agent.proto, by conversation. Another one that has the same name, as long as they
/// have not met, is not meant.
inline std::string requests_topic(std::string_view agent, const dds::Guid& guid) {
  return "agents/" + std::string(agent) + "/requests/" + guid.text();
}
/// Of one conversation, so that a run which does not listen holds up no other.
inline std::string answers_topic(std::string_view agent, std::string_view conversation) {
  return "agents/" + std::string(agent) + "/answers/" + std::string(conversation);
}
/// What passes in real time, by number of the robot.
inline std::string percepts_topic(std::string_view agent, std::string_view conversation) {
  return "agents/" + std::string(agent) + "/percepts/" + std::string(conversation);
}
inline std::string actions_topic(std::string_view agent, std::string_view conversation) {
  return "agents/" + std::string(agent) + "/actions/" + std::string(conversation);
}
/// What runs call their conversations: 16 hexadecimal digits.
inline bool is_conversation(std::string_view key) {
  return key.size() == 16 && key.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// A message that is longer than what DDS carries at once goes in parts, each with a byte in front that says
/// whether more of it follow.
inline constexpr char kFirstParts = '+';
inline constexpr char kLastPart = '.';
inline constexpr std::size_t kMostInPart = dds::kMaxBody - 1;

/// How long both sides of a conversation wait until each hears the other.
inline constexpr std::chrono::seconds kMeetingPatience(5);

/// Writes a message, in as many parts as it takes.
/// @param goes_on  asked where readers don't keep up; false: nobody waits for them any more
/// @return  false: it was not written, or not whole
inline bool write_in_parts(dds::Writer& writer, std::string_view key, std::string_view message,
                           const std::function<bool()>& goes_on) {
  std::string part;
  for (bool is_last = false; !is_last;) {
    is_last = message.size() <= kMostInPart;
    part.assign(1, is_last ? kLastPart : kFirstParts);
    part.append(message.substr(0, kMostInPart));
    message.remove_prefix(part.size() - 1);
    dds::Written written = dds::Written::kFull;
    while ((written = writer.write(key, part)) == dds::Written::kFull) {
      if (!goes_on()) return false;
    }
    if (written != dds::Written::kDone) return false;
  }
  return true;
}

/// Puts messages together again.
class Assembly {
 public:
  /// A longer message is nonsense [bytes].
  static constexpr std::size_t kMost = std::size_t{64} << 20;

  enum class Outcome { kWhole, kMoreFollows, kNonsense };
  /// @return  kWhole: `message()` is one, until the next call
  Outcome add(std::string_view part) {
    if (is_whole_) message_.clear();
    is_whole_ = false;
    const bool is_last = part.starts_with(kLastPart);
    if (!is_last && !part.starts_with(kFirstParts)) return Outcome::kNonsense;
    if (message_.size() + part.size() > kMost) return Outcome::kNonsense;
    message_.append(part.substr(1));
    is_whole_ = is_last;
    return is_last ? Outcome::kWhole : Outcome::kMoreFollows;
  }
  const std::string& message() const { return message_; }

 private:
  std::string message_;
  bool is_whole_ = false;
};

}  // namespace mlab::agents
