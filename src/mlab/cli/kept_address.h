#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/documents/state_folder.h"

namespace mlab::cli {

/// Where the last server of a project was found, so that pages which were left open find the next one. It
/// opens the door, so nobody else may read it: a file that others could have read or made is not believed.
class KeptAddress {
 public:
  struct Address {
    std::string host;  ///< that is listened to
    std::uint16_t port = 0;
    std::string token;
  };
  enum class Lookup {
    kNone,
    kAddress,
    kTaken,   ///< another server of this project serves there now
    kUnsafe,  ///< `problem` says why it is not believed
  };

  /// @param folder   as StateFolder
  /// @param project  as StateFolder
  /// @param kind     of server: each has an address of its own
  KeptAddress(const std::string& folder, const std::string& project, std::string kind);
  ~KeptAddress();
  KeptAddress(const KeptAddress&) = delete;
  KeptAddress& operator=(const KeptAddress&) = delete;

  Lookup found() const { return found_; }
  /// Of the last server; empty parts where there was none.
  const Address& address() const { return address_; }
  const std::string& problem() const { return problem_; }
  /// For the next server. Where another one serves, its own stays.
  /// @return  why it could not be kept; empty: it was
  std::string keep(const Address& address) const;

 private:
  /// Held until this ends, however that happens.
  bool lock();
  void read();
  bool parse(std::string_view text);

  documents::StateFolder folder_;
  std::string project_;
  std::string name_;
  int lock_ = -1;
  Lookup found_ = Lookup::kNone;
  Address address_;
  std::string problem_;
};

}  // namespace mlab::cli
