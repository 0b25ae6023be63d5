#include "mlab/console/server/routes.h"

#include <filesystem>
#include <fstream>
#include <optional>

#include <gtest/gtest.h>

namespace mlab::console {
namespace {

namespace fs = std::filesystem;
using Method = HttpRequest::Method;

// A folder of web files with a secret beside it.
class RoutesOfAFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("mlab_routes_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "web" / "assets");
    std::ofstream(folder_ / "secret.txt") << "secret";
    std::ofstream(folder_ / "web" / "index.html") << "<!doctype html>";
    std::ofstream(folder_ / "web" / "icon.svg") << "<svg/>";
    std::ofstream(folder_ / "web" / "assets" / "index-1a2b.js") << "let x";
    routes_.emplace(Access("secret", {"127.0.0.1", "lab", 8642, false}),
                    WebFiles::read((folder_ / "web").string()));
    request_.host = "127.0.0.1:8642";
    handlers_.emergency_stop = [this] { ++stops_; };
    handlers_.report = [] { return std::string("{\"outcome\": \"done\"}"); };
    handlers_.metrics = [](metrics::Exposition& out) { out.gauge("mlab_robots", "Robots.", 4.0); };
    handlers_.picture = [](std::uint64_t revision) {
      return revision == 7 ? Content{"image/png", std::make_shared<const std::string>("PNG")} : Content{};
    };
    handlers_.tile = [](std::uint32_t zoom, std::uint32_t column, std::uint32_t row) {
      const bool is_there = zoom == 5 && column == 17 && row == 11;
      return is_there ? Content{"image/webp", std::make_shared<const std::string>("RIFF")} : Content{};
    };
  }
  void TearDown() override { fs::remove_all(folder_); }

  HttpResponse ask(std::string_view target, Method method = Method::kGet) {
    request_.target = target;
    request_.method = method;
    return routes_->answer(request_, handlers_);
  }
  static std::string body(const HttpResponse& response) { return response.body ? *response.body : ""; }
  static std::string field(const HttpResponse& response, std::string_view name) {
    std::string out;
    for (const auto& [key, value] : response.fields) {
      if (key == name) out += value;
    }
    return out;
  }

  fs::path folder_;
  std::optional<Routes> routes_;
  ServerHandlers handlers_;
  HttpRequest request_;
  int stops_ = 0;
};

TEST_F(RoutesOfAFolder, ThePageWantsTheTokenAndIsNeverKept) {
  const HttpResponse page = ask("/?token=secret");
  EXPECT_EQ(page.status, 200U);
  EXPECT_EQ(body(page), "<!doctype html>");
  EXPECT_EQ(page.content_type, "text/html; charset=utf-8");
  EXPECT_EQ(field(page, "Cache-Control"), "no-store");
  EXPECT_EQ(ask("/").status, 403U);
  EXPECT_NE(body(ask("/")).find("address that `mlab run` or `mlab edit` printed"), std::string::npos);
  EXPECT_EQ(ask("/index.html?token=wrong").status, 403U);
}

TEST_F(RoutesOfAFolder, MetricsWantTheTokenAsPrometheusSendsIt) {
  EXPECT_EQ(ask("/metrics").status, 403U);
  EXPECT_EQ(ask("/metrics?token=secret").status, 200U);
  request_.authorization = "Bearer secret";
  const HttpResponse told = ask("/metrics");
  EXPECT_EQ(told.status, 200U);
  EXPECT_EQ(told.content_type, "text/plain; version=0.0.4; charset=utf-8");
  EXPECT_EQ(body(told), "# HELP mlab_robots Robots.\n# TYPE mlab_robots gauge\nmlab_robots 4\n");
  EXPECT_EQ(field(told, "Cache-Control"), "no-store");
  EXPECT_EQ(ask("/metrics", Method::kPost).status, 405U);
  request_.authorization = "Bearer wrong";
  EXPECT_EQ(ask("/metrics").status, 403U);
  request_.authorization = "Bearer secret";
  request_.host = "monitor.example:8642";
  EXPECT_EQ(ask("/metrics").status, 421U);
}

TEST_F(RoutesOfAFolder, FilesOfTheClientAreFreeAndKept) {
  const HttpResponse script = ask("/assets/index-1a2b.js");
  EXPECT_EQ(body(script), "let x");
  EXPECT_EQ(script.content_type, "text/javascript; charset=utf-8");
  EXPECT_NE(field(script, "Cache-Control").find("immutable"), std::string::npos);
  const HttpResponse icon = ask("/icon.svg");
  EXPECT_EQ(icon.content_type, "image/svg+xml");
  EXPECT_EQ(field(icon, "Cache-Control"), "no-cache");
  const std::string etag = field(icon, "ETag");
  request_.if_none_match = etag;
  EXPECT_EQ(ask("/icon.svg").status, 304U);
  EXPECT_EQ(body(ask("/icon.svg")), "");
  EXPECT_EQ(ask("/assets/index-1a2b.js").status, 200U) << "another file";
}

TEST_F(RoutesOfAFolder, NothingOutsideOfTheFolderIsReached) {
  for (const char* target :
       {"/../secret.txt", "/assets/../../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt",
        "//etc/passwd", "/assets/..\\..\\secret.txt", "/./index.html", "/assets", "/assets/", "", "*",
        "secret.txt", "/../web/index.html", "http://127.0.0.1:8642/index.html", "/index.html/",
        "/index.html%00"}) {
    EXPECT_EQ(ask(target).status, 404U) << target;
  }
}

TEST_F(RoutesOfAFolder, EveryPrivateAddressWantsTheToken) {
  for (const char* path : {"/session", "/report", "/health", "/picture/7", "/tiles/5/17/11"}) {
    EXPECT_EQ(ask(path).status, 403U) << path;
    EXPECT_NE(ask(std::string(path) + "?token=secret").status, 403U) << path;
    EXPECT_EQ(ask(std::string(path) + "?token=secret", Method::kPost).status, 405U) << path;
  }
  EXPECT_EQ(ask("/stop", Method::kPost).status, 403U);
  EXPECT_EQ(stops_, 0);
}

TEST_F(RoutesOfAFolder, StopIsPostedAndStops) {
  EXPECT_EQ(ask("/stop?token=secret").status, 405U) << "following a link stops nothing";
  EXPECT_EQ(stops_, 0);
  EXPECT_EQ(ask("/stop?token=secret", Method::kPost).status, 200U);
  EXPECT_EQ(stops_, 1);
}

TEST_F(RoutesOfAFolder, PagesOfOtherSitesGetNothing) {
  request_.origin = "http://evil.example";
  EXPECT_EQ(ask("/report?token=secret").status, 403U);
  EXPECT_EQ(ask("/stop?token=secret", Method::kPost).status, 403U);
  EXPECT_EQ(stops_, 0);
  request_.origin = "";
  request_.host = "evil.example:8642";
  for (const char* target : {"/?token=secret", "/icon.svg", "/session?token=secret"})
    EXPECT_EQ(ask(target).status, 421U) << target;
}

TEST_F(RoutesOfAFolder, PicturesAreAskedByRevision) {
  EXPECT_EQ(body(ask("/picture/7?token=secret")), "PNG");
  EXPECT_EQ(ask("/picture/7?token=secret").content_type, "image/png");
  for (const char* path : {"/picture/8", "/picture/", "/picture/-7", "/picture/7x", "/picture/../7",
                           "/picture/99999999999999999999999"})
    EXPECT_EQ(ask(std::string(path) + "?token=secret").status, 404U) << path;
}

TEST_F(RoutesOfAFolder, TilesAreAskedBySquareWhereThereAreAny) {
  EXPECT_EQ(body(ask("/tiles/5/17/11?token=secret")), "RIFF");
  EXPECT_EQ(ask("/tiles/5/17/11?token=secret").content_type, "image/webp");
  for (const char* path :
       {"/tiles/", "/tiles/5", "/tiles/5/17", "/tiles/5/17/", "/tiles/5/17/11/", "/tiles/5/17/11/1",
        "/tiles/5//11", "/tiles/-5/17/11", "/tiles/5/17/4294967307", "/tiles/a/b/c", "/tiles/6/17/11"})
    EXPECT_EQ(ask(std::string(path) + "?token=secret").status, 404U) << path;
  handlers_.tile = {};
  EXPECT_EQ(ask("/tiles/5/17/11?token=secret").status, 404U);
}

TEST_F(RoutesOfAFolder, ASessionIsAnUpgradeAndNothingElse) {
  EXPECT_EQ(ask("/session?token=secret").status, 426U);
  request_.is_upgrade = true;
  EXPECT_EQ(ask("/session?token=secret").status, 101U);
  EXPECT_EQ(ask("/session").status, 403U);
}

TEST_F(RoutesOfAFolder, EveryAnswerForbidsFramesGuessesAndTellingTheAddressOn) {
  for (const char* target :
       {"/?token=secret", "/", "/nothing", "/assets/index-1a2b.js", "/report?token=secret"}) {
    const HttpResponse response = ask(target);
    EXPECT_EQ(field(response, "X-Content-Type-Options"), "nosniff") << target;
    EXPECT_EQ(field(response, "Referrer-Policy"), "no-referrer") << target;
    const std::string policy = field(response, "Content-Security-Policy");
    EXPECT_NE(policy.find("default-src 'none'; script-src 'self';"), std::string::npos) << target;
    EXPECT_NE(policy.find("frame-ancestors 'none'"), std::string::npos) << target;
    EXPECT_NE(policy.find("connect-src 'self' ws://127.0.0.1:8642;"), std::string::npos) << target;
  }
}

TEST(Routes, WithoutWebFilesThePageSaysSo) {
  const Routes routes(Access("secret", {"127.0.0.1", "", 80, false}), WebFiles::read("/nowhere"));
  HttpRequest request;
  request.target = "/?token=secret";
  request.host = "localhost";
  const HttpResponse response = routes.answer(request, {});
  EXPECT_EQ(response.status, 503U);
  EXPECT_NE(response.body->find("not installed"), std::string::npos);
}

}  // namespace
}  // namespace mlab::console
