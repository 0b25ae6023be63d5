// The loop over standard input and output.

#include <poll.h>
#include <unistd.h>
#include <cerrno>

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "mlab/lsp/framing.h"
#include "mlab/lsp/server.h"

namespace mlab::lsp {
namespace {

/// How long nothing has to come before what takes long is begun [ms].
constexpr int kQuiet = 25;

}  // namespace

int serve(Options options, int input, const std::function<bool(std::string_view)>& write) {
  bool can_write = true;
  Server server(std::move(options),
                [&](const std::string& message) { can_write = can_write && write(framed(message)); });
  MessageReader reader;
  std::array<char, 1 << 16> bytes{};
  while (!server.is_over() && can_write) {
    while (const auto message = reader.next()) {
      message->error.empty() ? server.receive(message->body) : server.refuse(message->error);
      if (server.is_over()) return server.exit_status();
    }
    pollfd wait{input, POLLIN, 0};
    const int ready = ::poll(&wait, 1, server.has_work() ? kQuiet : -1);
    if (ready == 0) {
      server.work();
      continue;
    }
    const ssize_t got = ::read(input, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return 1;  // who asked is gone without `exit`
    reader.add({bytes.data(), static_cast<std::size_t>(got)});
  }
  return server.exit_status();
}

}  // namespace mlab::lsp
