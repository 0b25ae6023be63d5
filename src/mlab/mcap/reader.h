#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "mlab/mcap/ending.h"
#include "mlab/mcap/limits.h"
#include "mlab/mcap/messages.h"
#include "mlab/mcap/records.h"
#include "mlab/mcap/source.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mcap {

/// Reads an MCAP file:
///
///     auto reader = Reader::open("run.mcap");
///     Messages messages = reader->messages({.topics = {"/poses"}, .from = start, .to = start + second});
///     for (auto one = messages.next(); one && *one != nullptr; one = messages.next()) show(**one);
///
/// A file that was closed by its writer is opened by its summary, and nothing else is read. One that was cut
/// off (its writer was killed, or is still at work), or whose end is broken, is looked through once: then all
/// that is whole in front of the cut is there, and `ending` says how far and why no further.
///
/// Whoever wrote the file: nothing in it makes a reader crash, throw, or take more memory than `Limits` say.
/// What has a checksum and was changed is never given. Several threads may use one reader; an iterator
/// belongs to one.
class Reader {
 public:
  /// @errors  `cannot-read`: the system's reason; `no-mcap`: what the file is instead
  static text::Result<Reader> open(const std::string& path, const Limits& limits = {});
  /// @param name  for messages
  static text::Result<Reader> over(std::shared_ptr<const Source> source, std::string name,
                                   const Limits& limits = {});

  const Header& header() const;
  /// Of a file that is not whole: of what can be read.
  const Summary& summary() const;
  const Ending& ending() const;

  /// May outlive the reader. Topics that the file does not have give no messages.
  Messages messages(const Selection& selection = {}) const;

  /// The last one of this name, its checksum looked at.
  /// @errors  `no-attachment`: there is none, or what is wrong with it
  text::Result<Attachment> attachment(std::string_view name) const;
  text::Result<Attachment> attachment(const AttachmentIndex& index) const;
  /// The last ones of this name. They have no checksum of their own.
  /// @errors  `no-metadata`: there are none, or what is wrong with them
  text::Result<Metadata> metadata(std::string_view name) const;
  text::Result<Metadata> metadata(const MetadataIndex& index) const;

 private:
  Reader(std::shared_ptr<const Source> source, std::shared_ptr<const Contents> contents, std::string name,
         const Limits& limits);

  std::shared_ptr<const Source> source_;
  std::shared_ptr<const Contents> contents_;
  std::string name_;
  Limits limits_;
};

}  // namespace mlab::mcap
