#include "mlab/console/run/run_notes.h"

#include <variant>

#include "mlab/console/run/told_effects.h"
#include "mlab/lang/mdl/options.h"

namespace mlab::console {

RunNotes::RunNotes(const run::MissionRun& run, EventLog& log)
    : run_(run), log_(&log), options_(run.mission().options) {
  const std::uint64_t before = log_->last();
  for (const mission::Print& wanted : run_.mission().prints) tell_print(run_, wanted.robot_info, *log_);
  told_ += log_->last() - before;
}

void RunNotes::change() {
  transitions_.change(run_);
  has_news_ = true;
}

void RunNotes::look(bool has_stepped) {
  estimates_.look(run_.state());
  if (has_stepped) note_cycle(*log_);
}

void RunNotes::look_again(bool is_known) {
  estimates_.look(run_.state());
  EventLog known;
  note_cycle(is_known ? known : *log_);
}

void RunNotes::note_cycle(EventLog& alarms) {
  alarms_.look(run_, alarms);
  trails_.look(run_);
  series_.look(run_);
  transitions_.look(run_);
}

void RunNotes::see(const mission::Effect& effect) {
  has_news_ = true;
  const std::uint64_t before = log_->last();
  add_seen(effect);
  told_ += log_->last() - before;
}

void RunNotes::add_seen(const mission::Effect& effect) {
  if (const auto* ask = std::get_if<mission::effect::Ask>(&effect)) {
    asked_[ask->question] = run_.time();
    texts_[ask->question] = ask->text;
  }
  if (const auto* set = std::get_if<mission::effect::Set>(&effect))
    std::visit([&](const auto& option) { mdl::apply_set(option, options_); }, set->option);
  tell_effect(run_, effect, *log_);
}

}  // namespace mlab::console
