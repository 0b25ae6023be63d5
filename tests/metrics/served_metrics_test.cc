// A real console, asked for its metrics as Prometheus asks; the dashboard and the page that name them.

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../durable/server.h"
#include "../durable/socket.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/console.pb.h"
#include "mlab/metrics/testing/scrape.h"

namespace mlab {
namespace {

namespace fs = std::filesystem;
using console::Control;
using console::ToServer;
using durable::Server;
using metrics::testing::Scrape;
using Names = std::set<std::string>;

std::string text_of(const std::string& path) {
  std::ifstream file(base::source_folder() + "/" + path);
  return (std::ostringstream() << file.rdbuf()).str();
}

// What the server answers to a GET, up to the end of the connection.
std::string get(int port, const std::string& target, const std::string& fields) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::string out;
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    const std::string request = fmt::format(
        "GET {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n{}Connection: close\r\n\r\n", target, port, fields);
    EXPECT_EQ(::send(socket, request.data(), request.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(request.size()));
    std::array<char, 65536> bytes{};
    for (ssize_t size = 0; (size = ::recv(socket, bytes.data(), bytes.size(), 0)) > 0;)
      out.append(bytes.data(), static_cast<std::size_t>(size));
  }
  ::close(socket);
  return out;
}

// Names of metrics that a text speaks of.
Names named_in(const std::string& text) {
  static const std::regex kName("\\b(mlab|process)_[a-z_]+[a-z]\\b");
  Names out;
  for (std::sregex_iterator at(text.begin(), text.end(), kName); at != std::sregex_iterator(); ++at)
    out.insert(at->str());
  return out;
}

Names without(const Names& from, const Names& what) {
  Names out;
  std::ranges::set_difference(from, what, std::inserter(out, out.end()));
  return out;
}

/// A console whose robots have set out.
class ServedMetrics : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / fmt::format("mlab_metrics_{}", ::getpid());
    fs::create_directories(folder_);
    fs::copy(base::source_folder() + "/missions/patrol", folder_ / "patrol");
    server_.emplace(Server::Setup{
        {"run", "patrol/patrol.mdl"}, folder_.string(), {{"XDG_STATE_HOME", folder_.string()}}});
    ASSERT_NE(server_->port(), 0) << server_->printed();
    session_.emplace(server_->port(), "/session?token=" + server_->token());
    ToServer hello;
    hello.mutable_hello()->set_protocol(1);
    hello.mutable_hello()->set_name("a test");
    hello.mutable_hello()->set_client_key("a test");
    session_->send(hello.SerializeAsString());
  }
  void TearDown() override {
    session_.reset();
    server_.reset();
    fs::remove_all(folder_);
  }

  // A run may still be in the making: then it is asked for again.
  void execute() {
    ToServer message;
    message.mutable_control()->set_action(Control::EXECUTE);
    session_->send(message.SerializeAsString());
  }
  std::string answer() const {
    return get(server_->port(), "/metrics", fmt::format("Authorization: Bearer {}\r\n", server_->token()));
  }
  Scrape scrape() const {
    const std::string text = answer();
    return Scrape(text.substr(std::min(text.find("\r\n\r\n") + 4, text.size())));
  }
  // Nothing where none of its robots moves within a minute.
  std::optional<Scrape> scrape_of_a_run() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (std::chrono::steady_clock::now() < end) {
      Scrape out = scrape();
      if (out.value("mlab_bodies") > 0.0) return out;
      if (out.value("mlab_mode{mode=\"ready\"}") == 1.0) execute();
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return std::nullopt;
  }

  fs::path folder_;
  std::optional<Server> server_;
  std::optional<durable::Socket> session_;
};

TEST_F(ServedMetrics, AreWhatPrometheusReadsAndAllThatTheDashboardAndThePageName) {
  const std::optional<Scrape> told = scrape_of_a_run();
  ASSERT_TRUE(told) << answer();
  EXPECT_EQ(told->problems(), "");
  EXPECT_EQ(told->value("mlab_robots{state=\"running\"}"), 2.0);
  EXPECT_EQ(told->value("mlab_sessions"), 1.0);
  EXPECT_GT(told->value("mlab_sent_bytes_total"), 1000.0);
  EXPECT_EQ(told->value("mlab_recording_problem"), 0.0);
  Names families;
  for (const auto& [name, type] : told->types()) families.insert(name);
  // Only where there is such a machine.
  families.insert("mlab_machine_silence_seconds");

  const auto dashboard = nlohmann::json::parse(text_of("docs/dashboards/missionlab.json"));
  Names queried;
  for (const auto& panel : dashboard["panels"]) {
    for (const auto& target : panel["targets"]) queried.merge(named_in(target["expr"].get<std::string>()));
  }
  EXPECT_GT(queried.size(), 20U);
  EXPECT_EQ(without(queried, told->names()), Names{}) << "the dashboard asks for what no console tells";

  const Names on_page = named_in(text_of("docs/metrics.md"));
  EXPECT_EQ(without(on_page, families), Names{}) << "docs/metrics.md names what no console tells";
  EXPECT_EQ(without(families, on_page), Names{}) << "docs/metrics.md does not name them";
}

TEST_F(ServedMetrics, AreNobodysWithoutTheToken) {
  EXPECT_TRUE(get(server_->port(), "/metrics", "").starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(get(server_->port(), "/metrics?token=guess", "").starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(get(server_->port(), "/metrics?token=" + server_->token(), "").starts_with("HTTP/1.1 200"));
  // Nor a page's of another site that knows it.
  const std::string foreign =
      fmt::format("Authorization: Bearer {}\r\nOrigin: http://example.com\r\n", server_->token());
  EXPECT_TRUE(get(server_->port(), "/metrics", foreign).starts_with("HTTP/1.1 403"));
}

}  // namespace
}  // namespace mlab
