// A real server and real clients, over loopback.

#include "mlab/console/server/server.h"

#include <sys/socket.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>

#include "mlab/metrics/testing/scrape.h"

namespace mlab::console {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace fs = std::filesystem;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Socket = websocket::stream<Tcp::socket>;

constexpr const char* kToken = "0123456789abcdef0123456789abcdef01234567";

// What a server told its handlers, as far as other threads may know it.
class HandlerLog {
 public:
  ServerHandlers handlers() {
    ServerHandlers out;
    out.session = handlers_of(received, closed);
    out.designer = handlers_of(designs, closed_designs);
    out.emergency_stop = [this] { note([&] { ++stops; }); };
    out.picture = [](std::uint64_t) { return Content{}; };
    out.report = [this] {
      std::unique_lock lock(mutex);
      changed.wait(lock, [this] { return !report_is_slow; });
      return std::string("{}");
    };
    return out;
  }
  // False where it does not come true within ten seconds.
  template <class Condition>
  bool wait_for(Condition condition) {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, std::chrono::seconds(10), condition);
  }
  template <class Change>
  void note(Change change) {
    const std::scoped_lock lock(mutex);
    change();
    changed.notify_all();
  }

  using Requests = std::vector<std::pair<ConnectionId, std::uint32_t>>;

  std::mutex mutex;
  std::condition_variable changed;
  Requests received;
  std::vector<ConnectionId> closed;
  Requests designs;
  std::vector<ConnectionId> closed_designs;
  int stops = 0;
  bool report_is_slow = false;

 private:
  // A message is a number, in digits.
  SocketHandlers handlers_of(Requests& requests, std::vector<ConnectionId>& ended) {
    return {[this, &requests](ConnectionId from, std::string_view bytes) {
              std::uint32_t request = 0;
              if (std::from_chars(bytes.data(), bytes.data() + bytes.size(), request).ec != std::errc{})
                return false;
              note([&] { requests.emplace_back(from, request); });
              return true;
            },
            [this, &ended](ConnectionId connection) { note([&] { ended.push_back(connection); }); }};
  }
};

class RunningServer : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("mlab_server_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "assets");
    std::ofstream(folder_ / "index.html") << "<!doctype html>";
    settings_.web_folder = folder_.string();
    settings_.token = kToken;
    start();
  }
  void TearDown() override {
    server_.reset();
    fs::remove_all(folder_);
  }
  void start() {
    std::string error;
    server_ = Server::open(settings_, error);
    ASSERT_NE(server_, nullptr) << error;
    server_->start(told_.handlers());
  }

  std::string host() const { return "127.0.0.1:" + std::to_string(server_->port()); }
  Tcp::socket connect() {
    Tcp::socket socket(io_);
    socket.connect({asio::ip::make_address("127.0.0.1"), server_->port()});
    return socket;
  }
  // Sends raw text, and gives what comes back until the server ends the connection.
  std::string exchange(const std::string& text) {
    Tcp::socket socket = connect();
    beast::error_code error;
    asio::write(socket, asio::buffer(text), error);
    std::string out;
    asio::read(socket, asio::dynamic_buffer(out), error);
    return out;
  }
  std::string get(const std::string& target, const std::string& more = "",
                  const std::string& method = "GET") {
    return exchange(method + " " + target + " HTTP/1.1\r\nHost: " + host() + "\r\nConnection: close\r\n" +
                    more + "\r\n");
  }
  // A session, or the status of the refusal.
  std::optional<Socket> open_session(const std::string& token = kToken, const std::string& origin = "",
                                     unsigned* status = nullptr, const std::string& host_name = "",
                                     const std::string& path = "/session") {
    Socket socket(connect());
    socket.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
      if (!origin.empty()) request.set(http::field::origin, origin);
    }));
    socket.read_message_max(256U << 20U);
    websocket::response_type response;
    beast::error_code error;
    socket.handshake(response, host_name.empty() ? host() : host_name, path + "?token=" + token, error);
    if (status != nullptr) *status = response.result_int();
    if (error) return std::nullopt;
    socket.binary(true);
    return socket;
  }
  static void say(Socket& socket, std::uint32_t request) {
    socket.write(asio::buffer(std::to_string(request)));
  }
  // Reads until the connection ends, and tells how.
  static websocket::close_reason end_of(Socket& socket) {
    beast::error_code error;
    beast::flat_buffer buffer;
    while (!error) {
      buffer.clear();
      socket.read(buffer, error);
    }
    return socket.reason();
  }
  // The server still does what it is for.
  void expect_alive() {
    auto session = open_session();
    ASSERT_TRUE(session);
    const std::size_t before = count_received();
    say(*session, 99);
    EXPECT_TRUE(told_.wait_for([&] { return told_.received.size() > before; }));
  }
  std::size_t count_received() {
    const std::scoped_lock lock(told_.mutex);
    return told_.received.size();
  }

  fs::path folder_;
  asio::io_context io_;
  ServerSettings settings_;
  HandlerLog told_;
  std::unique_ptr<Server> server_;
};

TEST_F(RunningServer, HandsMessagesOnInOrderAndSendsBack) {
  auto session = open_session();
  ASSERT_TRUE(session);
  for (std::uint32_t i = 1; i <= 100; ++i) say(*session, i);
  ASSERT_TRUE(told_.wait_for([&] { return told_.received.size() == 100; }));
  for (std::uint32_t i = 1; i <= 100; ++i) EXPECT_EQ(told_.received[i - 1].second, i);
  const ConnectionId id = told_.received[0].first;
  server_->send(id, std::make_shared<const std::string>("one"));
  server_->send(id, std::make_shared<const std::string>(1U << 20U, 'x'));
  beast::flat_buffer buffer;
  session->read(buffer);
  EXPECT_EQ(beast::buffers_to_string(buffer.data()), "one");
  EXPECT_TRUE(session->got_binary());
  buffer.clear();
  session->read(buffer);
  EXPECT_EQ(buffer.size(), 1U << 20U);
  session->close(websocket::close_code::normal);
  EXPECT_TRUE(told_.wait_for([&] { return told_.closed == std::vector{id}; }));
  server_->send(id, std::make_shared<const std::string>("too late"));
  expect_alive();
}

TEST_F(RunningServer, ASessionWantsTokenOriginAndHost) {
  unsigned status = 0;
  for (const char* token : {"", "wrong", "0123456789abcdef0123456789abcdef01234568"}) {
    EXPECT_FALSE(open_session(token, "", &status)) << token;
    EXPECT_EQ(status, 403U);
  }
  EXPECT_FALSE(open_session(kToken, "http://evil.example", &status));
  EXPECT_EQ(status, 403U);
  EXPECT_FALSE(open_session(kToken, "null", &status));
  EXPECT_EQ(status, 403U);
  EXPECT_FALSE(open_session(kToken, "", &status, "evil.example:" + std::to_string(server_->port())));
  EXPECT_EQ(status, 421U);
  EXPECT_TRUE(open_session(kToken, "http://" + host()));
  EXPECT_EQ(count_received(), 0U);
}

TEST_F(RunningServer, ServesThePageOverHttp) {
  const std::string page = get(std::string("/?token=") + kToken);
  EXPECT_TRUE(page.starts_with("HTTP/1.1 200 OK\r\n")) << page;
  EXPECT_TRUE(page.ends_with("\r\n\r\n<!doctype html>")) << page;
  EXPECT_NE(page.find("X-Content-Type-Options: nosniff"), std::string::npos);
  EXPECT_TRUE(get("/").starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(get("/../../etc/passwd").starts_with("HTTP/1.1 404"));
  const std::string head = get(std::string("/?token=") + kToken, "", "HEAD");
  EXPECT_NE(head.find("Content-Length: 15\r\n"), std::string::npos);
  EXPECT_TRUE(head.ends_with("\r\n\r\n")) << head;
  EXPECT_TRUE(get("/", "", "DELETE").starts_with("HTTP/1.1 405"));
}

TEST_F(RunningServer, AConnectionAnswersOneRequestAfterTheOther) {
  const std::string request =
      "GET /health?token=" + std::string(kToken) + " HTTP/1.1\r\nHost: " + host() + "\r\n";
  const std::string out =
      exchange(request + "\r\n" + request + "\r\n" + request + "Connection: close\r\n\r\n");
  std::size_t count = 0;
  for (std::size_t at = out.find("{\"ok\": true}"); at != std::string::npos; at = out.find("{\"ok\"", at + 1))
    ++count;
  EXPECT_EQ(count, 3U);
}

TEST_F(RunningServer, TellsPrometheusWhatWentOverTheNetwork) {
  const std::string bearer = std::string("Authorization: Bearer ") + kToken + "\r\n";
  EXPECT_TRUE(get("/metrics").starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(get("/health", bearer).starts_with("HTTP/1.1 200"));
  const std::string answer = get("/metrics", bearer);
  EXPECT_NE(answer.find("Content-Type: text/plain; version=0.0.4; charset=utf-8\r\n"), std::string::npos)
      << answer;
  const metrics::testing::Scrape scrape(answer.substr(answer.find("\r\n\r\n") + 4));
  EXPECT_EQ(scrape.problems(), "");
  EXPECT_EQ(scrape.value("mlab_http_requests_total{code=\"200\"}"), 1.0);
  EXPECT_EQ(scrape.value("mlab_http_requests_total{code=\"403\"}"), 1.0);
  EXPECT_GT(scrape.value("mlab_sent_bytes_total"), 200.0);
  EXPECT_GE(scrape.value("mlab_http_connections"), 1.0);
  EXPECT_EQ(scrape.value("mlab_sessions"), 0.0);
}

TEST_F(RunningServer, StopIsAnsweredWhileAReportIsWaitedFor) {
  told_.note([&] { told_.report_is_slow = true; });
  std::thread waiting([&] {
    EXPECT_TRUE(
        get("/report", std::string("Authorization: Bearer ") + kToken + "\r\n").starts_with("HTTP/1.1 200"));
  });
  const std::string answer = get("/stop", std::string("Authorization: Bearer ") + kToken + "\r\n", "POST");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200")) << answer;
  EXPECT_EQ(told_.stops, 1);
  told_.note([&] { told_.report_is_slow = false; });
  waiting.join();
}

TEST_F(RunningServer, WhatIsNoRequestIsRefusedAndTheConnectionEnds) {
  EXPECT_TRUE(exchange("what is this\r\n\r\n").starts_with("HTTP/1.1 400"));
  EXPECT_TRUE(
      exchange("GET / HTTP/1.1\r\nHost: " + host() + "\r\nX: " + std::string(100'000, 'x') + "\r\n\r\n")
          .starts_with("HTTP/1.1 431"));
  EXPECT_TRUE(exchange("POST /stop HTTP/1.1\r\nHost: " + host() + "\r\nContent-Length: 100000000\r\n\r\n")
                  .starts_with("HTTP/1.1 413"));
  EXPECT_TRUE(exchange("GET / HTTP/1.1\r\nConnection: close\r\n\r\n").starts_with("HTTP/1.1 421"))
      << "no Host";
  EXPECT_TRUE(
      exchange(std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11)).starts_with("HTTP/1.1 400"))
      << "TLS";
  expect_alive();
}

TEST_F(RunningServer, ADesignerHasASocketOfItsOwn) {
  unsigned status = 0;
  EXPECT_FALSE(open_session("wrong", "", &status, "", "/designer"));
  EXPECT_EQ(status, 403U);
  auto socket = open_session(kToken, "", nullptr, "", "/designer");
  ASSERT_TRUE(socket);
  say(*socket, 12);
  ASSERT_TRUE(told_.wait_for([&] { return told_.designs.size() == 1; }));
  EXPECT_EQ(told_.designs.front().second, 12U);
  socket->write(asio::buffer(std::string("\xff\xff\xff\xff\xff")));
  EXPECT_EQ(end_of(*socket).code, 1007);
  EXPECT_TRUE(told_.wait_for([&] { return told_.closed_designs.size() == 1; }));
  EXPECT_TRUE(told_.closed.empty());
  expect_alive();
}

TEST_F(RunningServer, AMessageThatIsNoneEndsItsConnectionWithAReason) {
  auto broken = open_session();
  ASSERT_TRUE(broken);
  broken->write(asio::buffer(std::string("\xff\xff\xff\xff\xff")));
  const websocket::close_reason reason = end_of(*broken);
  EXPECT_EQ(reason.code, 1007);
  EXPECT_EQ(std::string(reason.reason.c_str()), "this is no message of the console's protocol");

  auto text = open_session();
  ASSERT_TRUE(text);
  text->binary(false);
  text->write(asio::buffer(std::string("hello")));
  EXPECT_EQ(end_of(*text).code, 1003);
  EXPECT_TRUE(told_.wait_for([&] { return told_.closed.size() == 2; }));
  EXPECT_EQ(count_received(), 0U);
  expect_alive();
}

TEST_F(RunningServer, AMessageThatIsTooLongEndsItsConnection) {
  auto session = open_session();
  ASSERT_TRUE(session);
  beast::error_code error;
  session->write(asio::buffer(std::string(5U << 20U, 'x')), error);
  EXPECT_EQ(end_of(*session).code, websocket::close_code::too_big);
  EXPECT_TRUE(told_.wait_for([&] { return told_.closed.size() == 1; }));
  expect_alive();
}

TEST_F(RunningServer, FramesThatBreakTheProtocolEndTheirConnection) {
  for (const std::string& bytes :
       {std::string("\x82\x05hello"),                        // not masked
        std::string("\xf2\x80\x00\x00\x00\x00", 6),          // reserved bits
        std::string("\x83\x80\x00\x00\x00\x00", 6),          // unknown kind
        std::string("\x89\xfe\xff\xff\x00\x00\x00\x00", 8),  // a ping of 65535 bytes
        std::string("\x82\xff\xff\xff\xff\xff\xff\xff\xff\xff\x00\x00\x00\x00", 14)}) {
    auto session = open_session();
    ASSERT_TRUE(session);
    asio::write(session->next_layer(), asio::buffer(bytes));
    end_of(*session);
  }
  EXPECT_TRUE(told_.wait_for([&] { return told_.closed.size() == 5; }));
  expect_alive();
}

// Closing and failing to read at the same time: each waits for the other in Beast.
TEST_F(RunningServer, BrokenFramesAfterAMessageThatIsNoneEndTheConnectionToo) {
  auto session = open_session();
  ASSERT_TRUE(session);
  asio::write(session->next_layer(), asio::buffer(std::string("\x81\x84\0\0\0\0textGET /", 15)));
  EXPECT_TRUE(told_.wait_for([&] { return told_.closed.size() == 1; }));
  expect_alive();
}

TEST_F(RunningServer, WhoTakesNothingIsDisconnectedAndNobodyElseWaits) {
  auto slow = open_session();
  auto quick = open_session();
  ASSERT_TRUE(slow && quick);
  say(*slow, 1);
  ASSERT_TRUE(told_.wait_for([&] { return told_.received.size() == 1; }));
  say(*quick, 2);
  ASSERT_TRUE(told_.wait_for([&] { return told_.received.size() == 2; }));
  const ConnectionId slow_id = told_.received[0].first;
  const auto block = std::make_shared<const std::string>(1U << 20U, 'x');
  const auto began = std::chrono::steady_clock::now();
  const auto is_gone = [&] { return !told_.closed.empty(); };
  while (std::chrono::steady_clock::now() - began < std::chrono::seconds(20)) {
    server_->send(slow_id, block);
    std::unique_lock lock(told_.mutex);
    if (told_.changed.wait_for(lock, std::chrono::milliseconds(100), is_gone)) break;
  }
  ASSERT_TRUE(told_.wait_for(is_gone));
  EXPECT_EQ(told_.closed, std::vector{slow_id});
  server_->send(told_.received[1].first, std::make_shared<const std::string>("for the quick one"));
  beast::flat_buffer buffer;
  quick->read(buffer);
  EXPECT_EQ(beast::buffers_to_string(buffer.data()), "for the quick one");
}

TEST_F(RunningServer, MuchAtOnceIsNoReasonToDisconnectWhoReads) {
  auto session = open_session();
  ASSERT_TRUE(session);
  say(*session, 1);
  ASSERT_TRUE(told_.wait_for([&] { return told_.received.size() == 1; }));
  const auto block = std::make_shared<const std::string>(1U << 20U, 'x');
  for (int i = 0; i < 30; ++i) server_->send(told_.received[0].first, block);
  beast::flat_buffer buffer;
  for (int i = 0; i < 30; ++i) {
    buffer.clear();
    ASSERT_EQ(session->read(buffer), block->size());
  }
}

TEST_F(RunningServer, ConnectionsThatSayNothingKeepNobodyOut) {
  std::vector<Tcp::socket> silent;
  for (int i = 0; i < 400; ++i) {
    silent.push_back(connect());
    if (i % 2 == 0) asio::write(silent.back(), asio::buffer(std::string("GET / HTT")));
  }
  EXPECT_TRUE(get("/stop", std::string("Authorization: Bearer ") + kToken + "\r\n", "POST")
                  .starts_with("HTTP/1.1 200"));
  expect_alive();
}

TEST_F(RunningServer, OneHundredSessionsAreNotAllLetIn) {
  std::vector<Socket> sessions;
  for (int i = 0; i < 100; ++i) {
    auto session = open_session();
    ASSERT_TRUE(session);
    sessions.push_back(std::move(*session));
  }
  for (Socket& session : sessions) {
    beast::error_code ignored;
    session.write(asio::buffer(std::string("5")), ignored);
  }
  EXPECT_TRUE(told_.wait_for([&] { return told_.received.size() == 64; }));
  EXPECT_EQ(end_of(sessions.back()).code, 1013);
  EXPECT_EQ(count_received(), 64U);
  sessions.clear();
  EXPECT_TRUE(told_.wait_for([&] { return told_.closed.size() == 64; }));
  expect_alive();
}

TEST_F(RunningServer, ClientsThatVanishLeaveNothing) {
  for (int i = 0; i < 20; ++i) {
    auto session = open_session();
    ASSERT_TRUE(session);
    say(*session, 1);
    const linger reset{1, 0};
    ::setsockopt(session->next_layer().native_handle(), SOL_SOCKET, SO_LINGER, &reset, sizeof reset);
  }
  EXPECT_TRUE(told_.wait_for([&] { return told_.closed.size() == 20; }));
  expect_alive();
}

TEST_F(RunningServer, StoppingTellsEveryoneAndEndsAtOnce) {
  auto session = open_session();
  ASSERT_TRUE(session);
  say(*session, 1);
  ASSERT_TRUE(told_.wait_for([&] { return told_.received.size() == 1; }));
  Tcp::socket idle = connect();
  std::thread reader([&] {
    const websocket::close_reason reason = end_of(*session);
    EXPECT_EQ(reason.code, websocket::close_code::going_away);
    EXPECT_EQ(std::string(reason.reason.c_str()), "mlab has ended");
  });
  const auto began = std::chrono::steady_clock::now();
  server_->stop();
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(3));
  reader.join();
  server_->send(told_.received[0].first, std::make_shared<const std::string>("nobody"));
}

TEST_F(RunningServer, APortThatIsTakenIsToldOrPassedOver) {
  ServerSettings second = settings_;
  std::string error;
  second.ports = {server_->port()};
  EXPECT_EQ(Server::open(second, error), nullptr);
  EXPECT_NE(error.find("port " + std::to_string(server_->port())), std::string::npos) << error;
  second.ports = {server_->port(), 0};
  const auto other = Server::open(second, error);
  ASSERT_NE(other, nullptr);
  EXPECT_NE(other->port(), server_->port());
  EXPECT_EQ(other->urls(),
            std::vector{"http://127.0.0.1:" + std::to_string(other->port()) + "/?token=" + kToken});
  second.address = "not an address";
  EXPECT_EQ(Server::open(second, error), nullptr);
  EXPECT_NE(error.find("expected an IP address"), std::string::npos) << error;
}

// With a certificate of its own.
class EncryptedServer : public RunningServer {
 protected:
  void SetUp() override {
    settings_.certificate = testing::TempDir() + "mlab_certificate_" + std::to_string(::getpid()) + ".pem";
    settings_.key = testing::TempDir() + "mlab_key_" + std::to_string(::getpid()) + ".pem";
    const std::string command =
        "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj "
        "/CN=localhost "
        "-keyout " +
        settings_.key + " -out " + settings_.certificate + " 2>/dev/null";
    ASSERT_EQ(std::system(command.c_str()),
              0);  // NOLINT(concurrency-mt-unsafe): a test program has one thread
    RunningServer::SetUp();
  }
};

TEST_F(EncryptedServer, SpeaksHttpAndSessionsOverTls) {
  asio::ssl::context tls(asio::ssl::context::tls_client);
  tls.load_verify_file(settings_.certificate);
  tls.set_verify_mode(asio::ssl::verify_peer);
  {
    asio::ssl::stream<Tcp::socket> stream(connect(), tls);
    stream.handshake(asio::ssl::stream_base::client);
    http::request<http::empty_body> request(http::verb::get, std::string("/?token=") + kToken, 11);
    request.set(http::field::host, host());
    http::write(stream, request);
    beast::flat_buffer buffer;
    http::response<http::string_body> response;
    http::read(stream, buffer, response);
    EXPECT_EQ(response.result_int(), 200U);
    EXPECT_NE(response["Content-Security-Policy"].find("wss://"), std::string::npos);
  }
  websocket::stream<beast::ssl_stream<Tcp::socket>> session(connect(), tls);
  session.next_layer().handshake(asio::ssl::stream_base::client);
  session.handshake(host(), std::string("/session?token=") + kToken);
  session.binary(true);
  session.write(asio::buffer(std::string("3")));
  ASSERT_TRUE(told_.wait_for([&] { return told_.received.size() == 1; }));
  server_->send(told_.received[0].first, std::make_shared<const std::string>(1U << 20U, 'x'));
  beast::flat_buffer buffer;
  EXPECT_EQ(session.read(buffer), 1U << 20U);
  EXPECT_TRUE(server_->urls().front().starts_with("https://"));
}

TEST_F(EncryptedServer, WhatIsNotEncryptedGetsNothing) {
  EXPECT_EQ(get(std::string("/?token=") + kToken).find("doctype"), std::string::npos);
  EXPECT_EQ(exchange(std::string(1000, '\xff')).find("HTTP"), std::string::npos);
}

TEST_F(EncryptedServer, ACertificateThatCantBeReadIsTold) {
  std::string error;
  ServerSettings broken = settings_;
  broken.certificate = "/nowhere.pem";
  EXPECT_EQ(Server::open(broken, error), nullptr);
  EXPECT_NE(error.find("the certificate /nowhere.pem can't be used"), std::string::npos) << error;
  broken = settings_;
  broken.key = settings_.certificate;
  EXPECT_EQ(Server::open(broken, error), nullptr);
  EXPECT_NE(error.find("the key"), std::string::npos) << error;
}

}  // namespace
}  // namespace mlab::console
