#include <utility>

#include <fmt/core.h>

#include "mlab/console/check_text.h"
#include "mlab/console/completion.h"
#include "mlab/console/session_parts.h"

namespace mlab::console {
namespace {

constexpr std::uint32_t kProtocol = 1;

bool is_for_operator(const ToServer& message) {
  const int body = message.body_case();
  return body >= ToServer::kControl && body <= ToServer::kSaveDocuments;
}

}  // namespace

void Session::Parts::take(ConnectionId from, const ToServer& message) {
  if (message.has_hello()) {
    take_hello(from, message.hello(), message.request());
    return;
  }
  const auto channel = channels_.find(from);
  const Roles::Client* client = roles_.of(from);
  if (channel == channels_.end() || client == nullptr) {
    ToBrowser out;
    out.mutable_reply()->set_request(message.request());
    out.mutable_reply()->set_error("a connection begins with Hello");
    send(from, out);
    return;
  }
  take_as_client(channel->second, *client, message);
}

void Session::Parts::take_hello(ConnectionId from, const Hello& hello, std::uint32_t request) {
  ToBrowser out;
  out.mutable_reply()->set_request(request);
  if (hello.protocol() != kProtocol) {
    out.mutable_reply()->set_error(
        fmt::format("this server speaks version {} of the protocol, not {}: load the page anew", kProtocol,
                    hello.protocol()));
    send(from, out);
    return;
  }
  if (channels_.contains(from)) {
    out.mutable_reply()->set_error("Hello has been said");
    send(from, out);
    return;
  }
  const Roles::Joined joined = roles_.join(from, hello.name(), hello.client_key(), now());
  channels_.emplace(from, Channel(from));
  greet(from);
  if (joined.displaced.value != 0 && channels_.contains(joined.displaced)) {
    ToBrowser other;
    other.mutable_welcome()->set_protocol(kProtocol);
    other.mutable_welcome()->set_client(roles_.of(joined.displaced)->id);
    other.mutable_welcome()->set_version(settings_.version);
    other.mutable_welcome()->set_session(session_name_);
    other.mutable_welcome()->set_may_compile(settings_.permission.takes_new_code());
    send(joined.displaced, other);
  }
  changes_.clients = true;
  if (request != 0) {
    out.mutable_reply()->set_ok(true);
    send(from, out);
  }
}

void Session::Parts::greet(ConnectionId to) {
  ToBrowser out;
  Welcome& welcome = *out.mutable_welcome();
  welcome.set_protocol(kProtocol);
  welcome.set_client(roles_.of(to)->id);
  welcome.set_version(settings_.version);
  welcome.set_session(session_name_);
  welcome.set_may_compile(settings_.permission.takes_new_code());
  send(to, out);
  *out.mutable_project() = documents_.project_message();
  send(to, out);
  *out.mutable_documents() = documents_.documents_message();
  out.mutable_documents()->set_runs_older_text(documents_.runs_older_text());
  send(to, out);
  fill_scene(out);
  send(to, out);
  fill_roster(out);
  send(to, out);
  fill_starts(out);
  send(to, out);
  fill_plan(out);
  send(to, out);
  *out.mutable_status() = status_message();
  send(to, out);
  fill_questions(out);
  send(to, out);
  Channel& channel = channels_.at(to);
  log_.encode_since(0, *out.mutable_log());
  channel.log_seen = log_.last();
  send(to, out);
  roles_.encode(*out.mutable_clients());
  send(to, out);
  *out.mutable_edits() = documents_.edit_state();
  send(to, out);
  out.mutable_trails()->Clear();
  if (live_) live_->trails().encode(*out.mutable_trails());
  send(to, out);
  greet_with_breakpoints(to);
}

void Session::Parts::take_as_client(Channel& channel, const Roles::Client& client, const ToServer& message) {
  ToBrowser out;
  Reply& reply = *out.mutable_reply();
  reply.set_request(message.request());
  Answered error;
  if (is_for_operator(message) && !roles_.is_operator(client.id) &&
      !(message.has_typed() && message.typed().preview())) {
    const Roles::Client* holder = roles_.find(roles_.operator_id());
    error = holder == nullptr ? "nobody is the operator: take the operator's place first"
                              : fmt::format("only the operator may do this, and that is {}", holder->name);
  } else if (is_for_operator(message)) {
    error = take_as_operator(client.name, message, reply);
  } else {
    error = take_from_anybody(channel, client, message, reply);
  }
  if (message.request() == 0) return;
  reply.set_ok(!error.has_value());
  if (error) reply.set_error(*error);
  send(channel.connection(), out);
}

Session::Parts::Answered Session::Parts::take_from_anybody(Channel& channel, const Roles::Client& client,
                                                           const ToServer& message, Reply& reply) {
  switch (message.body_case()) {
    case ToServer::kAcknowledge:
      channel.acknowledge(message.acknowledge().frame());
      return std::nullopt;
    case ToServer::kBeat:
      channel.beat = message.beat().number();
      send_beat(channel);
      return std::nullopt;
    case ToServer::kWatch:
      channel.watch(message.watch());
      update_watches();
      for (const Series& series : channel.watched().series()) {
        if (live_) channel.series_seen.try_emplace(series.id(), live_->series().last_time(series, -1.0));
      }
      return std::nullopt;
    case ToServer::kEmergencyStop:
      return std::nullopt;  // seen before it was read
    case ToServer::kReadSeries:
      read_series(message.read_series(), reply);
      return std::nullopt;
    case ToServer::kComplete:
      *reply.mutable_completions() = complete(message.complete(), documents_.known_names(plain_.get()));
      return std::nullopt;
    case ToServer::kCheck: {
      const text::Diagnostics problems =
          check_text(message.check(), plain_.get(), documents_.mission_folder(), documents_.load_options());
      for (const text::Diagnostic& problem : problems.items())
        *reply.add_diagnostics() = documents_.message(problem);
      return std::nullopt;
    }
    case ToServer::kListFiles:
      return list_files(message.list_files(), reply);
    case ToServer::kTakeOperator:
    case ToServer::kPassOperator:
      return take_ownership(client, message);
    default:
      return "this request is not known here";
  }
}

Session::Parts::Answered Session::Parts::list_files(const ListFiles& list, Reply& reply) const {
  const auto entries = project_.list(list.folder());
  if (!entries) return entries.error().message;
  FileList& out = *reply.mutable_files();
  out.set_folder(list.folder());
  for (const ProjectFolder::Entry& entry : *entries) {
    FileList::Entry& told = *out.add_entries();
    told.set_path(entry.path);
    told.set_is_folder(entry.is_folder);
    told.set_kind(entry.kind);
  }
  return std::nullopt;
}

Session::Parts::Answered Session::Parts::take_ownership(const Roles::Client& client,
                                                        const ToServer& message) {
  changes_.clients = true;
  if (message.has_take_operator()) {
    if (roles_.take(client.id)) note(client.name, "is the operator");
    return std::nullopt;
  }
  const std::uint32_t to = message.pass_operator().client();
  if (auto error = roles_.pass(client.id, to)) return error;
  if (to != 0 && to != client.id) note(roles_.find(to)->name, "is the operator");
  return std::nullopt;
}

void Session::Parts::take_closed(ConnectionId connection) {
  channels_.erase(connection);
  update_watches();
  if (roles_.leave(connection, now())) changes_.clients = true;
}

Session::Parts::Answered Session::Parts::take_as_operator(const std::string& who, const ToServer& message,
                                                          Reply& reply) {
  has_nothing_to_do_ = false;
  switch (message.body_case()) {
    case ToServer::kControl:
      return control(who, message.control());
    case ToServer::kSetSpeed:
      return set_speed(who, message.set_speed().speed());
    case ToServer::kAnswer:
      return answer(who, message.answer());
    case ToServer::kTyped:
      return typed(who, message.typed(), reply);
    case ToServer::kStartTeleoperation:
      return start_teleoperation(who, message.start_teleoperation());
    case ToServer::kStick:
      if (!live_ || is_stopped_) return "nothing can be steered now";
      return teleoperations_.push(live_->run(), message.stick(), now());
    case ToServer::kEndTeleoperation:
      return end_teleoperation(who, message.end_teleoperation());
    case ToServer::kSetParameter:
      return set_parameter(who, message.set_parameter());
    case ToServer::kSetBreakpoint:
      return set_breakpoint(who, message.set_breakpoint(), reply);
    case ToServer::kRemoveBreakpoint:
      return remove_breakpoint(who, message.remove_breakpoint());
    case ToServer::kSetOption:
      return set_option(who, message.set_option());
    case ToServer::kOpenMission:
      return open(who, message.open_mission().path());
    default:
      return edit(who, message);
  }
}

}  // namespace mlab::console
