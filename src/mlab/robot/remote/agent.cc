#include "mlab/robot/remote/agent.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/robot/remote/live_line.h"
#include "mlab/robot/wire/shared_cycle.h"
#include "mlab/text/shown.h"

namespace mlab::robot_remote {
namespace {

// Whoever wants something of a run waits so long for a machine that may only be cut off for a moment [s].
constexpr double kLeastPatience = 5.0;
constexpr std::chrono::milliseconds kGlance(20);  // between two looks whether anybody still waits
// What was asked of a machine that is cut off meanwhile is waited for so long [s]: the world goes on.
constexpr double kCutPatience = 0.3;

Clock::time_point from_now(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

Agent::Agent(std::string name, std::unique_ptr<Link> link, Patience patience,
             std::optional<robot::ExecutableOrigin> offered)
    : name_(std::move(name)), link_(std::move(link)), patience_(patience), offered_(std::move(offered)) {}

bool Agent::may_carry(const robot::RobotProgram& program) const {
  if (!program.host.empty() && program.host != name_) return false;
  const auto source = [](const auto& executable) { return executable ? executable->source : 0; };
  return source(offered_) == source(program.executable);
}

Agent::~Agent() {
  constexpr double kPatience = 1.0;  // an agent that does not hear it gives the run up by itself [s]
  if (!live_ || !link_->failure().empty()) return;
  wire::ToAgent message;
  message.mutable_leave();
  [[maybe_unused]] const auto answer = ask(message, wire::FromAgent::kDone, kPatience);
}

std::string Agent::failure() const {
  link_->look();
  if (link_->failure().empty()) return "";
  return fmt::format("the agent on `{}` {}", name_, link_->failure());
}

void Agent::send(wire::ToAgent& message) {
  message.set_number(++number_);
  bytes_.clear();
  message.AppendToString(&bytes_);
  link_->send(bytes_);
}

const wire::FromAgent* Agent::receive(wire::FromAgent::BodyCase wanted, double patience,
                                      const robot::Meanwhile& meanwhile) {
  const Clock::time_point last = from_now(patience);
  const Clock::time_point first = from_now(kLeastPatience);
  std::optional<Clock::time_point> cut;
  while (link_->failure().empty()) {
    if (!link_->is_cut())
      cut.reset();
    else if (!cut)
      cut = from_now(kCutPatience);
    else if (Clock::now() >= *cut)
      return nullptr;
    if (const auto bytes = link_->receive(std::min(last, Clock::now() + kGlance))) {
      if (!answer_.ParseFromArray(bytes->data(), static_cast<int>(bytes->size())))
        link_->fail("answers what is no message of the agents' protocol");
      else if (answer_.number() == log_question_.number && answer_.number() < number_)
        log_ = answer_;
      else if (answer_.number() < number_ && (live_ || answer_.number() <= newest_log_))
        continue;  // to what was given up while it was cut off, or to who read what was said
      else if (answer_.number() != number_ || (answer_.body_case() != wanted && !answer_.has_refusal()))
        link_->fail("answers something else than it was asked");
      else if (answer_.refusal().is_unknown())
        link_->fail("has given this run up: it heard nothing of it for a while");
      else
        return &answer_;
    } else if (Clock::now() >= last) {
      link_->fail(fmt::format("gave no answer for {} s", patience));
    } else if (meanwhile && meanwhile() && Clock::now() >= first) {
      link_->fail("was given up, because nobody waits for it any more");
    }
  }
  return nullptr;
}

std::expected<const wire::FromAgent*, std::string> Agent::ask(wire::ToAgent& message,
                                                              wire::FromAgent::BodyCase wanted,
                                                              double patience) {
  const auto cut_off = [this] { return fmt::format("the agent on `{}` is cut off at present", name_); };
  if (link_->is_cut()) return std::unexpected(cut_off());
  send(message);
  const wire::FromAgent* const answer = receive(wanted, patience, {});
  if (answer == nullptr) return std::unexpected(link_->failure().empty() ? cut_off() : failure());
  if (answer->has_refusal())
    return std::unexpected(
        fmt::format("the agent on `{}` refuses: {}", name_, text::shown(answer->refusal().text(), 2000)));
  return answer;
}

std::expected<const wire::FromAgent*, std::string> Agent::ask(wire::ToAgent& message,
                                                              wire::FromAgent::BodyCase wanted) {
  return ask(message, wanted, patience_.answer);
}

std::optional<std::string> Agent::open(std::uint64_t seed, const std::string& version, double period) {
  wire::ToAgent message;
  wire::Open& open = *message.mutable_open();
  open.set_protocol(kAgentProtocol);
  open.set_version(version);
  open.set_layout(robot_wire::shared_layout());
  open.set_seed(seed);
  open.set_period(period);
  const auto answer = ask(message, wire::FromAgent::kOpened);
  if (!answer) return answer.error();
  const wire::Opened& opened = (*answer)->opened();
  if (opened.protocol() == kAgentProtocol && opened.version() == version &&
      opened.layout() == robot_wire::shared_layout()) {
    if (period > 0.0) live_ = link_->live();
    if (period == 0.0 || (live_ && live_->meet(from_now(kLeastPatience)))) return std::nullopt;
    link_->fail("can't be talked to in real time");
    return failure();
  }
  link_->fail(fmt::format("is missionlab {} (protocol {}), and this is {} (protocol {}): install the same",
                          text::shown(opened.version()), opened.protocol(), version, kAgentProtocol));
  return failure();
}

std::expected<std::uint32_t, std::string> Agent::bring(const robot::RobotProgram& program) {
  if (const auto known = brought_.find(program.program); known != brought_.end()) return known->second;
  wire::ToAgent message;
  wire::Bring& bring = *message.mutable_bring();
  const auto number = static_cast<std::uint32_t>(brought_.size() + 1);
  bring.set_program(number);
  bring.set_name(program.name);
  bring.set_type(program.type);
  if (program.executable) {
    bring.set_executable(program.executable->source);
  } else {
    bring.set_folder(program.origin->folder);
    for (const text::SourcePtr& source : program.origin->texts) {
      wire::ProgramText& text = *bring.add_texts();
      text.set_path(source->name());
      text.set_text(std::string(source->text()));
    }
  }
  bring.set_frame_layout(program.program->layout_hash());
  const auto answer = ask(message, wire::FromAgent::kBrought, patience_.program);
  std::expected<std::uint32_t, std::string> out = number;
  if (!answer && link_->is_cut()) return std::unexpected(answer.error());  // another time
  if (!answer) out = std::unexpected(answer.error());
  return brought_.emplace(program.program, std::move(out)).first->second;
}

// The agent's failure is not this: whoever needs it for more than words notices by himself.
std::expected<const wire::FromAgent*, std::string> Agent::wait_for_log(double patience) {
  const Clock::time_point last = from_now(patience);
  while (!log_) {
    if (std::string why = failure(); !why.empty()) return std::unexpected(std::move(why));
    const auto bytes = link_->receive(std::min(last, Clock::now() + kGlance));
    if (bytes && !answer_.ParseFromArray(bytes->data(), static_cast<int>(bytes->size())))
      link_->fail("answers what is no message of the agents' protocol");
    else if (bytes && answer_.number() > number_)
      link_->fail("answers something else than it was asked");
    else if (bytes && answer_.number() == log_question_.number)
      log_ = answer_;
    else if (!bytes && Clock::now() >= last)
      return std::unexpected(
          fmt::format("the agent on `{}` has not answered yet: ask again in a moment", name_));
  }
  log_question_ = {};
  answer_ = *std::exchange(log_, std::nullopt);
  if (answer_.has_log()) return &answer_;
  return std::unexpected(
      fmt::format("the agent on `{}` refuses: {}", name_, text::shown(answer_.refusal().text(), 2000)));
}

std::expected<robot::Said, std::string> Agent::said(std::uint32_t member, double patience) {
  constexpr std::size_t kLine = 400;        // characters
  constexpr std::size_t kProgram = 10'000;  // of what a program wrote
  if (log_question_.number == 0 || log_question_.member != member) {
    if (link_->is_cut())
      return std::unexpected(fmt::format("the agent on `{}` is cut off at present", name_));
    wire::ToAgent message;
    message.mutable_read_log()->set_member(member);
    send(message);
    log_.reset();
    log_question_ = {number_, member};
    newest_log_ = number_;
  }
  const auto answer = wait_for_log(patience);
  if (!answer) return std::unexpected(answer.error());
  const wire::AgentLog& log = (*answer)->log();
  robot::Said out;
  for (const wire::AgentLogLine& line : log.lines())
    out.machine.push_back(
        {std::isfinite(line.age()) ? std::max(line.age(), 0.0) : 0.0, text::shown(line.text(), kLine)});
  out.program = log.program().substr(0, kProgram);
  return out;
}

void Agent::send_cycle(wire::ToAgent& message) {
  send(message);
}

const wire::AgentActed* Agent::receive_cycle(const robot::Meanwhile& meanwhile) {
  const wire::FromAgent* const answer = receive(wire::FromAgent::kActed, patience_.cycle, meanwhile);
  if (answer == nullptr) return nullptr;
  if (answer->has_acted()) return &answer->acted();
  link_->fail(fmt::format("refuses a cycle: {}", text::shown(answer->refusal().text(), 200)));
  return nullptr;
}

}  // namespace mlab::robot_remote
