#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>

#include "mlab/history/bookmarks.h"
#include "mlab/mcap/records.h"

namespace mlab::history {

/// A change as a recording has it while it is written: a record of metadata, which leaves its messages alone
/// and which any program for MCAP files can list. Of several with one id the last one counts.
mcap::Metadata bookmark_record(const Bookmark& one);
/// It was removed.
mcap::Metadata bookmark_record(std::uint64_t id);

/// What is known of a recording's bookmarks: those that it holds itself, and over them those that a file
/// beside it holds, `RUN.mcap.bookmarks`. So who writes something to a recording that is complete never
/// touches its bytes.
struct KeptBookmarks {
  Bookmarks bookmarks;
  /// The highest id that the recording itself had when the file beside it was written: what has a higher one
  /// came later, and isn't left out in it on purpose.
  std::uint64_t recorded_to = 0;
  std::string written;  ///< what the file beside it holds, as bytes; empty: there is none
  /// What of it can't be read, as a sentence; empty: all can.
  std::string problem;
  /// Which were written at moments that the run doesn't have, as a sentence; empty: none.
  std::string moved;
  std::optional<RunExtent> run;  ///< nothing: nobody knows how far it goes
};

std::string bookmark_path(const std::string& recording);

/// Whoever wrote them. Where the recording can't be read there are none in it.
/// @param run  how far the run goes: no bookmark is beyond
KeptBookmarks read_bookmarks(const std::string& recording, const std::optional<RunExtent>& run = {});

/// Replaces the file beside the recording as a whole; after an error it is as it was. One that can't be read,
/// or not all of which is as it was read, is not lost: it is called `.unreadable` from then on.
/// @param kept  its `written` is what stands there, and what was written afterwards
/// @errors  a sentence; also where somebody else has written it meanwhile
std::expected<void, std::string> write_bookmarks(const std::string& recording, KeptBookmarks& kept);

}  // namespace mlab::history
