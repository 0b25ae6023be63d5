#include "mlab/console/roles.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/console.pb.h"

namespace mlab::console {
namespace {

constexpr std::size_t kMostNameBytes = 64;

// At most so many bytes of a name, cut between characters.
std::string shortened(std::string name) {
  if (name.size() <= kMostNameBytes) return name;
  std::size_t end = kMostNameBytes;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
  name.resize(end);
  return name;
}

}  // namespace

std::uint32_t Roles::add(ConnectionId connection, const std::string& name, const std::string& key) {
  Client client;
  client.id = ++last_;
  client.name = name.empty() ? fmt::format("Browser {}", client.id) : shortened(name);
  client.key = key;
  client.connection = connection;
  clients_.push_back(std::move(client));
  if (operator_ == 0) operator_ = last_;
  return last_;
}

Roles::Joined Roles::join(ConnectionId connection, const std::string& name, const std::string& key,
                          double now) {
  forget(now);
  const auto known =
      std::ranges::find_if(clients_, [&](const Client& c) { return !key.empty() && c.key == key; });
  if (known == clients_.end()) return {add(connection, name, key), {}};
  const std::uint32_t id = known->id;
  const ConnectionId displaced = known->connection;
  known->connection = connection;
  if (!name.empty()) known->name = shortened(name);
  if (operator_ == 0) operator_ = id;
  if (displaced.value != 0) add(displaced, known->name + " (2)", "");
  return {id, displaced};
}

bool Roles::leave(ConnectionId connection, double now) {
  const auto at = std::ranges::find(clients_, connection, &Client::connection);
  if (connection.value == 0 || at == clients_.end()) return false;
  at->connection = {};
  at->left = now;
  if (asks_ == at->id) asks_ = 0;
  // Somebody waits for this place: there is nobody left to decide.
  if (operator_ == at->id && asks_ != 0) {
    operator_ = asks_;
    asks_ = 0;
  }
  return true;
}

bool Roles::forget(double now) {
  const std::size_t removed = std::erase_if(
      clients_, [&](const Client& c) { return c.connection.value == 0 && now - c.left >= kKept; });
  if (find(operator_) == nullptr) operator_ = 0;
  return removed > 0;
}

std::optional<double> Roles::next_to_forget() const {
  std::optional<double> next;
  for (const Client& client : clients_) {
    if (client.connection.value == 0)
      next = std::min(next.value_or(client.left + kKept), client.left + kKept);
  }
  return next;
}

const Roles::Client* Roles::of(ConnectionId connection) const {
  const auto at = std::ranges::find(clients_, connection, &Client::connection);
  return connection.value == 0 || at == clients_.end() ? nullptr : &*at;
}

const Roles::Client* Roles::find(std::uint32_t client) const {
  const auto at = std::ranges::find(clients_, client, &Client::id);
  return at == clients_.end() ? nullptr : &*at;
}

bool Roles::take(std::uint32_t client) {
  const Client* holder = find(operator_);
  if (operator_ == client || holder == nullptr || holder->connection.value == 0) {
    operator_ = client;
    if (asks_ == client) asks_ = 0;
    return true;
  }
  asks_ = client;
  return false;
}

std::optional<std::string> Roles::pass(std::uint32_t from, std::uint32_t to) {
  if (from != operator_) return "only the operator can hand over the operator's place";
  if (to != 0) {
    const Client* next = find(to);
    if (next == nullptr || next->connection.value == 0) return fmt::format("client {} is not here", to);
    operator_ = to;
  }
  asks_ = 0;
  return std::nullopt;
}

void Roles::recall(std::vector<Client> clients, std::uint32_t operator_id, double now) {
  if (last_ != 0) return;
  for (Client& one : clients) {
    if (one.id == 0 || one.key.empty() || find(one.id) != nullptr) continue;
    last_ = std::max(last_, one.id);
    one.connection = {};
    one.left = now;
    if (one.id == operator_id) operator_ = operator_id;
    clients_.push_back(std::move(one));
  }
}

void Roles::encode(Clients& out) const {
  for (const Client& client : clients_) {
    Clients::Client& told = *out.add_clients();
    told.set_id(client.id);
    told.set_name(client.name);
    told.set_is_connected(client.connection.value != 0);
  }
  out.set_operator_(operator_);
  out.set_asks(asks_);
}

}  // namespace mlab::console
