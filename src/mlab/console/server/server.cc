#include "mlab/console/server/server.h"

#include <unistd.h>

#include <array>
#include <exception>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/core.h>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>

#include "mlab/console/server/desk.h"
#include "mlab/console/server/token.h"

namespace mlab::console {
namespace {

using ErrorCode = boost::system::error_code;

std::string hostname() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

// Null where the files can't be used.
std::shared_ptr<asio::ssl::context> read_certificate(const ServerSettings& settings, std::string& error) {
  auto tls = std::make_shared<asio::ssl::context>(asio::ssl::context::tls_server);
  ErrorCode code;
  tls->set_options(asio::ssl::context::default_workarounds | asio::ssl::context::no_tlsv1 |
                       asio::ssl::context::no_tlsv1_1 | asio::ssl::context::no_compression,
                   code);
  tls->use_certificate_chain_file(settings.certificate, code);
  if (code) {
    error = fmt::format("the certificate {} can't be used: {}", settings.certificate, code.message());
    return nullptr;
  }
  tls->use_private_key_file(settings.key, asio::ssl::context::pem, code);
  if (code) {
    error = fmt::format("the key {} can't be used with {}: {}", settings.key, settings.certificate,
                        code.message());
    return nullptr;
  }
  return tls;
}

// The first of the ports that is free.
bool listen(Tcp::acceptor& acceptor, const asio::ip::address& address, const ServerSettings& settings,
            std::string& error) {
  ErrorCode code;
  for (const std::uint16_t port : settings.ports) {
    const Tcp::endpoint endpoint(address, port);
    acceptor.close(code);
    acceptor.open(endpoint.protocol(), code);
    if (!code) acceptor.set_option(asio::socket_base::reuse_address(true), code);
    if (!code) acceptor.bind(endpoint, code);
    if (!code) acceptor.listen(asio::socket_base::max_listen_connections, code);
    if (!code) return true;
    error = fmt::format("can't listen on {} port {}: {}", settings.address, port, code.message());
  }
  return false;
}

void tell_traffic(const Desk& desk, metrics::Exposition& out) {
  const Traffic& traffic = desk.traffic;
  out.gauge("mlab_http_connections", "Connections to the server, sessions included.",
            static_cast<double>(desk.visitors.size()));
  out.gauge("mlab_sessions", "WebSockets of the console and the designer.",
            static_cast<double>(desk.sessions.size()));
  out.counter("mlab_sent_bytes_total", "Bytes of answers and messages, without what TLS and TCP add.",
              static_cast<double>(traffic.sent_bytes));
  out.counter("mlab_sent_messages_total", "Messages to WebSockets.", static_cast<double>(traffic.messages));
  out.counter("mlab_sessions_ended_total",
              "WebSockets that the server has ended: too slow, or no message of its protocol.",
              static_cast<double>(traffic.ended_sessions));
  std::vector<metrics::Exposition::Series> answered;
  for (const auto& [status, count] : traffic.answered)
    answered.push_back({{{"code", std::to_string(status)}}, static_cast<double>(count)});
  out.counter("mlab_http_requests_total", "Requests that were answered, by status.", answered);
}

}  // namespace

/// The listening socket, the thread, and everybody who came.
class Server::Network {
 public:
  Network(std::shared_ptr<asio::ssl::context> tls, std::string address)
      : tls_(std::move(tls)), address_(std::move(address)) {}
  ~Network() {
    stop();
    // Their timers belong to `io_`.
    if (desk_) desk_->sessions.clear();
  }
  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  bool open(const ServerSettings& settings, std::string& error) {
    ErrorCode code;
    const asio::ip::address address = asio::ip::make_address(address_, code);
    if (code) {
      error = fmt::format("can't listen on `{}`: expected an IP address of this machine", address_);
      return false;
    }
    if (!listen(acceptor_, address, settings, error)) return false;
    is_loopback_ = address.is_loopback();
    is_any_ = address.is_unspecified();
    port_ = acceptor_.local_endpoint(code).port();
    const bool keeps_token =
        !settings.token.empty() && (settings.token_port == 0 || settings.token_port == port_);
    Access access(keeps_token ? settings.token : make_token(), {address_, hostname(), port_, is_encrypted()});
    desk_ = std::make_unique<Desk>(io_, Routes(std::move(access), WebFiles::read(settings.web_folder)));
    return true;
  }

  void start(ServerHandlers handlers) {
    desk_->handlers = std::move(handlers);
    desk_->handlers.metrics = [this, others = std::move(desk_->handlers.metrics)](metrics::Exposition& out) {
      if (others) others(out);
      tell_traffic(*desk_, out);
    };
    asio::co_spawn(io_, accept(), asio::detached);
    thread_ = std::thread([this] { run(); });
  }

  void stop() {
    if (!thread_.joinable()) return;
    asio::post(io_, [this] { say_goodbye(); });
    desk_->waiting.join();
    thread_.join();
  }

  void send(ConnectionId to, std::shared_ptr<const std::string> bytes) {
    asio::post(io_, [this, to, bytes = std::move(bytes)]() mutable {
      const auto it = desk_->sessions.find(to);
      if (it != desk_->sessions.end()) it->second->send(std::move(bytes));
    });
  }

  std::uint16_t port() const { return port_; }
  const std::string& token() const { return desk_->routes.access().token(); }
  bool is_encrypted() const { return tls_ != nullptr; }
  bool is_loopback() const { return is_loopback_; }

  std::vector<std::string> urls(const std::string& page) const {
    const bool is_v6 = address_.find(':') != std::string::npos;
    std::vector<std::string> out;
    if (!is_any_) {
      out.push_back(url(is_v6 ? "[" + address_ + "]" : address_, page));
    } else {
      out.push_back(url(is_v6 ? "[::1]" : "127.0.0.1", page));
      if (const std::string name = hostname(); !name.empty()) out.push_back(url(name, page));
    }
    return out;
  }

 private:
  std::string url(const std::string& host, const std::string& page) const {
    return fmt::format("{}://{}:{}/{}?token={}", is_encrypted() ? "https" : "http", host, port_, page,
                       desk_->routes.access().token());
  }

  asio::awaitable<void> accept() {
    for (;;) {
      auto [error, socket] = co_await acceptor_.async_accept(asio::as_tuple(asio::use_awaitable));
      if (!acceptor_.is_open()) co_return;
      if (error) {  // no descriptors left: somebody has to go first
        asio::steady_timer pause(io_, std::chrono::milliseconds(100));
        co_await pause.async_wait(asio::as_tuple(asio::use_awaitable));
        continue;
      }
      ErrorCode ignored;
      socket.set_option(Tcp::no_delay(true), ignored);
      asio::co_spawn(io_, serve(std::move(socket), tls_.get(), *desk_), asio::detached);
    }
  }

  void run() {
    for (;;) {
      try {
        io_.run();
        return;
      } catch (const std::exception& e) {  // what fails is one connection
        fmt::print(stderr, "mlab: a connection of the console failed: {}\n", e.what());
      }
    }
  }

  // Everybody is told, and has a moment to agree.
  void say_goodbye() {
    ErrorCode ignored;
    acceptor_.close(ignored);
    for (const Visitor& visitor : desk_->visitors) {
      if (visitor.socket != nullptr) visitor.socket->close(ignored);
    }
    for (const auto& [id, session] : desk_->sessions) session->leave(Goodbye::kGoingAway, "mlab has ended");
    deadline_.expires_after(limits::kGoodbye + std::chrono::seconds(1));
    deadline_.async_wait([this](ErrorCode) { io_.stop(); });
    wait_for_empty();
  }

  void wait_for_empty() {
    if (desk_->visitors.empty()) {
      io_.stop();
      return;
    }
    poll_.expires_after(std::chrono::milliseconds(5));
    poll_.async_wait([this](ErrorCode error) {
      if (!error) wait_for_empty();
    });
  }

  std::shared_ptr<asio::ssl::context> tls_;
  std::string address_;
  std::unique_ptr<Desk> desk_;
  asio::io_context io_{1};
  Tcp::acceptor acceptor_{io_};
  asio::steady_timer deadline_{io_};
  asio::steady_timer poll_{io_};
  std::uint16_t port_ = 0;
  bool is_loopback_ = true;
  bool is_any_ = false;
  std::thread thread_;
};

std::unique_ptr<Server> Server::open(const ServerSettings& settings, std::string& error) {
  std::shared_ptr<asio::ssl::context> tls;
  if (!settings.certificate.empty()) {
    tls = read_certificate(settings, error);
    if (!tls) return nullptr;
  }
  auto network = std::make_unique<Network>(std::move(tls), settings.address);
  if (!network->open(settings, error)) return nullptr;
  return std::unique_ptr<Server>(new Server(std::move(network)));
}

Server::Server(std::unique_ptr<Network> network) : network_(std::move(network)) {}
Server::~Server() = default;

void Server::start(ServerHandlers handlers) {
  network_->start(std::move(handlers));
}
void Server::stop() {
  network_->stop();
}
void Server::send(ConnectionId to, std::shared_ptr<const std::string> bytes) {
  network_->send(to, std::move(bytes));
}
std::uint16_t Server::port() const {
  return network_->port();
}
const std::string& Server::token() const {
  return network_->token();
}
std::vector<std::string> Server::urls(const std::string& page) const {
  return network_->urls(page);
}
bool Server::is_encrypted() const {
  return network_->is_encrypted();
}
bool Server::is_loopback() const {
  return network_->is_loopback();
}

}  // namespace mlab::console
