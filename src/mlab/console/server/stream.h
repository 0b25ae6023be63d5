#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>

#include <boost/asio/any_completion_handler.hpp>
#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/async_result.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/role.hpp>

namespace mlab::console {

namespace asio = boost::asio;
namespace beast = boost::beast;
using Tcp = asio::ip::tcp;

/// The bytes of a connection, with TLS or without: what HTTP and WebSockets are read from and written to, as
/// Beast wants a stream to be. Who asks for bytes is forgotten at its border, so that Beast is instantiated
/// for this one type, and the layers under it for two operations each: that is three quarters of the time to
/// compile the server.
class Stream {
 public:
  using executor_type = asio::any_io_executor;
  using TransferHandler = asio::any_completion_handler<void(beast::error_code, std::size_t)>;
  using TearDownHandler = asio::any_completion_handler<void(beast::error_code)>;

  /// A few pieces of memory, as a sequence of buffers that has one type. Owns none of it.
  template <class Buffer>
  class Pieces {
   public:
    using value_type = Buffer;
    // NOLINTNEXTLINE(readability-identifier-naming): its name is Asio's
    using const_iterator = const Buffer*;
    /// The first of the pieces, as far as there is room: nobody is promised that all is read or written at
    /// once.
    template <class Buffers>
    explicit Pieces(const Buffers& buffers) {
      const auto last = asio::buffer_sequence_end(buffers);
      for (auto it = asio::buffer_sequence_begin(buffers); it != last && count_ < pieces_.size(); ++it) {
        const Buffer piece(*it);
        if (piece.size() > 0) pieces_[count_++] = piece;
      }
    }
    const_iterator begin() const { return pieces_.data(); }
    const_iterator end() const { return pieces_.data() + count_; }

   private:
    std::array<Buffer, 16> pieces_{};
    std::size_t count_ = 0;
  };

  /// What a stream is made of; `stream.cc` has the two.
  class Layers {
   public:
    virtual ~Layers() = default;
    virtual Tcp::socket& socket() = 0;
    virtual void expires_after(std::chrono::steady_clock::duration patience) = 0;
    virtual void expires_never() = 0;
    virtual asio::awaitable<beast::error_code> handshake() = 0;
    virtual void read_some(Pieces<asio::mutable_buffer> into, TransferHandler then) = 0;
    virtual void write_some(Pieces<asio::const_buffer> from, TransferHandler then) = 0;
    virtual void tear_down(beast::role_type role, TearDownHandler then) = 0;
  };

  /// @param tls  null: without TLS. Must outlive the stream.
  Stream(Tcp::socket socket, asio::ssl::context* tls);

  executor_type get_executor() { return layers_->socket().get_executor(); }
  Tcp::socket& socket() { return layers_->socket(); }
  /// What is asked of the stream from now on fails where it takes longer.
  void expires_after(std::chrono::steady_clock::duration patience) { layers_->expires_after(patience); }
  void expires_never() { layers_->expires_never(); }
  /// The server's part of TLS's handshake; nothing without TLS.
  asio::awaitable<beast::error_code> handshake() { return layers_->handshake(); }

  template <class Buffers, class Token>
  auto async_read_some(const Buffers& into, Token&& token) {
    return asio::async_initiate<Token, void(beast::error_code, std::size_t)>(
        [](auto then, Layers* layers, const Pieces<asio::mutable_buffer>& pieces) {
          layers->read_some(pieces, TransferHandler(std::move(then)));
        },
        token, layers_.get(), Pieces<asio::mutable_buffer>(into));
  }

  template <class Buffers, class Token>
  auto async_write_some(const Buffers& from, Token&& token) {
    return asio::async_initiate<Token, void(beast::error_code, std::size_t)>(
        [](auto then, Layers* layers, const Pieces<asio::const_buffer>& pieces) {
          layers->write_some(pieces, TransferHandler(std::move(then)));
        },
        token, layers_.get(), Pieces<asio::const_buffer>(from));
  }

  // What Beast finds by the type of its argument.
  friend void beast_close_socket(Stream& stream) {
    beast::error_code ignored;
    stream.socket().close(ignored);
  }
  template <class Then>
  friend void async_teardown(beast::role_type role, Stream& stream, Then&& then) {
    stream.layers_->tear_down(role, TearDownHandler(std::forward<Then>(then)));
  }

 private:
  std::unique_ptr<Layers> layers_;
};

}  // namespace mlab::console
