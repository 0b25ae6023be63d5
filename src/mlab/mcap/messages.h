#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/mcap/limits.h"
#include "mlab/mcap/records.h"
#include "mlab/mcap/source.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mcap {

struct Contents;
struct Piece;

/// Which messages of a file are wanted.
struct Selection {
  std::vector<std::string> topics = {};  ///< of all channels with one of these topics; empty: all
  std::uint64_t from = 0;                ///< the earliest log time [ns]
  std::uint64_t to = UINT64_MAX;         ///< the latest log time, included [ns]
};

/// Messages of a file, in the order of their log times; equal ones in the order of the file. Only chunks that
/// may have some are read, each when its time comes, and only those that overlap in time are kept at once.
class Messages {
 public:
  Messages(std::shared_ptr<const Source> source, std::shared_ptr<const Contents> contents, Limits limits,
           const Selection& selection);
  ~Messages();
  Messages(Messages&& from) noexcept;
  Messages& operator=(Messages&& from) noexcept;

  /// The next message; null behind the last one. It and its bytes are valid until the next call.
  /// @errors  `broken-chunk`: the chunk that is next can't be read: none of its messages is given, and the
  ///          next call goes on behind it. All messages that come before it have been given
  text::Result<const Message*> next();

 private:
  struct Open;

  bool is_wanted(ChannelId channel) const { return channel.value < wanted_.size() && wanted_[channel.value]; }
  bool may_have_some(const Piece& piece) const;
  bool has_to_open() const;
  void open(const Piece& piece);
  void keep_spare(std::unique_ptr<Open> one);
  std::optional<std::string> load(const Piece& piece, Open& out);
  std::optional<std::string> list(const Piece& piece, std::span<const std::byte> records, Open& out) const;

  std::shared_ptr<const Source> source_;
  std::shared_ptr<const Contents> contents_;
  Limits limits_;
  std::uint64_t from_ = 0;
  std::uint64_t to_ = 0;
  std::vector<bool> wanted_;                  // by the number of a channel
  std::vector<const Piece*> waiting_;         // by their first time, the earliest last
  std::vector<std::unique_ptr<Open>> open_;   // a heap, the earliest first
  std::vector<std::unique_ptr<Open>> spare_;  // their memory is used again
  std::uint64_t open_bytes_ = 0;
  Message message_;
};

}  // namespace mlab::mcap
