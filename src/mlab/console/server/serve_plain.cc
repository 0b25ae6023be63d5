#include "mlab/console/server/serve.h"

namespace mlab::console {

asio::awaitable<void> serve(Tcp::socket socket, Desk& desk) {
  Visit visit(desk);
  co_await serve_stream(beast::tcp_stream(std::move(socket)), visit, desk);
}

}  // namespace mlab::console
