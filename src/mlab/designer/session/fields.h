#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "mlab/cell/permission.h"
#include "mlab/console/inbox.h"
#include "mlab/designer/session/answers.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/request.h"
#include "mlab/designer/session/trials.h"
#include "mlab/designer/trial/movement_field.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::designer {

/// What a part of a page would make a robot do elsewhere: in the run that is tried, or in one of its own that
/// nobody sees.
class Fields {
 public:
  using LookAtRun = std::function<void(console::RunLook look)>;

  /// @param programs     how programs are made, and whether they may run; `ends` stops what takes long
  /// @param look_at_run  as DesignerSettings
  Fields(Desk& desk, Trials& trials, Answers& answers, std::shared_ptr<console::Inbox> inbox,
         robot::ProgramSources programs, LookAtRun look_at_run)
      : desk_(desk),
        trials_(trials),
        answers_(answers),
        inbox_(std::move(inbox)),
        programs_(std::move(programs)),
        look_at_run_(std::move(look_at_run)) {}

  Answered read(const Sender& sender, const ReadField& request, Answer& out);

 private:
  /// A part of a page, and where it is asked.
  struct Question {
    Trials::Planned node;
    FieldProgram part;
    FieldGrid grid;
  };

  text::Result<Question> question_of(const OpenConfiguration& document, const ReadField& request);
  /// Of the node of the page, or of its result.
  text::Result<Trials::Planned> node_of(const OpenConfiguration& document, const ReadField& request);
  text::Result<FieldProgram> program_of(const Trials::Planned& node) const;
  /// A run of its own: the robots stand where a trial would start them.
  text::Result<std::string> read_alone(const OpenConfiguration& document, const Question& question);
  void answer_alone(const OpenConfiguration& document, const Question& question, Answer& out);
  /// What was read in the run that is tried.
  struct Arrows {
    std::string bytes;
    bool is_as_is = false;  ///< of the robot's state
  };
  /// @param arrows  nothing: there is no run that could give them
  void answer(const Asker& asker, const ReadField& request, const Question& question,
              const std::optional<Arrows>& arrows);
  robot::ProgramSources programs_in(const std::string& folder) const;

  Desk& desk_;
  Trials& trials_;
  Answers& answers_;
  const std::shared_ptr<console::Inbox> inbox_;
  const robot::ProgramSources programs_;
  const LookAtRun look_at_run_;
};

}  // namespace mlab::designer
