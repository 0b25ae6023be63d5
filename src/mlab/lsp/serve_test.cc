// The loop, over pipes: what is asked is answered while the faults of a text are looked for.

#include <unistd.h>

#include <array>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lsp/framing.h"
#include "mlab/lsp/server.h"

namespace mlab::lsp {
namespace {

using Json = nlohmann::json;

/// An editor that talks to a server on a thread of its own.
class Editor {
 public:
  Editor() {
    EXPECT_EQ(::pipe(pipe_.data()), 0);
    thread_ = std::thread([this] {
      status_ =
          serve({"1", {}, base::source_folder() + "/library"}, pipe_[0], [this](std::string_view bytes) {
            const std::scoped_lock lock(mutex_);
            reader_.add(bytes);
            while (const auto message = reader_.next()) got_.push_back(Json::parse(message->body));
            comes_.notify_one();
            return true;
          });
    });
  }
  ~Editor() {
    if (thread_.joinable()) end();
    ::close(pipe_[0]);
  }
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  void tell(const std::string& method, const Json& params) {
    write({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
  }
  void ask(int id, const std::string& method, const Json& params) {
    write({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}});
  }
  /// The next message that the server sends.
  Json next() {
    std::unique_lock lock(mutex_);
    comes_.wait(lock, [this] { return !got_.empty(); });
    Json out = std::move(got_.front());
    got_.pop_front();
    return out;
  }
  void initialize() {
    ask(1, "initialize", {{"processId", nullptr}, {"rootUri", nullptr}, {"capabilities", Json::object()}});
    EXPECT_EQ(next()["id"], 1);
  }
  void open(const std::string& uri, const std::string& text) {
    tell("textDocument/didOpen",
         {{"textDocument", {{"uri", uri}, {"languageId", "cdl"}, {"version", 1}, {"text", text}}}});
  }
  /// No more is written. @return  the server's exit status
  int end() {
    ::close(pipe_[1]);
    thread_.join();
    return status_;
  }

 private:
  void write(const Json& message) const {
    const std::string bytes = framed(message.dump());
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t n = ::write(pipe_[1], bytes.data() + done, bytes.size() - done);
      ASSERT_GT(n, 0);
      done += static_cast<std::size_t>(n);
    }
  }

  std::array<int, 2> pipe_{};
  std::thread thread_;
  int status_ = -1;
  std::mutex mutex_;
  std::condition_variable comes_;
  MessageReader reader_;
  std::deque<Json> got_;
};

constexpr const char* kLarge = "file:///folder/large.cdl";

// Takes some hundred milliseconds to check.
std::string large_text() {
  std::string out = "assemblage Base() -> Vector {\n  Wander();\n}\n";
  for (int i = 0; i < 3000; ++i)
    out += "assemblage A" + std::to_string(i) +
           "() -> Vector {\n  cooperate {\n    Base();\n    Noise();\n  }\n}\n";
  return out + "assemblage Wrong() -> Vector {\n  Nothing_of_this_name();\n}\n";
}

Json edit_at_the_end(int version) {
  return {
      {"textDocument", {{"uri", kLarge}, {"version", version}}},
      {"contentChanges",
       {{{"range", {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 0}, {"character", 0}}}}},
         {"text", "\n"}}}}};
}

TEST(Serve, AnswersWhileFaultsAreLookedFor) {
  Editor editor;
  editor.initialize();
  editor.open(kLarge, large_text());
  std::this_thread::sleep_for(std::chrono::milliseconds(60));  // the check has begun
  for (int id = 2; id < 6; ++id) {
    editor.ask(id, "textDocument/hover",
               {{"textDocument", {{"uri", kLarge}}}, {"position", {{"line", 1}, {"character", 4}}}});
  }
  int answers = 0;
  bool has_faults = false;
  while (answers < 4 || !has_faults) {
    const Json one = editor.next();
    if (one.contains("id")) {
      EXPECT_EQ(one["id"], 2 + answers++);
    } else if (one["method"] == "textDocument/publishDiagnostics") {
      has_faults = true;
      ASSERT_EQ(one["params"]["diagnostics"].size(), 1U);
      EXPECT_EQ(one["params"]["version"], 1);
    }
  }
}

TEST(Serve, TellsOnlyOfTheTextAsItStands) {
  Editor editor;
  editor.initialize();
  editor.open(kLarge, large_text());
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  for (int version = 2; version < 5; ++version)
    editor.tell("textDocument/didChange", edit_at_the_end(version));
  const Json told = editor.next();
  ASSERT_EQ(told["method"], "textDocument/publishDiagnostics");
  const int version = told["params"]["version"];
  EXPECT_TRUE(version == 4 || version == 1) << "1: the first check was done sooner than the changes came";
}

TEST(Serve, DoesNotAnswerWhatIsCancelled) {
  Editor editor;
  editor.initialize();
  editor.open(kLarge, large_text());
  const Json at_noise = {{"textDocument", {{"uri", kLarge}}},
                         {"position", {{"line", 0}, {"character", 13}}},
                         {"newName", "Other"}};
  // While the first is answered, which takes some hundred milliseconds, both are cancelled.
  editor.ask(2, "textDocument/rename", at_noise);
  editor.ask(3, "textDocument/rename", at_noise);
  editor.tell("$/cancelRequest", {{"id", 3}});
  editor.tell("$/cancelRequest", {{"id", "of nobody"}});
  editor.ask(4, "textDocument/hover", at_noise);
  int answers = 0;
  while (answers < 3) {
    const Json one = editor.next();
    if (!one.contains("id")) continue;
    EXPECT_EQ(one["id"], 2 + answers++);
    if (one["id"] == 2) {
      EXPECT_TRUE(one.contains("result")) << one;
    }
    if (one["id"] == 3) {
      EXPECT_EQ(one["error"]["code"], -32800) << one;
    }
    if (one["id"] == 4) {
      EXPECT_TRUE(one.contains("result")) << one;
    }
  }
}

TEST(Serve, EndsWhileFaultsAreLookedFor) {
  Editor editor;
  editor.initialize();
  editor.open(kLarge, large_text());
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_EQ(editor.end(), 1) << "without `exit`";
}

}  // namespace
}  // namespace mlab::lsp
