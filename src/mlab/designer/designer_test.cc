#include "mlab/designer/designer.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/designer.pb.h"

namespace mlab::designer {
namespace {

namespace fs = std::filesystem;

/// A designer on a folder of its own, and one browser.
class Browser {
 public:
  explicit Browser(const std::string& name) : folder_(fs::temp_directory_path() / ("mlab_designer_" + name)) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "project");
    start();
  }
  ~Browser() {
    designer_.reset();
    fs::remove_all(folder_);
  }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  void start(const std::string& open = "") {
    designer_.reset();
    DesignerSettings settings;
    settings.project_folder = (folder_ / "project").string();
    settings.example_folder = std::string(MLAB_SOURCE_DIR) + "/missions";
    settings.state_folder = (folder_ / "state").string();
    settings.open = open;
    designer_ = std::make_unique<Designer>(settings, [this](console::ConnectionId to, const auto& bytes) {
      FromDesigner message;
      ASSERT_TRUE(message.ParseFromString(*bytes));
      const std::scoped_lock lock(mutex_);
      take(to.value, std::move(message));
      arrived_.notify_all();
    });
    greet(1);
  }
  void greet(std::uint32_t who) {
    ask([](ToDesigner& m) { m.mutable_greeting()->set_protocol(1); }, who);
  }

  Answer ask(const std::function<void(ToDesigner&)>& fill, std::uint32_t who = 1) {
    auto message = std::make_unique<ToDesigner>();
    const std::uint32_t request = ++last_request_;
    message->set_request(request);
    fill(*message);
    designer_->receive({who}, std::move(message));
    std::unique_lock lock(mutex_);
    arrived_.wait_for(lock, std::chrono::seconds(60), [&] { return answers_.contains(request); });
    return answers_[request];
  }
  std::string open(const std::string& path, std::uint32_t who = 1) {
    const Answer answer = ask([&](ToDesigner& m) { m.mutable_open()->set_path(path); }, who);
    return answer.ok() ? answer.text() : "error: " + answer.error();
  }
  Document document(const std::string& path, std::uint32_t who = 1) {
    const std::scoped_lock lock(mutex_);
    return documents_[{who, path}];
  }
  bool waits_for(const std::function<bool()>& what) {
    std::unique_lock lock(mutex_);
    return arrived_.wait_for(lock, std::chrono::seconds(60), what);
  }
  /// Only under `waits_for`.
  const Document& seen(const std::string& path, std::uint32_t who = 1) { return documents_[{who, path}]; }
  Drawing drawing(const std::string& page) {
    const std::scoped_lock lock(mutex_);
    return drawings_[page];
  }
  const Hello& hello() const { return hello_; }
  std::vector<FileChanged> changed() {
    const std::scoped_lock lock(mutex_);
    return changed_;
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / "project" / name) << text;
  }
  std::string read(const std::string& name) {
    std::ifstream in(folder_ / "project" / name);
    std::stringstream out;
    out << in.rdbuf();
    return out.str();
  }
  void type(const std::string& path, const std::string& text) {
    const Document now = document(path);
    const Answer answer = ask([&](ToDesigner& m) {
      m.mutable_edit_text()->set_document(path);
      m.mutable_edit_text()->set_revision(now.revision());
      m.mutable_edit_text()->set_end(static_cast<std::uint32_t>(now.text().size()));
      m.mutable_edit_text()->set_text(text);
    });
    ASSERT_TRUE(answer.ok()) << answer.error();
  }

 private:
  void take(std::uint32_t who, FromDesigner message) {
    if (message.has_answer()) answers_[message.answer().request()] = message.answer();
    if (message.has_hello()) hello_ = message.hello();
    if (message.has_document()) documents_[{who, message.document().path()}] = message.document();
    if (message.has_drawing()) drawings_[message.drawing().page().path()] = message.drawing();
    if (message.has_file_changed()) changed_.push_back(message.file_changed());
  }

  fs::path folder_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::map<std::uint32_t, Answer> answers_;
  std::map<std::pair<std::uint32_t, std::string>, Document> documents_;
  std::map<std::string, Drawing> drawings_;
  std::vector<FileChanged> changed_;
  Hello hello_;
  std::uint32_t last_request_ = 0;
  std::unique_ptr<Designer> designer_;
};

constexpr const char* kText = "assemblage A() {\n  cooperate {\n    1: Noise();\n  }\n}\n";

TEST(Designer, GreetsWithWhatThereIsToOpen) {
  Browser browser("greets");
  browser.write("a.cdl", kText);
  browser.greet(2);
  ASSERT_EQ(browser.hello().files_size(), 1);
  EXPECT_EQ(browser.hello().files(0).path(), "a.cdl");
  EXPECT_GE(browser.hello().examples_size(), 1);
}

TEST(Designer, ShowsPagesAndWhatIsDrawnOnThem) {
  Browser browser("shows");
  browser.write("a.cdl", kText);
  ASSERT_EQ(browser.open("a.cdl"), "a.cdl");
  browser.ask([](ToDesigner& m) {
    Page& page = *m.mutable_look()->add_pages();
    page.set_document("a.cdl");
    page.set_path("A");
  });
  EXPECT_EQ(browser.drawing("A").nodes_size(), 2);
  const Answer answer = browser.ask([](ToDesigner& m) {
    m.mutable_edit()->set_document("a.cdl");
    Place& place = *m.mutable_edit()->add_changes()->mutable_place();
    place.set_page("A");
    place.set_component("Stand");
    place.set_to_node("cooperate");
    place.set_to_port("members");
  });
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(browser.drawing("A").nodes_size(), 3);
  EXPECT_NE(browser.document("a.cdl").text().find("    Stand();\n"), std::string::npos)
      << browser.document("a.cdl").text();
  EXPECT_EQ(browser.document("a.cdl").undo(), "place Stand");
  browser.ask([](ToDesigner& m) { m.mutable_undo()->set_document("a.cdl"); });
  EXPECT_EQ(browser.document("a.cdl").text(), kText);
  EXPECT_EQ(browser.drawing("A").nodes_size(), 2);
}

TEST(Designer, SharesADocumentAmongWindows) {
  Browser browser("shares");
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.greet(2);
  browser.open("a.cdl", 2);
  browser.type("a.cdl", "// other\n");
  EXPECT_EQ(browser.document("a.cdl", 2).text(), "// other\n");
}

TEST(Designer, KeepsDrawingWhileTheTextHasASlip) {
  Browser browser("slip");
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "assemblage A( {\n");
  const Document document = browser.document("a.cdl");
  EXPECT_TRUE(document.is_outdated());
  EXPECT_GE(document.problems_size(), 1);
  const Answer answer = browser.ask([](ToDesigner& m) {
    m.mutable_edit()->set_document("a.cdl");
    m.mutable_edit()->add_changes()->mutable_remove()->add_nodes("A");
  });
  EXPECT_FALSE(answer.ok());
  EXPECT_EQ(browser.document("a.cdl").text(), "assemblage A( {\n");
}

TEST(Designer, TellsWhatTheCheckerSays) {
  Browser browser("checks");
  browser.write("a.cdl", "assemblage A() {\n  cooperate {\n    1: Noise(persistence = 2 m);\n  }\n}\n");
  browser.open("a.cdl");
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen("a.cdl").problems_size() > 0; }));
  EXPECT_EQ(browser.document("a.cdl").problems(0).node(), "Noise");
}

TEST(Designer, SavesAndRefusesToOverwriteWhatOthersChanged) {
  Browser browser("saves");
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "// mine\n");
  browser.write("a.cdl", "// theirs\n");
  const auto save = [&](bool overwrite) {
    return browser.ask([&](ToDesigner& m) {
      m.mutable_save()->set_document("a.cdl");
      m.mutable_save()->set_overwrite(overwrite);
    });
  };
  EXPECT_FALSE(save(false).ok());
  EXPECT_EQ(browser.read("a.cdl"), "// theirs\n");
  EXPECT_TRUE(save(true).ok());
  EXPECT_EQ(browser.read("a.cdl"), "// mine\n");
  EXPECT_FALSE(browser.document("a.cdl").is_dirty());
}

TEST(Designer, TakesOverAFileThatOthersChanged) {
  Browser browser("disk");
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.write("a.cdl", "// theirs\n");
  ASSERT_TRUE(browser.waits_for([&] { return browser.seen("a.cdl").text() == "// theirs\n"; }));
  EXPECT_FALSE(browser.changed().empty());
}

TEST(Designer, MergesWhatBothChanged) {
  Browser browser("merge");
  browser.write("a.cdl", "// one\n// two\n// three\n");
  browser.open("a.cdl");
  browser.type("a.cdl", "// ONE\n// two\n// three\n");
  browser.write("a.cdl", "// one\n// two\n// three\n// four\n");
  const Answer answer = browser.ask([](ToDesigner& m) {
    m.mutable_reload()->set_document("a.cdl");
    m.mutable_reload()->set_merge(true);
  });
  EXPECT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(browser.document("a.cdl").text(), "// ONE\n// two\n// three\n// four\n");
}

TEST(Designer, BringsBackUnsavedWork) {
  Browser browser("drafts");
  browser.write("a.cdl", kText);
  browser.open("a.cdl");
  browser.type("a.cdl", "// not saved\n");
  const std::string fresh = browser.open("");
  browser.type(fresh, "// new\n");
  browser.start();
  EXPECT_EQ(browser.open("a.cdl"), "a.cdl");
  EXPECT_EQ(browser.document("a.cdl").text(), "// not saved\n");
  EXPECT_TRUE(browser.document("a.cdl").is_dirty());
  EXPECT_EQ(browser.open(fresh), fresh);
  EXPECT_EQ(browser.document(fresh).text(), "// new\n");
  browser.ask([](ToDesigner& m) { m.mutable_undo()->set_document("a.cdl"); });
  EXPECT_EQ(browser.document("a.cdl").text(), kText);
}

TEST(Designer, OpensTheLibraryReadOnlyAndNothingOutside) {
  Browser browser("outside");
  EXPECT_EQ(browser.open("library:assemblages/wander.cdl"), "library:assemblages/wander.cdl");
  EXPECT_TRUE(browser.document("library:assemblages/wander.cdl").is_read_only());
  for (const char* path : {"../a.cdl", "/etc/passwd", "library:../x", "no.cdl", "examples:../../etc/passwd"})
    EXPECT_TRUE(browser.open(path).starts_with("error")) << path;
}

TEST(Designer, SavesANewDocumentUnderAName) {
  Browser browser("names");
  const std::string fresh = browser.open("");
  browser.type(fresh, kText);
  const auto save = [&](const std::string& as) {
    return browser.ask([&](ToDesigner& m) {
      m.mutable_save()->set_document(fresh);
      m.mutable_save()->set_as(as);
    });
  };
  EXPECT_FALSE(save("").ok());
  EXPECT_FALSE(save("../b.cdl").ok());
  const Answer answer = save("b.cdl");
  EXPECT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(browser.read("b.cdl"), kText);
  EXPECT_EQ(browser.document("b.cdl").path(), "b.cdl");
}

TEST(Designer, AnswersNonsense) {
  Browser browser("nonsense");
  EXPECT_FALSE(browser.ask([](ToDesigner& m) { m.mutable_edit()->set_document("x"); }).ok());
  EXPECT_FALSE(browser.ask([](ToDesigner& m) { m.mutable_undo(); }).ok());
  EXPECT_FALSE(browser.ask([](ToDesigner&) {}).ok());
  EXPECT_FALSE(browser.ask([](ToDesigner& m) { m.mutable_edit(); }, 7).ok());
}

}  // namespace
}  // namespace mlab::designer
