#include "mlab/console/session/other_futures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/comparison/beginning.h"
#include "mlab/console/published/overview.h"
#include "mlab/history/branch.h"
#include "mlab/text/line_ends.h"
#include "mlab/text/one_line.h"
#include "mlab/text/utf8.h"

namespace mlab::console {
namespace {

constexpr double kFuturePiece = 0.03;  // who asks for a moment meanwhile waits for so long [s]
constexpr double kLeast = 60.0;        // of a future, where nobody says how long [s]
constexpr double kLongest = 7200.0;    // [s]
constexpr int kMostChanges = 64;
constexpr std::size_t kMostTextBytes = std::size_t{4} << 20;  // of all texts that can be changed [bytes]

std::string file_name_of(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

// As a person reads it.
std::string sentence_of(const WhatIf::Change& change) {
  if (change.has_order()) return fmt::format("the order `{}`", change.order());
  if (change.has_text()) return fmt::format("another text of {}", file_name_of(change.text().path()));
  const WhatIf::Parameter& set = change.parameter();
  std::string who = fmt::format("robot {}", set.robots_size() > 0 ? set.robots(0) : 0);
  if (set.robots_size() > 1) who = fmt::format("{} robots", set.robots_size());
  return fmt::format("{} = {} for {}", set.port(), set.value(), who);
}

// What can be said without computing.
Answered why_nonsense(const WhatIf& asked) {
  if (!std::isfinite(asked.seconds()) || asked.seconds() < 0.0 || asked.seconds() > kLongest)
    return fmt::format("it is to go on for {} s: expected 0 to {:.0f} s", asked.seconds(), kLongest);
  if (asked.changes_size() > kMostChanges)
    return fmt::format("{} changes are asked for: at most {}", asked.changes_size(), kMostChanges);
  std::set<std::string> paths;
  for (const WhatIf::Change& change : asked.changes()) {
    if (change.what_case() == WhatIf::Change::WHAT_NOT_SET) return "a change says nothing";
    if (change.has_text() && !paths.insert(change.text().path()).second)
      return fmt::format("two texts are given for `{}`", clean(change.text().path()));
    if (change.has_parameter() && change.parameter().robots().empty()) return "no robot is named";
    if (change.has_order() && change.order().find_first_not_of(" \t") == std::string::npos)
      return "the order is empty: expected a line of a mission, as UNIT scouts STOP";
  }
  return std::nullopt;
}

history::Departure departure_of(const WhatIf& asked, const run::MissionRun& run) {
  history::Departure out;
  out.cycle = run.cycle();
  out.time = run.time();
  out.with_later = !asked.without_people();
  for (const WhatIf::Change& change : asked.changes()) {
    if (change.has_order()) out.lines.push_back(change.order());
    if (change.has_text()) out.texts[change.text().path()] = change.text().text();
  }
  return out;
}

// That somebody may have named.
Answered why_no_such(const WhatIf::Parameter& set, const run::MissionRun& run) {
  for (const std::uint32_t id : set.robots()) {
    const fleet::FleetRobot* const robot = run.fleet().find({id});
    if (robot == nullptr) return fmt::format("there is no robot {}", id);
    const auto program = robot->workings().program;
    if (program == nullptr) continue;
    const flow::Port* const port = program->find(set.port());
    if (port == nullptr)
      return fmt::format("the program of robot {} has no parameter `{}`", id, clean(set.port()));
    // A point may be a place of the map by its name.
    if (port->type->kind == flow::TypeKind::kPoint) continue;
    alignas(flow::Frame::kAlignment) flow::Program::ValueBytes value{};
    if (auto error = flow::Program::read(*port, set.value(), value)) return error;
  }
  return std::nullopt;
}

std::string first_problem(const text::Diagnostics& problems) {
  std::string out = text::first_error(problems);
  return out.empty() ? "it can't be computed" : out;
}

std::expected<std::unique_ptr<OtherRun>, std::string> future_of(const WhatIf& asked, PastRun& past,
                                                                const history::ReplayTools& tools,
                                                                bool is_of_recording) {
  if (asked.cycle() > past.history().last_cycle())
    return std::unexpected(
        fmt::format("cycle {} has not come: the last one is {}", asked.cycle(), past.history().last_cycle()));
  if (std::string why = past.history().why_not_gone_on(); !why.empty())
    return std::unexpected(std::move(why));
  if (auto problem = past.show(asked.cycle())) return std::unexpected(std::move(*problem));
  const run::MissionRun& run = past.timeline().run();
  OtherRun::Settings settings;
  settings.name = "What if";
  settings.is_of_recording = is_of_recording;
  settings.from_cycle = run.cycle();
  settings.from = run.time();
  settings.until = asked.seconds() > 0.0 ? run.time() + asked.seconds()
                                         : std::min(std::max(past.history().last_time(), run.time() + kLeast),
                                                    run.time() + kLongest);
  settings.version = tools.version;
  for (const WhatIf::Change& change : asked.changes()) {
    settings.changes.push_back(sentence_of(change));
    if (!change.has_parameter()) continue;
    if (auto why = why_no_such(change.parameter(), run)) return std::unexpected(std::move(*why));
    settings.parameters.push_back(change.parameter());
  }
  auto branch = history::branch(past.history(), departure_of(asked, run), run.mission());
  if (!branch) return std::unexpected(std::move(branch.error()));
  settings.takes_over = branch->takes_over;
  text::Diagnostics problems;
  settings.known = past.known_alarms(run.cycle());
  auto out = OtherRun::depart(past.timeline(), std::move(branch->history), std::move(settings), problems);
  if (!out) return std::unexpected(first_problem(problems));
  return out;
}

void tell_parameters(const run::MissionRun& run, std::uint32_t id, Changeable& out) {
  const fleet::FleetRobot* const robot = run.fleet().find({id});
  if (robot == nullptr) {
    out.set_why_no_parameters(fmt::format("there is no robot {}", id));
    return;
  }
  const auto program = robot->workings().program;
  if (program == nullptr || robot->workings().frame == nullptr) {
    out.set_why_no_parameters(fmt::format("robot {} has not been started at that moment", id));
    return;
  }
  for (const flow::Port& port : program->ports()) {
    if (port.role == flow::Port::Role::kOutput) continue;
    Changeable::Parameter& told = *out.add_parameters();
    encode_port(*program, port, *told.mutable_port());
    told.set_value(clean(flow::Program::print(robot->workings().frame, port)));
  }
  if (out.parameters().empty()) out.set_why_no_parameters("its program has no parameters");
}

void tell_texts(const history::History& history, std::uint64_t cycle, Changeable& out) {
  std::size_t bytes = 0;
  for (const std::uint32_t id : history.version_at(cycle).texts()) {
    const text::SourcePtr text = history.text(id);
    bytes += text->text().size();
    if (bytes > kMostTextBytes) return;
    Changeable::Text& told = *out.add_texts();
    told.set_path(text::as_utf8(text->name()));
    told.set_text(text::unix_lines(text::as_utf8(text->text())));
  }
}

}  // namespace

void OtherFutures::end() {
  for (auto& [id, one] : futures_) drop(one);
  futures_.clear();
  drop(compared_);
}

void OtherFutures::drop(OnePtr& one) {
  if (one) one->is_dropped = true;
  one.reset();
}

// ---- what is asked

Answered OtherFutures::read_changeable(const Sender& sender, const ReadChangeable& asked,
                                       const Reply& reply) {
  return parts_.look_backs.ask_past(sender.channel.connection(), reply.request(),
                                    [asked](PastRun& past, Reply& out) -> Answered {
                                      if (std::string why = past.history().why_not_gone_on(); !why.empty())
                                        return why;
                                      if (auto problem = past.show(asked.cycle())) return problem;
                                      const run::MissionRun& run = past.timeline().run();
                                      tell_parameters(run, asked.robot(), *out.mutable_changeable());
                                      tell_texts(past.history(), run.cycle(), *out.mutable_changeable());
                                      return std::nullopt;
                                    });
}

Answered OtherFutures::what_if(const Sender& sender, const WhatIf& asked, const Reply& reply) {
  if (auto why = why_nonsense(asked)) return why;
  // Texts may bring code of their own, as edits may.
  const bool has_text = std::ranges::any_of(asked.changes(), &WhatIf::Change::has_text);
  if (has_text && !parts_.people.roles().is_operator(sender.client.id))
    return parts_.people.why_no_operator(sender.client);
  const ConnectionId to = sender.channel.connection();
  return parts_.look_backs.ask_past(
      to, reply.request(),
      [this, to, asked, tools = parts_.look_backs.tools(), run = parts_.run.run_number(),
       is_of_recording = parts_.look_backs.is_recording()](PastRun& past,
                                                           Reply& /*says nothing more*/) -> Answered {
        auto made = future_of(asked, past, tools, is_of_recording);
        if (!made) return clean(made.error());
        auto one = std::make_shared<One>();
        one->run = std::move(*made);
        parts_.inbox.post([this, to, one, run] { begin(to, one, run); }, Inbox::Kind::kDuringCycle);
        return std::nullopt;
      });
}

// Takes the place of the one before, unless nobody waits for it any more.
void OtherFutures::begin(ConnectionId to, const OnePtr& one, std::uint64_t run) {
  if (run != parts_.run.run_number() || !parts_.people.channels().contains(to)) return;
  drop(futures_[to]);
  futures_[to] = one;
  keep_on(to, one);
}

Answered OtherFutures::save(const Sender& sender, const SaveFuture&, const Reply& reply) {
  const auto known = futures_.find(sender.channel.connection());
  if (known == futures_.end()) return "there is no other future";
  return parts_.look_backs.ask_past(sender.channel.connection(), reply.request(),
                                    [one = known->second](PastRun&, Reply& out) -> Answered {
                                      if (!one->run) return "there is no other future";
                                      return one->run->save(*out.mutable_recording());
                                    });
}

Answered OtherFutures::forget_future(const Sender& sender, const ForgetFuture&) {
  const ConnectionId to = sender.channel.connection();
  forget(to);
  tell(to, compared_ ? compared_->told : OtherFuture());
  return std::nullopt;
}

void OtherFutures::forget(ConnectionId connection) {
  const auto known = futures_.find(connection);
  if (known == futures_.end()) return;
  drop(known->second);
  futures_.erase(known);
}

void OtherFutures::begin(ConnectionId connection) {
  if (compared_) tell(connection, compared_->told);
}

void OtherFutures::follow_run() {
  const std::uint64_t run = parts_.run.run_number();
  if (std::exchange(known_run_, run) == run) return;
  while (!futures_.empty()) {
    const ConnectionId to = futures_.begin()->first;
    forget(to);
    tell(to, {});
  }
}

// ---- what is told

void OtherFutures::tell(ConnectionId to, const OtherFuture& future) const {
  if (!parts_.people.channels().contains(to)) return;
  ToBrowser out;
  *out.mutable_other_future() = future;
  parts_.people.send(to, out);
}

void OtherFutures::tell_compared() const {
  for (const auto& [id, channel] : parts_.people.channels()) {
    if (!futures_.contains(id)) tell(id, compared_->told);
  }
}

// A piece of it, and then the next one, so that who asks for a moment need not wait for its end.
void OtherFutures::keep_on(ConnectionId to, const OnePtr& one) {
  if (one->is_dropped) return;
  parts_.look_backs.with_past([this, to, one](PastRun*) {
    if (one->is_dropped || !one->run) return;
    one->run->advance(kFuturePiece);
    auto told = std::make_shared<OtherFuture>();
    one->run->encode(*told);
    parts_.inbox.post([this, to, one, told] { take(to, one, std::move(*told)); }, Inbox::Kind::kDuringCycle);
  });
}

void OtherFutures::take(ConnectionId to, const OnePtr& one, OtherFuture told) {
  if (one->is_dropped) return;
  one->told = std::move(told);
  if (one == compared_)
    tell_compared();
  else
    tell(to, one->told);
  if (one->told.is_under_way()) keep_on(to, one);
}

// ---- another recording

namespace {

// What matters of how the two began otherwise.
std::vector<std::string> remarks_on(const history::History& own, const history::History& other) {
  const comparison::Beginning beginning = comparison::compare_beginnings({&own, &other});
  std::vector<std::string> out;
  for (const comparison::Fact& fact : beginning.facts) {
    if (fact.matters) out.push_back(fmt::format("{}: {} and {}", fact.what, fact.values[0], fact.values[1]));
  }
  for (const comparison::TextDifference& text : beginning.texts) {
    const std::string& path = text.paths[0].empty() ? text.paths[1] : text.paths[0];
    const bool is_in_both = !text.paths[0].empty() && !text.paths[1].empty();
    out.push_back(
        fmt::format("{} {}", file_name_of(path), is_in_both ? "differs" : "belongs to one of them alone"));
  }
  return out;
}

}  // namespace

void OtherFutures::compare(const OpenRecording& with) {
  compared_ = std::make_shared<One>();
  compared_->told.set_name(clean(with.name));
  compared_->told.set_is_recording(true);
  compared_->told.set_is_under_way(true);
  parts_.look_backs.with_past(
      [this, with, one = compared_, tools = parts_.look_backs.tools()](PastRun* past) {
        OtherFuture failed = one->told;
        failed.set_is_under_way(false);
        if (past == nullptr) {
          failed.set_problem("the recording on the line can't be computed again");
        } else {
          OtherRun::Settings settings;
          settings.name = with.name;
          settings.is_recording = settings.is_of_recording = true;
          settings.until = std::max(with.history->last_time(), past->history().last_time());
          settings.version = tools.version;
          settings.remarks = remarks_on(past->history(), *with.history);
          text::Diagnostics problems;
          one->run =
              OtherRun::compare(past->timeline().again(), with.history, tools, std::move(settings), problems);
          if (!one->run) failed.set_problem(first_problem(problems));
        }
        parts_.inbox.post(
            [this, one, failed] {
              if (one->run)
                keep_on({}, one);
              else
                take({}, one, failed);
            },
            Inbox::Kind::kDuringCycle);
      });
}

}  // namespace mlab::console
