// Any messages from a browser to a session with a small mission. Each is preceded by its length, in two
// bytes, little endian. Whatever they are, the session answers the next browser, and no file outside of its
// project is shown.

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include <google/protobuf/stubs/logging.h>

#include "mlab/console.pb.h"
#include "mlab/console/session.h"

namespace {

namespace fs = std::filesystem;
using namespace mlab::console;

constexpr std::string_view kSecret = "what no browser may read";
constexpr ConnectionId kStranger{1};
constexpr ConnectionId kNext{2};

void fail(const char* why) {
  std::fprintf(stderr, "%s\n", why);
  std::abort();
}

// A project with a mission, and a secret beside it; as it was before for each input.
fs::path fresh_project() {
  static const fs::path kFolder =
      fs::temp_directory_path() / ("mlab_console_fuzz_" + std::to_string(::getpid()));
  fs::remove_all(kFolder);
  fs::create_directories(kFolder / "project");
  std::ofstream(kFolder / "secret.odl") << "-- " << kSecret << "\n";
  std::ofstream(kFolder / "project" / "map.odl") << "SITE Fuzz\nMISSION-AREA 200 200\nCONTROL MEASURES:\nPP "
                                                    "Here 50 50\nPP There 150 50\nOBSTACLE 100 60 3\n"
                                                    "BOUNDARY Field 5 5 140 5 140 100 60 195 5 100 5 5\n";
  std::ofstream(kFolder / "project" / "m.mdl")
      << "MISSION NAME Fuzz\nOVERLAY map.odl\nFAILSAFE OUTSIDE Field REVERSE INSIDE\n"
         "FAILSAFE LINK-LOST AFTER 2 RETURN\nFAILSAFE STUCK AFTER 3 HOLD\nFAILSAFE IN-CONTACT STOP\nUNIT <u> "
         "ROBOT ROBOT\nCOMMAND LIST:\n0. UNIT u START Here 0 "
         "10\n"
         "1. UNIT u MOVETO There\n2. UNIT u OCCUPY There\n3. UNIT u TELEOPERATE There\n";
  return kFolder / "project";
}

// What a session sends.
class Mail {
 public:
  void take(ConnectionId to, const std::string& bytes) {
    if (bytes.find(kSecret) != std::string::npos) fail("a file outside of the project was read");
    ToBrowser message;
    if (!message.ParseFromString(bytes)) fail("the session sent what is no message");
    if (to != kNext || !message.has_welcome()) return;
    const std::scoped_lock lock(mutex_);
    is_welcome_ = true;
    arrived_.notify_all();
  }
  bool await_welcome() {
    std::unique_lock lock(mutex_);
    return arrived_.wait_for(lock, std::chrono::seconds(8), [this] { return is_welcome_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  bool is_welcome_ = false;
};

std::unique_ptr<ToServer> hello() {
  auto message = std::make_unique<ToServer>();
  message->mutable_hello()->set_protocol(1);
  return message;
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  static const auto kLog = google::protobuf::SetLogHandler(nullptr);
  static_cast<void>(kLog);
  SessionSettings settings;
  settings.project_folder = fresh_project().string();
  settings.mission = settings.project_folder + "/m.mdl";
  settings.version = "fuzz";
  settings.speed = 0.0;
  Mail mail;
  {
    Session session(settings, [&](ConnectionId to, const std::shared_ptr<const std::string>& bytes) {
      mail.take(to, *bytes);
    });
    session.receive(kStranger, hello());
    for (std::size_t at = 0; at + 2 <= size;) {
      const std::size_t length = std::min<std::size_t>(data[at] + 256U * data[at + 1], size - at - 2);
      auto message = std::make_unique<ToServer>();
      if (message->ParseFromArray(data + at + 2, static_cast<int>(length)))
        session.receive(kStranger, std::move(message));
      at += 2 + length;
    }
    session.closed(kStranger);
    session.receive(kNext, hello());
    if (!mail.await_welcome()) fail("the session does not answer");
    session.report();
  }
  return 0;
}
