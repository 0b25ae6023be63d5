#include <array>
#include <list>
#include <memory>
#include <string>
#include <utility>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "mlab/console/server/desk.h"
#include "mlab/console/server/session_socket.h"
#include "mlab/console/server/stream.h"

// The life of a connection.

namespace mlab::console {

/// A connection's entry among the visitors, for as long as it lasts.
class Visit {
 public:
  explicit Visit(Desk& desk) : desk_(desk) {
    if (desk.visitors.size() >= limits::kConnections) make_room();
    entry_ = desk_.visitors.insert(desk_.visitors.end(), Visitor{});
  }
  ~Visit() { desk_.visitors.erase(entry_); }
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

  /// Where its socket is from now on; null: a session has it.
  void set_socket(Tcp::socket* socket) { entry_->socket = socket; }

 private:
  void make_room() {
    beast::error_code ignored;
    for (const Visitor& visitor : desk_.visitors) {
      if (visitor.socket == nullptr || !visitor.socket->is_open()) continue;
      visitor.socket->close(ignored);
      return;
    }
  }

  Desk& desk_;
  std::list<Visitor>::iterator entry_;
};

namespace {

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

HttpRequest request_of(const Request& request) {
  namespace http = beast::http;
  HttpRequest out;
  out.method = request.method() == http::verb::get    ? HttpRequest::Method::kGet
               : request.method() == http::verb::head ? HttpRequest::Method::kHead
               : request.method() == http::verb::post ? HttpRequest::Method::kPost
                                                      : HttpRequest::Method::kOther;
  out.target = view(request.target());
  out.host = view(request[http::field::host]);
  out.origin = view(request[http::field::origin]);
  out.authorization = view(request[http::field::authorization]);
  out.if_none_match = view(request[http::field::if_none_match]);
  out.fetch_site = view(request["Sec-Fetch-Site"]);
  out.is_upgrade = beast::websocket::is_upgrade(request);
  return out;
}

// On the thread that may wait, where the answer needs it.
asio::awaitable<HttpResponse> answer_of(const HttpRequest& request, Desk& desk) {
  if (!Routes::may_wait(request)) co_return desk.routes.answer(request, desk.handlers);
  co_return co_await asio::co_spawn(
      desk.waiting,
      [&]() -> asio::awaitable<HttpResponse> { co_return desk.routes.answer(request, desk.handlers); },
      asio::use_awaitable);
}

/// Sends an answer. False where the connection can't go on.
asio::awaitable<bool> write_answer(Stream& stream, const HttpResponse& answer, const Request& request,
                                   bool keeps, Traffic& traffic) {
  namespace http = beast::http;
  http::response<http::span_body<const char>> response;
  response.result(answer.status);
  response.version(11);
  for (const auto& [name, value] : answer.fields) response.insert(name, value);
  response.set(http::field::content_type, answer.content_type);
  response.keep_alive(keeps);
  const std::size_t size = answer.body ? answer.body->size() : 0;
  const bool is_head = request.method() == http::verb::head;
  if (answer.body && !is_head) response.body() = beast::span<const char>(answer.body->data(), size);
  if (answer.status != 304) response.content_length(size);
  stream.expires_after(limits::kAnswer);
  http::response_serializer<http::span_body<const char>> serializer(response);
  const auto [error, sent] = is_head ? co_await http::async_write_header(stream, serializer, kReturned)
                                     : co_await http::async_write(stream, serializer, kReturned);
  traffic.sent_bytes += sent;
  ++traffic.answered[answer.status];
  co_return !error && keeps;
}

// Bytes came, but they are no request.
bool is_unreadable(beast::error_code error) {
  namespace http = beast::http;
  return error.category() == http::make_error_code(http::error::bad_method).category() &&
         error != http::error::end_of_stream && error != http::error::partial_message;
}

HttpResponse complaint(beast::error_code error) {
  namespace http = beast::http;
  if (error == http::error::header_limit) return refusal(431, "the request's header is too long");
  if (error == http::error::body_limit) return refusal(413, "the request's body is too long");
  return refusal(400, "this is no HTTP request that can be understood");
}

// Tells the other side that nothing more comes, and gives it time to read what came: closing at once on a
// request that was not read to its end would take back the answer.
asio::awaitable<void> part(Stream& stream) {
  stream.expires_after(limits::kGoodbye);
  beast::error_code ignored;
  stream.socket().shutdown(Tcp::socket::shutdown_send, ignored);
  std::array<char, 4096> rest{};
  for (std::size_t taken = 0; taken < limits::kMessageBytes;) {
    const auto [error, size] = co_await stream.async_read_some(asio::buffer(rest), kReturned);
    if (error) co_return;
    taken += size;
  }
}

/// Requests and answers, one after the other, until one of them becomes a session or the connection ends.
asio::awaitable<void> serve_stream(Stream stream, Visit& visit, Desk& desk) {
  namespace http = beast::http;
  beast::flat_buffer buffer;
  auto patience = limits::kHandshake;
  for (bool goes_on = true; goes_on;) {
    http::request_parser<http::string_body> parser;
    parser.header_limit(limits::kHeaderBytes);
    parser.body_limit(limits::kBodyBytes);
    stream.expires_after(std::exchange(patience, limits::kBetweenRequests));
    const auto [error, size] = co_await http::async_read(stream, buffer, parser, kReturned);
    if (is_unreadable(error)) {
      co_await write_answer(stream, complaint(error), parser.get(), false, desk.traffic);
      break;
    }
    if (error) co_return;
    const Request& asked = parser.get();
    const HttpRequest request = request_of(asked);
    const HttpResponse answer = co_await answer_of(request, desk);
    if (answer.status == 101) {
      visit.set_socket(nullptr);
      const auto session = std::make_shared<SessionSocket>(
          std::move(stream), desk,
          request.path() == "/designer" ? desk.handlers.designer : desk.handlers.session);
      co_await session->run(asked);
      co_return;
    }
    goes_on = co_await write_answer(stream, answer, asked, asked.keep_alive(), desk.traffic);
  }
  co_await part(stream);
}

}  // namespace

asio::awaitable<void> serve(Tcp::socket socket, asio::ssl::context* tls, Desk& desk) {
  Visit visit(desk);
  Stream stream(std::move(socket), tls);
  visit.set_socket(&stream.socket());
  stream.expires_after(limits::kHandshake);
  if (co_await stream.handshake()) co_return;
  co_await serve_stream(std::move(stream), visit, desk);
}

}  // namespace mlab::console
