#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/dds/message.h"

namespace mlab::dds {

/// How a write went.
enum class Written : std::uint8_t {
  kDone,     ///< it is on its way; or nobody reads the topic
  kFull,     ///< readers did not keep up for the channel's `longest_wait`: it was not written
  kTooLong,  ///< the body is longer than kMaxBody
  kBadKey,   ///< the key is longer than kMaxKey, has a byte 0, or is what prompts have
  kFailed,   ///< Cyclone has no memory, or no network any more: Participant::complaints may tell
};

/// One topic, written. Made by Participant::writer; it takes part until it is destroyed, which may take up to
/// a second where something that it has written was not received by all readers yet. Its keys are not ended
/// by that. May be used by any thread.
class Writer {
 public:
  Writer(Writer&&) noexcept;
  Writer& operator=(Writer&&) noexcept;
  ~Writer();

  /// Sends from the calling thread, and waits no longer than the channel's `longest_wait`.
  [[nodiscard]] Written write(std::string_view key, std::string_view body);

  /// Tells readers that there is no more of this key, and keeps nothing of it for who comes late. It may be
  /// written again.
  [[nodiscard]] Written end(std::string_view key);

  /// The participants that read this topic, as what it is written as. Both sides find each other by
  /// themselves: a reader may know of this writer some milliseconds earlier. What is written before somebody
  /// stands here need not reach him, except on channels that are for latecomers. On reliable ones he stands
  /// here as soon as he has answered, or after a second.
  std::vector<Guid> readers() const;

  /// Who reads this topic as something else, as Reader::mismatches. Nothing of this writer is taken there.
  std::vector<std::string> mismatches() const;

 private:
  friend class Participant;
  class State;
  explicit Writer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace mlab::dds
