#include "mlab/robot/remote/runner_server.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/library/library.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/robot_values.h"
#include "mlab/robot/remote/agent.h"
#include "mlab/robot/remote/states.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/shared_cycle.h"
#include "mlab/text/shown.h"

namespace mlab::robot_remote {
namespace {

constexpr std::size_t kMostPrograms = 1000;
constexpr std::size_t kMostRobots = 10'000;
constexpr double kShortestPeriod = 0.001;  // [s]
constexpr double kLongestPeriod = 10.0;    // [s]

/// The texts that a run has brought, as the only files that there are.
class BroughtTexts {
 public:
  explicit BroughtTexts(const wire::Bring& message) {
    for (const wire::ProgramText& one : message.texts())
      texts_[one.path()] = std::make_shared<const text::Source>(one.path(), one.text());
    files_.is_file = [this](const std::string& path) { return texts_.contains(path); };
    files_.read = [this](const std::string& path) -> text::Result<text::SourcePtr> {
      const auto at = texts_.find(path);
      if (at != texts_.end()) return at->second;
      text::Diagnostic missing;
      missing.kind = "cannot-read";
      missing.message = fmt::format("the run has not brought `{}`", text::shown(path, 200));
      return std::unexpected(missing);
    };
  }
  BroughtTexts(const BroughtTexts&) = delete;
  BroughtTexts& operator=(const BroughtTexts&) = delete;
  ~BroughtTexts() = default;
  const text::Files& files() const { return files_; }

 private:
  std::map<std::string, text::SourcePtr> texts_;
  text::Files files_;
};

// Only what is built from text: nothing that lies on this machine is ever started because of a name.
bool is_built_from_text(const std::string& name) {
  const std::string last = std::filesystem::path(name).filename().string();
  return !library::find_robot(last).empty() || last.ends_with(".cnl") || robot::names_configuration(last);
}

}  // namespace

google::protobuf::ArenaOptions RunnerServer::memory() {
  google::protobuf::ArenaOptions out;
  out.initial_block = block_.data();
  out.initial_block_size = block_.size();
  return out;
}

RunnerServer::RunnerServer(AgentTerms terms) : terms_(std::move(terms)) {
  // What arrives may be anything: no frame that came from elsewhere is stepped in this process.
  terms_.sources.in_own_processes = true;
  terms_.sources.came_from_elsewhere = true;
}

std::string_view RunnerServer::answer(std::string_view message, const robot::Meanwhile& meanwhile) {
  arena_.Reset();
  message_ = google::protobuf::Arena::CreateMessage<wire::ToAgent>(&arena_);
  answer_ = google::protobuf::Arena::CreateMessage<wire::FromAgent>(&arena_);
  if (!message_->ParseFromArray(message.data(), static_cast<int>(message.size()))) {
    message_->Clear();
    refuse("this is no message of the agents' protocol");
  } else {
    answer_->set_number(message_->number());
    answer_body(*message_, meanwhile);
  }
  bytes_.clear();
  answer_->AppendToString(&bytes_);
  return bytes_;
}

void RunnerServer::refuse(std::string why) {
  answer_->mutable_refusal()->set_text(std::move(why));
}

void RunnerServer::answer_body(const wire::ToAgent& message, const robot::Meanwhile& meanwhile) {
  if (!runners_ && !message.has_open() && !message.has_read_log()) {
    refuse("no run has opened this conversation");
    answer_->mutable_refusal()->set_is_unknown(true);
    return;
  }
  switch (message.body_case()) {
    case wire::ToAgent::kOpen:
      open(message.open());
      break;
    case wire::ToAgent::kBring:
      bring(message.bring());
      break;
    case wire::ToAgent::kEnlist:
      enlist(message.enlist());
      break;
    case wire::ToAgent::kDismiss:
      dismiss(message.dismiss());
      break;
    case wire::ToAgent::kPut:
      put(message.put());
      break;
    case wire::ToAgent::kChange:
      change(message.change());
      break;
    case wire::ToAgent::kLook:
      look(message.look());
      break;
    case wire::ToAgent::kCycle:
      act(message.cycle(), meanwhile);
      break;
    case wire::ToAgent::kLeave:
      has_left_ = true;
      answer_->mutable_done();
      break;
    case wire::ToAgent::kReadLog:
      read_log(message.read_log());
      break;
    case wire::ToAgent::BODY_NOT_SET:
      refuse("a message of a kind that this agent does not know");
      break;
  }
}

void RunnerServer::open(const wire::Open& message) {
  if (runners_) {
    refuse("this conversation was opened already");
    return;
  }
  wire::Opened& opened = *answer_->mutable_opened();
  opened.set_protocol(kAgentProtocol);
  opened.set_version(terms_.sources.version);
  opened.set_layout(robot_wire::shared_layout());
  // A run of another version is told so by this, and says no more.
  const bool is_same = message.protocol() == kAgentProtocol && message.version() == terms_.sources.version &&
                       message.layout() == robot_wire::shared_layout();
  if (!is_same) return;
  if (message.period() != 0.0 &&
      !(message.period() >= kShortestPeriod && message.period() <= kLongestPeriod)) {
    refuse("a cycle of that length can't be kept in real time");
    return;
  }
  if (terms_.is_a_vehicles) {
    refuse("this is a vehicle, which carries no programs");
    return;
  }
  period_ = message.period();
  runners_ = std::make_unique<robot::ProgramRunners>(message.seed(), 1);
}

void RunnerServer::bring(const wire::Bring& message) {
  if (programs_.contains(message.program()) || programs_.size() >= kMostPrograms) {
    refuse("there is a program of that number, or there are too many");
    return;
  }
  auto program = build(message);
  if (!program) return;
  if (!program->hosted) {
    refuse("this agent may start no processes for robots");
    return;
  }
  if (program->program->layout_hash() != message.frame_layout()) {
    refuse(fmt::format("`{}` becomes another program here", text::shown(message.name(), 200)));
    return;
  }
  programs_[message.program()] = std::make_unique<const robot::RobotProgram>(std::move(*program));
  answer_->mutable_brought();
}

// Nothing: it was refused.
std::optional<robot::RobotProgram> RunnerServer::build(const wire::Bring& message) {
  if ((message.executable() != 0) != !terms_.offered.empty()) {
    refuse(terms_.offered.empty() ? "no executable is offered here"
                                  : "robots of one executable are carried here, and no others");
    return std::nullopt;
  }
  if (!terms_.offered.empty()) {
    auto program = robot::load_offered(terms_.offered, terms_.sources);
    if (program && program->executable->source == message.executable()) return std::move(*program);
    refuse(program ? "its executable is another version of that program"
                   : fmt::format("its executable {}", program.error()));
    return std::nullopt;
  }
  if (!is_built_from_text(message.name())) {
    refuse(fmt::format("`{}` is no program that can be brought", text::shown(message.name(), 200)));
    return std::nullopt;
  }
  const BroughtTexts texts(message);
  robot::ProgramSources sources = terms_.sources;
  sources.folder = message.folder();
  sources.files = &texts.files();
  text::Diagnostics sink;
  auto program = robot::load_program(message.name(), {}, {}, sources, {}, sink, nullptr, message.type());
  if (program && program->program) return program;
  refuse(fmt::format("`{}` can't be built: {}", text::shown(message.name(), 200), text::render(sink)));
  return std::nullopt;
}

RunnerServer::Robot* RunnerServer::known(std::uint32_t number) {
  const auto at = robots_.find(number);
  if (at != robots_.end()) return &at->second;
  refuse("there is no such robot here");
  return nullptr;
}

void RunnerServer::enlist(const wire::Enlist& message) {
  const auto program = programs_.find(message.program());
  robot::ProgramRunner* const runner =
      program == programs_.end() ? nullptr : runners_->runner_of(*program->second);
  if (runner == nullptr || robots_.contains(message.member()) || robots_.size() >= kMostRobots) {
    refuse("there is a robot of that number, or no such program, or there are too many robots");
    return;
  }
  const base::RobotId id{message.robot()};
  Robot& robot = robots_[message.member()];
  robot.runner = runner;
  robot.member = runner->add(id, *program->second);
  robot.program = program->second.get();
  answer_->mutable_done();
}

void RunnerServer::dismiss(const wire::Dismiss& message) {
  Robot* const robot = known(message.member());
  if (robot == nullptr) return;
  robot->runner->remove(robot->member);
  robots_.erase(message.member());
  answer_->mutable_done();
}

void RunnerServer::put_needs(const Robot& robot, wire::Needs& out) const {
  percept::Needs needs;
  robot.runner->needs({&robot.member, 1}, {&needs, 1});
  robot_wire::encode(needs, out);
}

void RunnerServer::put_state(const Robot& robot, wire::RobotState& out) {
  const robot::Workings workings = robot.runner->workings(robot.member);
  encode(workings.frame, workings.program->frame_size(), workings.interventions, out);
}

void RunnerServer::put(const wire::Put& message) {
  Robot* const robot = known(message.member());
  if (robot == nullptr) return;
  const auto state = decode(message.state(), *robot->program->program);
  if (!state) {
    refuse(state.error());
    return;
  }
  wire::Done& done = *answer_->mutable_done();
  if (message.begins()) {
    if (auto problem = robot->runner->start(robot->member)) {
      done.set_problem(std::move(*problem));
      return;
    }
    robot->has_begun = true;
  }
  robot->runner->values(robot->member)
      ->adopt({state->frame.data(), state->frame.size()}, state->interventions.get());
  put_needs(*robot, *done.mutable_needs());
}

void RunnerServer::change(const wire::Change& message) {
  Robot* const robot = known(message.member());
  if (robot == nullptr) return;
  robot::ProgramRunner& runner = *robot->runner;
  std::optional<std::string> problem;
  switch (message.kind()) {
    case wire::Change::SET:
      problem = runner.set(robot->member, message.path(), message.value());
      break;
    case wire::Change::FORCE:
      problem = runner.force(robot->member, message.path(), message.value());
      break;
    case wire::Change::HOLD:
      problem = runner.hold(robot->member, message.path(), message.value());
      break;
    case wire::Change::RELEASE:
      problem = runner.release(robot->member, message.path());
      break;
    default:
      refuse("a change of a kind that this agent does not know");
      return;
  }
  wire::Done& done = *answer_->mutable_done();
  if (problem) done.set_problem(std::move(*problem));
  put_needs(*robot, *done.mutable_needs());
}

void RunnerServer::look(const wire::Look& message) {
  const Robot* const robot = known(message.member());
  if (robot != nullptr) put_state(*robot, *answer_->mutable_seen()->mutable_state());
}

void RunnerServer::read_log(const wire::ReadLog& message) {
  Robot* const robot = message.member() == Agent::kNoMember ? nullptr : known(message.member());
  if (answer_->has_refusal()) return;
  wire::AgentLog& log = *answer_->mutable_log();
  if (terms_.log) {
    for (const robot::LogLine& line : terms_.log()) {
      wire::AgentLogLine& out = *log.add_lines();
      out.set_age(line.age);
      out.set_text(line.text);
    }
  }
  if (robot == nullptr) return;
  if (const auto said = robot->runner->said(robot->member)) log.set_program(said->program);
}

RunnerServer::Part& RunnerServer::part(std::size_t place) {
  if (parts_.size() == place) parts_.push_back(std::make_unique<Part>());
  Part& part = *parts_[place];
  part.fault.clear();
  part.failure.clear();
  return part;
}

// All of it, before any robot acts.
std::optional<std::string> RunnerServer::read(const wire::AgentCycle& cycle) {
  std::set<std::uint32_t> numbers;
  for (int i = 0; i < cycle.robots_size(); ++i) {
    const wire::AgentTurn& turn = cycle.robots(i);
    const auto at = robots_.find(turn.member());
    if (at == robots_.end() || !at->second.has_begun)
      return fmt::format("robot {} of the cycle has not begun here", turn.member());
    if (!numbers.insert(turn.member()).second)
      return fmt::format("robot {} stands in one cycle twice", turn.member());
    Part& read = part(static_cast<std::size_t>(i));
    read.robot = &at->second;
    read.number = turn.member();
    read.wants_state = turn.wants_state();
    if (const auto problem = read.decoded.decode(turn.percepts()))
      return fmt::format("the percepts of robot {}: {}", turn.member(), *problem);
    read.percepts = read.decoded.percepts();
  }
  return std::nullopt;
}

std::span<const std::unique_ptr<RunnerServer::Part>> RunnerServer::run_parts(
    std::size_t count, const robot::Meanwhile& meanwhile) {
  const std::span parts(parts_.data(), count);
  const auto let_stand = [&] {
    for (const auto& part : parts) part->action = percept::Action{};
    return parts;
  };
  if (is_stopped()) return let_stand();
  for (const auto& part : parts) part->robot->runner->join(part->robot->member);
  for (const auto& runner : *runners_) runner->open();
  for (const auto& part : parts) {
    const robot::ProgramRunner::Turn turn{part->robot->member, &part->percepts, &part->action, &part->fault,
                                          &part->failure};
    part->robot->runner->act({&turn, 1});
  }
  for (const auto& runner : *runners_) runner->ask();
  for (const auto& runner : *runners_) runner->wait(meanwhile);
  return is_stopped() ? let_stand() : parts;
}

void RunnerServer::put_action(const Part& part, wire::AgentAction& out) const {
  out.set_member(part.number);
  out.set_failure(part.failure);
  if (!part.failure.empty()) return;
  robot_wire::encode(part.action, *out.mutable_action());
  out.set_fault(part.fault);
  put_needs(*part.robot, *out.mutable_needs());
  if (part.wants_state) put_state(*part.robot, *out.mutable_state());
}

void RunnerServer::act(const wire::AgentCycle& cycle, const robot::Meanwhile& meanwhile) {
  if (auto problem = read(cycle)) {
    refuse(std::move(*problem));
    return;
  }
  wire::AgentActed& acted = *answer_->mutable_acted();
  for (const auto& part : run_parts(static_cast<std::size_t>(cycle.robots_size()), meanwhile))
    put_action(*part, *acted.add_robots());
}

// -------------------------------------------------------------------------------------------------- real
// time

void RunnerServer::hear(const LiveLine::Message& message) {
  if (message.key == kBeatKey) {
    wire::LiveBeat beat;
    if (beat.ParseFromString(message.body)) rests_ = beat.rests();
    return;
  }
  std::uint32_t number = 0;
  const char* const end = message.key.data() + message.key.size();
  const auto [rest, error] = std::from_chars(message.key.data(), end, number);
  const auto at = error != std::errc{} || rest != end ? robots_.end() : robots_.find(number);
  if (at == robots_.end() || !at->second.has_begun) return;
  wire::LivePercepts percepts;
  if (!percepts.ParseFromString(message.body) || !at->second.live.hear(percepts, message.arrived)) return;
  rests_ = false;
  if (!first_fresh_) first_fresh_ = message.arrived;
}

// Robots of one cycle act together, which costs less: whose percepts come at nearly the same time. Who hears
// nothing for a cycle and a half acts on what it knows.
Clock::time_point RunnerServer::due() const {
  constexpr Clock::duration kTogether = std::chrono::milliseconds(2);
  const Clock::time_point now = Clock::now();
  Clock::time_point out = now + from_seconds(period_);
  if (rests_) return out;
  bool are_all_fresh = true;
  for (const auto& [number, robot] : robots_) {
    if (!robot.has_begun || !robot.live.has_percepts()) continue;
    if (robot.live.is_fresh()) continue;
    are_all_fresh = false;
    // Nothing but newer ones would make it act.
    if (robot.live.age(now) > kActionPatience) continue;
    out = std::min(out, robot.live.acted_at() + from_seconds(1.5 * period_));
  }
  if (first_fresh_) out = std::min(out, are_all_fresh ? *first_fresh_ : *first_fresh_ + kTogether);
  return out;
}

void RunnerServer::act_live(Clock::time_point now, const Publish& publish,
                            const robot::Meanwhile& meanwhile) {
  std::size_t count = 0;
  for (auto& [number, robot] : robots_) {
    if (!robot.has_begun || !robot.live.has_percepts()) continue;
    if (!robot.live.is_fresh() && now < robot.live.acted_at() + from_seconds(1.5 * period_)) continue;
    if (robot.live.age(now) > kActionPatience) {
      // There is nothing to act on any more. Who has sent it hears so, and how long it was on its way.
      if (robot.live.is_fresh()) let_stand(number, robot, now, publish);
      continue;
    }
    Part& acts = part(count++);
    acts.robot = &robot;
    acts.number = number;
    acts.percepts = robot.live.percepts(now);
    acts.wants_state = robot.live.wants_state();
  }
  first_fresh_.reset();
  if (count == 0) return;
  for (const auto& part : run_parts(count, meanwhile)) publish_live(*part, now, publish);
}

void RunnerServer::publish_live(const Part& part, Clock::time_point now, const Publish& publish) {
  live_.Clear();
  part.robot->live.answer(now, live_);
  put_action(part, *live_.mutable_action());
  live_.set_replied(nanoseconds_of(Clock::now()));
  bytes_.clear();
  live_.AppendToString(&bytes_);
  publish(std::to_string(part.number), bytes_);
  part.robot->live.keep_requests(live_);
}

void RunnerServer::let_stand(std::uint32_t number, Robot& robot, Clock::time_point now,
                             const Publish& publish) {
  Part stands;
  stands.robot = &robot;
  stands.number = number;
  publish_live(stands, now, publish);
}

void RunnerServer::stand(Clock::time_point now, const Publish& publish) {
  for (auto& [number, robot] : robots_) {
    if (robot.has_begun) let_stand(number, robot, now, publish);
  }
}

}  // namespace mlab::robot_remote
