#include "operator.h"

#include <algorithm>
#include <chrono>

namespace mlab::durable {

Operator::Operator(const Server& server) : socket_(server.port(), "/session?token=" + server.token()) {
  console::ToServer hello;
  hello.mutable_hello()->set_protocol(1);
  hello.mutable_hello()->set_name("Anna");
  hello.mutable_hello()->set_client_key("annas tab");
  socket_.send(hello.SerializeAsString());
  wait([&] { return is_greeted_; });
}

std::uint32_t Operator::send(console::ToServer message) {
  message.set_request(++request_);
  socket_.send(message.SerializeAsString());
  return request_;
}

std::optional<console::Reply> Operator::ask(console::ToServer message) {
  const std::uint32_t request = send(std::move(message));
  if (!wait([&] { return replies_.contains(request); })) return std::nullopt;
  return replies_.at(request);
}

std::optional<console::Reply> Operator::control(console::Control::Action action) {
  console::ToServer message;
  message.mutable_control()->set_action(action);
  return ask(message);
}

std::optional<console::Reply> Operator::type(const std::string& line) {
  console::ToServer message;
  message.mutable_typed()->set_line(line);
  return ask(message);
}

bool Operator::wait(const std::function<bool()>& is_so) {
  while (!is_so()) {
    if (!take(60.0)) return false;
  }
  return true;
}

void Operator::listen(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  for (double left = seconds; left > 0.0; left = std::chrono::duration<double>(end - Clock::now()).count()) {
    if (!take(left)) return;
  }
}

bool Operator::has_log(const std::string& text) const {
  return std::ranges::any_of(
      log_, [&](const console::Log::Entry& one) { return one.text().find(text) != std::string::npos; });
}

bool Operator::take(double seconds) {
  const auto bytes = socket_.receive(seconds);
  if (!bytes) return false;
  console::ToBrowser in;
  if (!in.ParseFromString(*bytes)) return true;
  if (in.has_welcome()) id_ = in.welcome().client();
  if (in.has_reply()) replies_[in.reply().request()] = in.reply();
  if (in.has_status()) status_ = in.status();
  if (in.has_clients()) clients_ = in.clients();
  if (in.has_breakpoints()) breakpoints_ = in.breakpoints();
  if (in.has_journal()) {
    journal_ = in.journal();
    is_greeted_ = true;  // it is told last
  }
  if (in.has_frame()) {
    console::ToServer drawn;
    drawn.mutable_acknowledge()->set_frame(in.frame().number());
    socket_.send(drawn.SerializeAsString());
  }
  if (in.has_log()) {
    if (in.log().is_whole()) log_.clear();
    log_.insert(log_.end(), in.log().entries().begin(), in.log().entries().end());
  }
  return true;
}

}  // namespace mlab::durable
