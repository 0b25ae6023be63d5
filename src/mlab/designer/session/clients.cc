#include "mlab/designer/session/clients.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "mlab/designer/session/request.h"

namespace mlab::designer {
namespace {

// Between two beats [s]: a little less than the loop waits at most.
constexpr double kBeatPause = 0.2;

}  // namespace

Client* Clients::find(console::ConnectionId connection) {
  const auto found = all_.find(connection);
  return found == all_.end() ? nullptr : &found->second;
}

void Clients::open(Client& client, const std::string& document) {
  if (client.opening_of(document) == 0) client.documents[document] = ++openings_;
}

void Clients::close(Client& client, const std::string& document) {
  client.documents.erase(document);
  std::erase_if(client.pages, [&](const Page& page) { return page.document() == document; });
}

bool Clients::is_open(std::string_view document) const {
  return std::ranges::any_of(all_, [&](const auto& known) { return known.second.opening_of(document) != 0; });
}

bool Clients::is_open_beside(const Client& client, std::string_view document) const {
  return std::ranges::any_of(all_, [&](const auto& known) {
    return &known.second != &client && known.second.opening_of(document) != 0;
  });
}

void Clients::rename(const std::string& from, const std::string& to) {
  FromDesigner renamed;
  renamed.mutable_renamed()->set_from(from);
  renamed.mutable_renamed()->set_to(to);
  for (auto& [id, client] : all_) {
    if (client.documents.erase(from) == 0) continue;
    send(id, renamed);
    open(client, to);
    for (Page& page : client.pages) {
      if (page.document() == from) page.set_document(to);
    }
  }
}

void Clients::look(const Sender& sender, const Look& look) {
  sender.client.pages.assign(look.pages().begin(), look.pages().end());
}

void Clients::send(console::ConnectionId to, const FromDesigner& message) const {
  send_bytes(to, message.SerializeAsString());
}

void Clients::send_bytes(console::ConnectionId to, std::string bytes) const {
  send_(to, std::make_shared<const std::string>(std::move(bytes)));
}

void Clients::beat(const Sender& sender, const console::Beat& beat) {
  sender.client.beat = beat.number();
  send_beat(sender.asker.connection, sender.client);
}

void Clients::send_beat(console::ConnectionId to, const Client& client) const {
  FromDesigner message;
  message.mutable_beat()->set_number(client.beat);
  send(to, message);
}

void Clients::send_beats() {
  const double now = wall_time();
  if (now - last_beats_ < kBeatPause) return;
  last_beats_ = now;
  for (const auto& [to, client] : all_) {
    if (client.has_greeted) send_beat(to, client);
  }
}

}  // namespace mlab::designer
