#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "mlab/console/inbox.h"
#include "mlab/designer/latest_jobs.h"
#include "mlab/designer/session/answers.h"
#include "mlab/designer/session/clients.h"
#include "mlab/designer/session/comparing.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/request.h"

namespace mlab::designer {

/// Which document each client compares with which other version of it.
class Comparisons {
 public:
  struct Comparison {
    std::uint64_t number = 0;   ///< of its own, for every time that somebody asked
    std::uint64_t opening = 0;  ///< Client::opening_of the document: closed, it is compared no more
    Comparing comparing;
  };

  /// @param inbox  where what git finds is posted
  Comparisons(Desk& desk, Clients& clients, Answers& answers, std::shared_ptr<console::Inbox> inbox)
      : desk_(desk), clients_(clients), answers_(answers), inbox_(std::move(inbox)) {}

  Answered compare_with(const Sender& sender, const CompareWith& request, Answer& out);
  void stop(const Sender& sender, const StopComparing& request);
  Answered list_revisions(const Sender& sender, const ListRevisions& request, Answer& out);

  /// Takes all to the texts as they stand now, and forgets what nobody looks at any more.
  void follow();
  /// Null where that client does not compare it.
  const Comparison* find(console::ConnectionId client, const std::string& document) const;

 private:
  using Key = std::pair<console::ConnectionId, std::string>;

  /// @param base  named as the document's own text, so that it finds the same files
  void show(console::ConnectionId client, const OpenConfiguration& document, const std::string& title,
            std::string base, bool is_saved);
  Answered compare_with_revision(const Sender& sender, const OpenConfiguration& document,
                                 const std::string& revision, Answer& out);
  /// Answers later with what `ask` finds on another thread. What is asked under the same name while that
  /// takes its time takes its place; who asked before is told so.
  /// @param name  of what is asked for, with the document; each client has its own
  template <class Finding>
  void ask_git(const Asker& asker, const std::string& name, std::function<text::Result<Finding>()> ask,
               std::function<void(const Finding& found, Answer& out)> done);
  /// Where the document's file is, for git; nothing where it has none, which the answer says then.
  std::optional<std::string> file_for_git(const OpenConfiguration& document, Answer& out) const;
  std::shared_ptr<const Model> model_beside(const OpenConfiguration& document, std::string text);

  Desk& desk_;
  Clients& clients_;
  Answers& answers_;
  const std::shared_ptr<console::Inbox> inbox_;
  std::map<Key, Comparison> shown_;  // by client and document
  std::uint64_t number_ = 0;
  std::map<std::string, std::uint32_t> asked_of_git_;  // by the job's name: the request that waits for it
  LatestJobs git_jobs_;                                // posts to the inbox
};

}  // namespace mlab::designer
