#include "mlab/console/server/access.h"

#include <gtest/gtest.h>

namespace mlab::console {
namespace {

const Access kLocal("secret", {"127.0.0.1", "robot-lab", 8642, false});
const Access kOpen("secret", {"0.0.0.0", "Robot-Lab", 8642, false});
const Access kEncrypted("secret", {"0.0.0.0", "robot-lab", 443, true});

TEST(Access, ALocalServerGoesByTheNamesOfThisMachine) {
  for (const char* host :
       {"127.0.0.1:8642", "localhost:8642", "LOCALHOST:8642", "[::1]:8642", "127.0.1.1:8642"})
    EXPECT_TRUE(kLocal.is_for_us(host)) << host;
}

TEST(Access, ADomainThatLeadsHereIsNotOurs) {
  for (const char* host :
       {"", ":8642", "evil.example:8642", "127.0.0.1.evil.example:8642", "localhost.evil.example:8642",
        "127.evil.example:8642", "192.168.1.5:8642", "robot-lab:8642", "[", "]", "[::1", "[]:8642",
        "localhost:8643", "localhost", "127.0.0.1:", "127.0.0.1:8642:8642"})
    EXPECT_FALSE(kLocal.is_for_us(host)) << host;
}

TEST(Access, AnOpenServerGoesByAddressesAndTheMachinesName) {
  for (const char* host :
       {"192.168.1.5:8642", "[fe80::1]:8642", "robot-lab:8642", "robot-lab.local:8642", "localhost:8642"})
    EXPECT_TRUE(kOpen.is_for_us(host)) << host;
  for (const char* host :
       {"evil.example:8642", "robot-lab.evil.example:8642", "192.168.1.5.evil.example:8642", ":8642"})
    EXPECT_FALSE(kOpen.is_for_us(host)) << host;
}

TEST(Access, ACertificateIsProofOfAnyName) {
  EXPECT_TRUE(kEncrypted.is_for_us("lab.example.org"));
  EXPECT_TRUE(kEncrypted.is_for_us("lab.example.org:443"));
  EXPECT_FALSE(kEncrypted.is_for_us("lab.example.org:80"));
}

TEST(Access, OnlyOurOwnPagesAreFromUs) {
  HttpRequest request;
  request.host = "127.0.0.1:8642";
  EXPECT_TRUE(kLocal.is_from_us(request)) << "no page at all";
  request.origin = "http://127.0.0.1:8642";
  EXPECT_TRUE(kLocal.is_from_us(request));
  for (const char* origin : {"null", "http://localhost:8642", "https://127.0.0.1:8642", "http://127.0.0.1:80",
                             "http://127.0.0.1:86420", "http://evil.example", "http://127.0.0.1"}) {
    request.origin = origin;
    EXPECT_FALSE(kLocal.is_from_us(request)) << origin;
  }
  request.origin = "";
  request.fetch_site = "cross-site";
  EXPECT_FALSE(kLocal.is_from_us(request));
  request.fetch_site = "same-site";
  EXPECT_FALSE(kLocal.is_from_us(request)) << "another port of this machine";
  request.fetch_site = "same-origin";
  EXPECT_TRUE(kLocal.is_from_us(request));
}

TEST(Access, TheTokenStandsInTheAddressOrTheHeader) {
  const auto is_known = [](std::string_view target, std::string_view authorization = "") {
    HttpRequest request;
    request.target = target;
    request.authorization = authorization;
    return kLocal.has_token(request);
  };
  EXPECT_TRUE(is_known("/?token=secret"));
  EXPECT_TRUE(is_known("/x?a=b&token=secret&c"));
  EXPECT_TRUE(is_known("/", "Bearer secret"));
  EXPECT_TRUE(is_known("/", "bearer secret")) << "a scheme's letter case says nothing (RFC 9110, 11.1)";
  for (const char* target :
       {"/", "/?", "/?token", "/?token=", "/?token=Secret", "/?token=secret1", "/?token=secre",
        "/?xtoken=secret", "/?token=wrong&token=secret", "/?TOKEN=secret", "/token=secret", "?&&=&"})
    EXPECT_FALSE(is_known(target)) << target;
  EXPECT_FALSE(is_known("/", "Bearer "));
  EXPECT_FALSE(is_known("/", "Basic secret"));
  EXPECT_FALSE(is_known("/?token=secret", "Bearer wrong")) << "the header counts where there is one";
}

}  // namespace
}  // namespace mlab::console
