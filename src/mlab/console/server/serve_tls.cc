#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket/ssl.hpp>

#include "mlab/console/server/serve.h"

namespace mlab::console {

asio::awaitable<void> serve_tls(Tcp::socket socket, asio::ssl::context& tls, Desk& desk) {
  Visit visit(desk);
  beast::ssl_stream<beast::tcp_stream> stream(beast::tcp_stream(std::move(socket)), tls);
  visit.set_socket(&beast::get_lowest_layer(stream).socket());
  beast::get_lowest_layer(stream).expires_after(limits::kHandshake);
  const auto [error] = co_await stream.async_handshake(asio::ssl::stream_base::server, kReturned);
  if (error) co_return;
  co_await serve_stream(std::move(stream), visit, desk);
}

}  // namespace mlab::console
