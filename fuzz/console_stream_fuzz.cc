// Any bytes as what a stranger sends to the console's server: HTTP, WebSocket, messages. The connection is
// one end of a pair of sockets; whatever comes, it ends soon after the stranger does, and nothing is done
// without the token.

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>

#include "mlab/console.pb.h"
#include "mlab/console/server/desk.h"

namespace {

namespace asio = boost::asio;
using namespace mlab::console;

constexpr std::string_view kToken = "secret";

// What the server has to say, thrown away.
void drain(int client) {
  std::array<char, 65536> bytes{};
  while (::read(client, bytes.data(), bytes.size()) > 0) {
  }
}

// All of it, or as much as somebody is there to take.
void send(int client, std::string_view bytes) {
  [[maybe_unused]] const ssize_t sent = ::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

ServerHandlers handlers(Desk& desk, int& done) {
  ServerHandlers out;
  out.session.receive = [&](ConnectionId from, std::string_view bytes) {
    ToServer message;
    if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return false;
    ++done;
    desk.sessions.at(from)->send(std::make_shared<const std::string>(message.SerializeAsString()));
    return true;
  };
  out.session.closed = [](ConnectionId) {};
  out.emergency_stop = [&] { ++done; };
  out.picture = [](std::uint64_t revision) {
    return revision == 1 ? Content{"image/png", std::make_shared<const std::string>("PNG")} : Content{};
  };
  out.report = [] { return std::string("{}"); };
  return out;
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  std::array<int, 2> ends{};
  if (size > 100'000 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return 0;
  const auto [client, server] = ends;
  ::fcntl(client, F_SETFL, O_NONBLOCK);
  asio::io_context io(1);
  Desk desk(io,
            Routes(Access(std::string(kToken), {"127.0.0.1", "lab", 80, false}), WebFiles::read("/nowhere")));
  int done = 0;
  desk.handlers = handlers(desk, done);
  Tcp::socket socket(io);
  socket.assign(Tcp::v4(), server);
  asio::co_spawn(io, serve(std::move(socket), nullptr, desk), asio::detached);

  // A browser sends nothing of a session before its request is answered.
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t request = std::min(text.find("\r\n\r\n"), size - std::min<std::size_t>(size, 4)) + 4;
  send(client, text.substr(0, request));
  for (int i = 0; i < 10; ++i) {
    io.restart();
    io.poll();
  }
  send(client, text.substr(std::min(request, size)));
  ::shutdown(client, SHUT_WR);
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  do {
    io.restart();
    io.run_one_for(std::chrono::milliseconds(20));
    drain(client);
    if (std::chrono::steady_clock::now() > deadline) {
      std::fprintf(stderr, "the connection does not end\n");
      std::abort();
    }
  } while (!desk.visitors.empty());
  if (done > 0 && text.find(kToken) == std::string_view::npos) {
    std::fprintf(stderr, "something was done for a stranger\n");
    std::abort();
  }
  desk.sessions.clear();
  ::close(client);
  return 0;
}
