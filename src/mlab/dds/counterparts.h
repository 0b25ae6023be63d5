#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/dds/channel.h"
#include "mlab/dds/message.h"

namespace mlab::dds {

/// The writers that match a reader, or the readers that match a writer, by Cyclone's handles. Its owner
/// locks.
class Counterparts {
 public:
  struct Counterpart {
    Guid participant;
    bool fits = false;  ///< it is of the same kind: what it says counts
    bool is_there = true;
    bool is_silent = false;
    bool is_joining = false;  ///< what is written may still pass it by
  };

  /// @param topic  for sentences
  /// @param does   what they do with the topic: `reads`, `writes`
  Counterparts(std::string topic, ChannelKind kind, std::string_view does)
      : topic_(std::move(topic)), kind_(kind), does_(does) {}

  /// What is known of one. It is kept when it goes, since its last words may be read after that.
  /// @return  empty for who is not known
  std::optional<Counterpart> find(dds_instance_handle_t handle) const;

  /// Notes one that Cyclone tells of.
  Counterpart add(dds_instance_handle_t handle, const dds_builtintopic_endpoint_t& endpoint);
  void set_there(dds_instance_handle_t handle, bool is_there);
  void set_silent(dds_instance_handle_t handle, bool is_silent);
  void set_joining(dds_instance_handle_t handle, bool is_joining);
  void add_incompatible(std::uint32_t policy);

  /// Of the same kind, there, not silent, and not joining any more.
  std::vector<Guid> participants() const;
  const std::vector<std::string>& mismatches() const { return mismatches_; }

 private:
  void note(std::string mismatch);
  void forget_some();

  std::string topic_;
  ChannelKind kind_;
  std::string_view does_;
  std::map<dds_instance_handle_t, Counterpart> all_;
  std::vector<std::string> mismatches_;
};

}  // namespace mlab::dds
