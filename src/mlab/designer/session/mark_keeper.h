#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/request.h"
#include "mlab/designer/session/trials.h"
#include "mlab/designer/trial/mark_store.h"
#include "mlab/designer/trial/marks.h"

namespace mlab::designer {

/// The marks of all documents, also of those that nobody looks at now: they follow the texts and what is
/// tried, and are kept for the next server.
class MarkKeeper {
 public:
  /// @param state_folder  of the user; empty: nothing is kept
  MarkKeeper(Desk& desk, const Trials& trials, const std::string& state_folder)
      : desk_(desk),
        trials_(trials),
        store_(state_folder.empty() ? "" : state_folder + "/designer", desk.project().folder()) {}

  void set(const SetMark& request, Answer& out);
  void remove(const RemoveMark& request, Answer& out);

  /// Null where the document has none.
  const Marks* find(const std::string& document) const;
  /// Takes them to the texts as they stand now, and, once after each trial, to where their pages run in it.
  void follow();

  // ---- keeping

  /// Those of an earlier server.
  void restore(const OpenConfiguration& document);
  void drop(const std::string& document);
  void rename(const std::string& from, const std::string& to);
  /// What could not be kept is tried again, but not all the time.
  void keep_again();
  /// Of which documents they could not be kept, and why: sentences.
  std::vector<std::string> losses() const;

 private:
  void keep(const std::string& document, const Marks& marks);
  /// @return  whether something of them is otherwise
  bool follow_trial(const OpenConfiguration& document, Marks& marks);

  Desk& desk_;
  const Trials& trials_;
  MarkStore store_;
  std::map<std::string, Marks> marks_;           // by document
  std::map<std::string, std::string> not_kept_;  // by document: why
  std::uint64_t followed_trial_ = 0;             // Trials::number
  double tried_ = 0.0;                           // to keep them again
};

}  // namespace mlab::designer
