#pragma once

#include <sys/types.h>

#include <memory>
#include <string>

#include "descriptor.h"
#include "seen.h"

namespace mlab::network {

/// A process that can be struck, whoever started it. It means this very process: once that has ended no other
/// with its number is struck.
class Victim {
 public:
  Victim() = default;
  Victim(std::string name, Descriptor pidfd);
  /// One that was seen a moment ago.
  explicit Victim(const Seen& process);

  const std::string& name() const { return name_; }
  /// The machine's number; -1: there was no such process.
  pid_t id() const { return id_; }
  bool is_alive() const;
  /// @return  false: it has ended, or may not be struck
  bool signal(int number) const;

 private:
  std::string name_;
  std::shared_ptr<const Descriptor> pidfd_;
  pid_t id_ = -1;
};

/// The number of the process that a pidfd stands for; -1: it has ended.
pid_t process_of(const Descriptor& pidfd);

}  // namespace mlab::network
