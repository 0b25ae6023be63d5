#pragma once

#include <map>
#include <string>
#include <utility>

#include "mlab/history.pb.h"
#include "mlab/text/source.h"

namespace mlab::history {

/// Names of files in recordings. There they begin where the mission lies, so that a recording says the same
/// names on any machine, and does not tell where its mission lay.
class RecordedNames {
 public:
  /// @param folder  of the mission with which the run begins, by which its files were read
  explicit RecordedNames(std::string folder) : folder_(std::move(folder)) {}

  /// With such names in place of those by which the files were read.
  wire::HistoryEntry in_recording(wire::HistoryEntry entry) const;
  wire::HistoryBeginning in_recording(wire::HistoryBeginning beginning) const;

 private:
  void shorten(std::string& path) const;
  void shorten(wire::HistoryMission& mission) const;

  std::string folder_;
};

/// Sources of a recording by what texts call them, however they write it.
class RecordedSources {
 public:
  void add(const text::SourcePtr& source);
  /// Null: there is none of the name.
  text::SourcePtr find(const std::string& path) const;

 private:
  std::map<std::string, text::SourcePtr> by_path_;
};

}  // namespace mlab::history
