#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "mlab/history/history.h"
#include "mlab/history/remaker.h"
#include "mlab/history/understood.h"
#include "mlab/run/mission_run.h"
#include "mlab/text/diagnostic.h"

namespace mlab::history {

/// Where a run that is computed again is not what was written.
struct Divergence {
  std::uint64_t cycle = 0;  ///< by then; up to the last mark before, it was the same
  std::string why;          ///< as a sentence
  bool stands = false;      ///< no more time passes: it is over, or waits for people
};

/// The run that a history tells of, computed again, one cycle at a time.
class Replay {
 public:
  /// @param history  may be of a run that goes on: entries that are added later are replayed, too
  /// @return null where it can't be made again, which is said in `sink`
  static std::unique_ptr<Replay> make(std::shared_ptr<const History> history, ReplayTools tools,
                                      text::Diagnostics& sink);

  /// The same once more, at its beginning: of the same history and programs, with robots and bodies of its
  /// own.
  std::unique_ptr<Replay> again() const;

  /// Of another history, at its beginning, and of the same programs.
  /// @param history  the first `inputs` of its History::inputs are those of this one
  std::unique_ptr<Replay> branch(std::shared_ptr<const History> history, std::size_t inputs) const;

  /// Up to the next cycle, and what came in before it. False where there is none any more: at the history's
  /// end, or where they part.
  bool step();
  /// What came in after this cycle comes in, and the executive looks, as before the next one: how the run
  /// stands then. No time passes.
  void settle();
  /// What came in after the last cycle is there, too: how the run stood when it ended.
  bool is_at_end() const { return is_at_end_; }
  const std::optional<Divergence>& divergence() const { return divergence_; }
  /// Reads what came in after cycles up to this one before it is computed so far.
  /// @return  why it can't be understood, as a sentence; nothing: all can
  std::optional<std::string> why_not_understood(std::uint64_t cycle) const;
  /// Marks that were compared, and were equal.
  std::size_t equal_marks() const { return equal_marks_; }

  /// Where a run stands, and how much had come into it.
  struct Checkpoint {
    run::Checkpoint run;
    std::size_t inputs = 0;  ///< of History::inputs, those that it has taken
  };
  /// @errors  as run::MissionRun::save
  std::expected<Checkpoint, std::string> save() const;
  /// Goes on from there, back or ahead.
  /// @param checkpoint  of this run, or of one of `again`
  /// @errors  as run::MissionRun::restore
  std::optional<std::string> restore(const Checkpoint& checkpoint);

  const History& history() const { return *understood_->history(); }
  /// Hands the run over, which outlives this: somebody goes on with it. Until then `step` still steps it.
  std::unique_ptr<run::MissionRun> give_run() { return std::move(owned_); }
  run::MissionRun& run() { return *run_; }
  const run::MissionRun& run() const { return *run_; }

 private:
  explicit Replay(std::shared_ptr<Understood> understood) : understood_(std::move(understood)) {}
  bool take_inputs();
  bool look_at_answers();
  bool finish();
  void compare();
  bool part(std::string why);
  void own(std::unique_ptr<run::MissionRun> run);

  std::shared_ptr<Understood> understood_;
  std::unique_ptr<run::MissionRun> owned_;  // null: somebody else has it
  run::MissionRun* run_ = nullptr;
  std::size_t next_input_ = 0;
  std::size_t next_answers_ = 0;  // of History::answers, that was not looked at yet
  std::size_t next_mark_ = 0;
  std::size_t equal_marks_ = 0;
  bool is_at_end_ = false;
  std::optional<Divergence> divergence_;
};

}  // namespace mlab::history
