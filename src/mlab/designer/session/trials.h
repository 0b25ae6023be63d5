#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "mlab/console/inbox.h"
#include "mlab/console/trial.h"
#include "mlab/designer/session/answers.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/request.h"
#include "mlab/designer/trial/trial.h"

namespace mlab::designer {

/// That something does not run, or would not, as a problem.
text::Diagnostic not_live(std::string message);

/// What is drawn is seen running: the configuration goes to a session as a mission that nobody wrote.
class Trials {
 public:
  /// What was tried last.
  struct Last {
    std::string document;
    std::shared_ptr<const Model> model;  ///< of the completed text
    TrialConfiguration configuration;
    std::string file;     ///< as the mission names the text
    std::string mission;  ///< path of its text
    TrialWish wish;
  };
  using TryOut = std::function<void(console::Trial trial, console::TrialDone done)>;

  /// @param try_out         as DesignerSettings
  /// @param before_execute  what has to be on the disk before robots move
  Trials(Desk& desk, Answers& answers, std::shared_ptr<console::Inbox> inbox, TryOut try_out,
         std::function<void()> before_execute)
      : desk_(desk),
        answers_(answers),
        inbox_(std::move(inbox)),
        try_out_(std::move(try_out)),
        before_execute_(std::move(before_execute)) {}

  Answered try_out(const Sender& sender, const Try& request, Answer& out);
  void find_live(const FindLive& request, Answer& out);
  void write_back(const WriteBack& request, Answer& out);

  /// How many have been started.
  std::uint64_t number() const { return number_; }
  /// Null: that document was not tried last.
  const Last* last(const std::string& document) const;
  void rename(const std::string& from, const std::string& to);

  // ---- what would run, were a document tried as it stands

  /// One of the robots.
  struct Planned {
    TrialConfiguration completed;
    std::shared_ptr<const Model> model;  ///< of its text
    std::string robot;                   ///< declaration
    std::string place;                   ///< path in its program
  };
  /// The first place where the page would run. Where no robot uses it, as it would run by itself.
  /// @param robot  that has to run it; 0: any
  text::Result<Planned> plan(const OpenConfiguration& document, const std::string& page,
                             std::uint32_t robot = 0);
  /// What the document means at a place of the project: of one of the library a copy, which hides it.
  std::shared_ptr<const Model> model_to_try(const OpenConfiguration& document);
  /// @param overlay  path; empty: one that has no file
  /// @param file     what the mission is to call the configuration's text
  console::Trial trial_of(const OpenConfiguration& document, const TrialConfiguration& completed,
                          const std::string& overlay, std::string& file);
  /// @errors  an overlay that is not there, a start place that is no point of the map
  text::Result<TrialField> field_of(const Try& request, const console::Trial& trial);

 private:
  static void add_others(const FindLive& request, const OpenConfiguration& document, LivePaths& out);
  text::Result<TrialConfiguration> as_it_is_tried(const OpenConfiguration& document);
  struct Ready {
    console::Trial trial;
    Last tried;
  };
  /// Nothing where it can't be tried, which the answer says then.
  std::optional<Ready> prepare(const OpenConfiguration& document, const Try& request, Answer& out);
  void finish(const Asker& asker, const Last& trial, const console::TrialResult& result);
  /// @param out  problems are added
  void add_problems(const text::Diagnostics& problems, const TrialConfiguration& completed,
                    const OpenConfiguration& document, Answer& out) const;

  Desk& desk_;
  Answers& answers_;
  const std::shared_ptr<console::Inbox> inbox_;
  const TryOut try_out_;
  const std::function<void()> before_execute_;
  Last last_;
  std::uint64_t number_ = 0;
};

}  // namespace mlab::designer
