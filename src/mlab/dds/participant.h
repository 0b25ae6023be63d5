#pragma once

#include <expected>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/dds/channel.h"
#include "mlab/dds/message.h"
#include "mlab/dds/network.h"
#include "mlab/dds/reader.h"
#include "mlab/dds/waiter.h"
#include "mlab/dds/writer.h"

namespace mlab::dds {

class ParticipantCore;

/// Takes part in a fleet. Each one has sockets, threads (six or seven) and memory (some megabytes) of its
/// own, also beside others of the same process, and hears those over the network as if they were elsewhere;
/// so an agent has one for all of its robots. Not to be carried over a fork.
///
/// Threads: what is called here, and of readers and writers, runs on the calling thread; writers send on it.
/// Cyclone's own (`recv`, `recvUC`, `tev`, `dq.builtins`, `dq.user`, `gc`) receive, send again what was lost,
/// say that this participant is alive, and notice who comes, goes or is silent. They put what arrives into
/// readers' queues and signal waiters, and run no code of callers. One more is there once a channel that is
/// asked after is written (Prompter).
///
/// It lives until it, its writers and its readers have been destroyed, and then leaves nothing behind: no
/// thread, no file, no shared memory (that of iceoryx, which Cyclone could use, is off).
class Participant {
 public:
  /// Others are found within seconds from then on; nothing waits for it.
  /// @errors  a sentence for a person, with what Cyclone has to say: a setting that can't be used, or no
  ///          place left (kMaxParticipants)
  static std::expected<Participant, std::string> open(const Network& network);

  Participant(Participant&&) noexcept;
  Participant& operator=(Participant&&) noexcept;
  ~Participant();

  Guid guid() const;

  /// @param topic   1 to 200 letters, digits, `_`, `-`, `.` and `/`
  /// @param waiter  if any, it is signalled when readers come or go; may end before the writer
  /// @errors  a sentence
  std::expected<Writer, std::string> writer(std::string_view topic, ChannelKind kind,
                                            const Waiter* waiter = nullptr);

  /// @param waiter  is signalled whenever there is something to take, but messages of a channel with a lease,
  ///                which say no more than that their writer is alive; may end before the reader
  /// @errors  a sentence
  std::expected<Reader, std::string> reader(std::string_view topic, ChannelKind kind, const Waiter& waiter);

  /// By what it proves who it is has run out (`time_left` of security.h): in a moment nobody hears it any
  /// more, and it makes no writer or reader.
  bool has_run_out() const;

  /// What Cyclone has warned of since the last call, the newest 50: networks that went away, packets of
  /// strangers that it could not read. It writes nothing to the terminal.
  std::vector<std::string> complaints();

 private:
  explicit Participant(std::shared_ptr<ParticipantCore> core);
  std::shared_ptr<ParticipantCore> core_;
};

}  // namespace mlab::dds
