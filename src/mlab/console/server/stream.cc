#include "mlab/console/server/stream.h"

#include <utility>

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/bind_executor.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/stream_traits.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/teardown.hpp>

namespace mlab::console {
namespace {

/// What both have in common: a stream of Beast's, whose lowest layer is a socket with a limit of time.
template <class Wrapped>
class LayersOf : public Stream::Layers {
 public:
  template <class... Arguments>
  explicit LayersOf(Arguments&&... arguments) : stream_(std::forward<Arguments>(arguments)...) {}

  Tcp::socket& socket() override { return beast::get_lowest_layer(stream_).socket(); }
  void expires_after(std::chrono::steady_clock::duration patience) override {
    beast::get_lowest_layer(stream_).expires_after(patience);
  }
  void expires_never() override { beast::get_lowest_layer(stream_).expires_never(); }
  void read_some(Stream::Pieces<asio::mutable_buffer> into, Stream::TransferHandler then) override {
    stream_.async_read_some(into, here(std::move(then)));
  }
  void write_some(Stream::Pieces<asio::const_buffer> from, Stream::TransferHandler then) override {
    stream_.async_write_some(from, here(std::move(then)));
  }
  void tear_down(beast::role_type role, Stream::TearDownHandler then) override {
    using beast::websocket::async_teardown;
    async_teardown(role, stream_, here(std::move(then)));
  }

 protected:
  Wrapped stream_;

 private:
  // The executor that a forgotten handler names can't be posted to; and all of a connection lives on one.
  template <class Then>
  auto here(Then then) {
    return asio::bind_executor(socket().get_executor(), std::move(then));
  }
};

class Plain final : public LayersOf<beast::tcp_stream> {
 public:
  explicit Plain(Tcp::socket socket) : LayersOf(std::move(socket)) {}
  asio::awaitable<beast::error_code> handshake() override { co_return beast::error_code(); }
};

class Encrypted final : public LayersOf<beast::ssl_stream<beast::tcp_stream>> {
 public:
  Encrypted(Tcp::socket socket, asio::ssl::context& tls)
      : LayersOf(beast::tcp_stream(std::move(socket)), tls) {}
  asio::awaitable<beast::error_code> handshake() override {
    const auto [error] =
        co_await stream_.async_handshake(asio::ssl::stream_base::server, asio::as_tuple(asio::use_awaitable));
    co_return error;
  }
};

std::unique_ptr<Stream::Layers> layers_of(Tcp::socket socket, asio::ssl::context* tls) {
  if (tls == nullptr) return std::make_unique<Plain>(std::move(socket));
  return std::make_unique<Encrypted>(std::move(socket), *tls);
}

}  // namespace

Stream::Stream(Tcp::socket socket, asio::ssl::context* tls) : layers_(layers_of(std::move(socket), tls)) {}

}  // namespace mlab::console
