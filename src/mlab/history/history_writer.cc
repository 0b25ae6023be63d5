#include "mlab/history/history_writer.h"

#include <algorithm>
#include <set>
#include <variant>

#include "mlab/base/hash.h"
#include "mlab/history/digest.h"
#include "mlab/history/history.h"
#include "mlab/history/wire.h"
#include "mlab/mission/wording.h"
#include "mlab/robot/wire/arithmetic.h"

namespace mlab::history {
namespace {

constexpr double kPosesApart = 1.0;         // simulated [s]
constexpr std::uint64_t kMarksApart = 100;  // cycles

}  // namespace

wire::HistoryEntry HistoryWriter::entry() const {
  wire::HistoryEntry out;
  out.set_cycle(run_->cycle());
  out.set_time(run_->time());
  return out;
}

// What robots answered before comes before it.
void HistoryWriter::put(const wire::HistoryEntry& entry) {
  note_rest();
  sink_(entry);
}

void HistoryWriter::note_rest() {
  if (!answers_) return;
  if (const auto answers = answers_->take()) sink_(*answers);
}

std::uint32_t HistoryWriter::id_of(const text::SourcePtr& source) {
  auto& known = texts_[{source->name(), base::hash_text(source->text())}];
  for (const auto& [text, id] : known) {
    if (text == source || text->text() == source->text()) return id;
  }
  known.emplace_back(source, ++last_text_);
  wire::HistoryEntry said = entry();
  wire::HistoryText& text = *said.mutable_text();
  text.set_id(last_text_);
  text.set_path(source->name());
  text.set_content(std::string(source->text()));
  put(said);
  return last_text_;
}

void HistoryWriter::put_mission(const run::Crew& crew, wire::HistoryMission& out) {
  const mission::Mission& mission = *crew.mission;
  out.set_path(mission.source ? mission.source->name() : "");
  out.set_folder(mission.folder);
  out.set_program_folder(mission.folder);
  std::set<std::uint32_t> texts;
  for (const text::SourcePtr& source : run::texts_of(crew)) texts.insert(id_of(source));
  for (const robot::RobotProgram& program : crew.programs) {
    if (program.is_in_executable()) {
      out.add_executables(program.name);
      *out.add_programs() = answers_->describe(program);
    }
    if (program.origin) out.set_program_folder(program.origin->folder);
  }
  for (const std::uint32_t id : texts) out.add_texts(id);
  for (const std::string& line : mission.typed) out.add_typed(line);
  for (const auto& [name, value] : mission.set) {
    wire::HistorySetting& setting = *out.add_set();
    setting.set_name(name);
    setting.set_value(value);
  }
}

void HistoryWriter::begin(run::MissionRun& run, const Circumstances& circumstances) {
  run_ = &run;
  answers_ = std::make_unique<AnswerWriter>(run);
  wire::HistoryEntry said = entry();
  wire::HistoryBeginning& beginning = *said.mutable_beginning();
  const run::RunSettings& settings = run.settings();
  beginning.set_format(History::kFormat);
  beginning.set_version(circumstances.version);
  beginning.set_arithmetic(robot_wire::arithmetic());
  beginning.set_seed(settings.seed);
  for (const std::string& folder : circumstances.overlay_folders) beginning.add_overlay_folders(folder);
  beginning.set_obstacle_seed(circumstances.obstacle_seed);
  if (settings.environment.source) beginning.set_environment(id_of(settings.environment.source));
  beginning.set_stands_still_for_operator(run.stands_still_for_operator());
  beginning.set_goes_on_when_done(settings.goes_on_when_done);
  beginning.set_is_in_real_time(settings.is_in_real_time || settings.recorded.is_of_all);
  beginning.set_holds_answers(true);
  *beginning.mutable_executive() = to_wire(settings.executive);
  beginning.set_started_at(circumstances.started_at);
  for (std::string& vehicle : run.vehicles()) beginning.add_vehicles(std::move(vehicle));
  put_mission(*run.crew(), *beginning.mutable_mission());
  put(said);
  answers_->take_up(*run.crew());
  run.set_answer_witness(answers_.get());
  run.set_input_observer(
      [this](const run::Moment& moment, const run::Input& input) { note_input(moment, input); });
}

void HistoryWriter::note_input(const run::Moment& moment, const run::Input& input) {
  wire::HistoryEntry said = entry();
  wire::HistoryInput& out = *said.mutable_input();
  out.set_has_looked(moment.has_looked);
  encode(input, out);
  if (const auto* exchanged = std::get_if<run::input::Exchanged>(&input)) {
    put_mission(*exchanged->crew, *out.mutable_exchanged()->mutable_mission());
    out.mutable_exchanged()->set_takes_over(exchanged->takes_over);
    note_rest();
    answers_->take_up(*exchanged->crew);
  }
  put(said);
}

void HistoryWriter::see(const mission::Effect& effect) {
  const auto* told = std::get_if<mission::effect::Tell>(&effect);
  const auto* asked = std::get_if<mission::effect::Ask>(&effect);
  if (run_ == nullptr || (told == nullptr && asked == nullptr)) return;
  wire::HistoryEntry said = entry();
  said.mutable_event()->set_text(told != nullptr ? told->text : asked->text);
  said.mutable_event()->set_is_warning(told != nullptr &&
                                       told->kind == mission::effect::Tell::Kind::kWarning);
  put(said);
}

void HistoryWriter::note_cycle() {
  if (run_ == nullptr) return;
  answers_->note_cycle();
  if (answers_->has_failures()) note_rest();  // who reads how far the run has come has to know of them
  if (run_->time() >= next_poses_) note_poses();
  if (run_->cycle() >= next_mark_) note_mark();
}

void HistoryWriter::note_poses() {
  next_poses_ = run_->time() + kPosesApart;
  wire::HistoryEntry said = entry();
  wire::HistoryPoses& poses = *said.mutable_poses();
  for (const fleet::FleetRobot& robot : run_->fleet().robots()) {
    if (robot.life == fleet::RobotLife::kNotStarted) continue;
    const geom::Pose& pose = run_->fleet().pose(robot);
    poses.add_robots(robot.id.value);
    poses.add_x(static_cast<float>(pose.position.x));
    poses.add_y(static_cast<float>(pose.position.y));
    poses.add_heading(static_cast<float>(pose.heading));
  }
  put(said);
}

void HistoryWriter::note_mark() {
  next_mark_ = run_->cycle() + kMarksApart;
  wire::HistoryEntry said = entry();
  said.mutable_mark()->set_digest(digest_of(*run_));
  put(said);
}

void HistoryWriter::end(const std::string& outcome) {
  if (run_ == nullptr) return;
  wire::HistoryEntry said = entry();
  said.mutable_end()->set_outcome(outcome);
  said.mutable_end()->set_digest(digest_of(*run_));
  said.mutable_end()->set_has_looked(run_->moment().has_looked);
  put(said);
  leave();
}

void HistoryWriter::leave() {
  if (run_ != nullptr) {
    note_rest();
    run_->set_input_observer({});
    run_->set_answer_witness(nullptr);
  }
  answers_.reset();
  run_ = nullptr;
}

}  // namespace mlab::history
