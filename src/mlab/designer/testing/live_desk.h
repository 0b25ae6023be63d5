#pragma once

#include <chrono>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/console/testing/browser.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/designer.h"
#include "mlab/designer/testing/whole_text.h"
#include "mlab/documents/testing/scratch_project.h"

namespace mlab::designer::testing {

/// A designer and the session in which its configurations run, as `mlab edit` puts them together, on a
/// project of their own; one person at both.
class LiveDesk {
 public:
  explicit LiveDesk(double speed = 100.0)
      : session_("", speed, [this](console::SessionSettings& s) { s.project_folder = project(); }),
        browser_(session_, "Anna") {
    DesignerSettings settings;
    settings.project_folder = project();
    settings.example_folder = base::source_folder() + "/missions";
    settings.include_root = base::source_folder() + "/src";
    settings.permission = cell::testing::code_permitted();
    settings.version = "test";
    settings.try_out = [this](console::Trial trial, console::TrialDone done) {
      session_->try_out(std::move(trial), std::move(done));
    };
    settings.look_at_run = [this](console::RunLook look) { session_->look_at_run(std::move(look)); };
    designer_ =
        std::make_unique<Designer>(std::move(settings), [this](console::ConnectionId, const auto& bytes) {
          FromDesigner message;
          ASSERT_TRUE(message.ParseFromString(*bytes));
          const std::scoped_lock lock(mutex_);
          if (message.has_answer()) answers_[message.answer().request()] = message.answer();
          if (message.has_document()) documents_[message.document().path()] = message.document();
          if (message.has_drawing()) drawings_[message.drawing().page().path()] = message.drawing();
          if (message.has_marks()) marks_[message.marks().document()] = message.marks();
          arrived_.notify_all();
        });
    ask([](ToDesigner& m) { m.mutable_greeting()->set_protocol(1); });
    EXPECT_TRUE(browser_.wait([&] { return browser_.clients().operator_() == 1; }));
  }
  LiveDesk(const LiveDesk&) = delete;
  LiveDesk& operator=(const LiveDesk&) = delete;

  Answer ask(const std::function<void(ToDesigner&)>& fill) {
    auto message = std::make_unique<ToDesigner>();
    const std::uint32_t request = ++last_request_;
    message->set_request(request);
    fill(*message);
    designer_->receive({1}, std::move(message));
    std::unique_lock lock(mutex_);
    arrived_.wait_for(lock, std::chrono::seconds(120), [&] { return answers_.contains(request); });
    return answers_[request];
  }
  /// Without waiting for an answer.
  void tell(const std::function<void(ToDesigner&)>& fill) {
    auto message = std::make_unique<ToDesigner>();
    fill(*message);
    designer_->receive({1}, std::move(message));
  }
  /// Opens a new document with this text, which is in no file.
  std::string write(const std::string& text) {
    const std::string path = open("");
    type(path, text);
    return path;
  }
  std::string open(const std::string& path) {
    const Answer answer = ask([&](ToDesigner& m) { m.mutable_open()->set_path(path); });
    EXPECT_TRUE(answer.ok()) << answer.error();
    return answer.text();
  }
  void type(const std::string& path, const std::string& text) {
    const Document now = document(path);
    const Answer answer = ask([&](ToDesigner& m) { *m.mutable_edit_text() = whole_text(now, text); });
    EXPECT_TRUE(answer.ok()) << answer.error();
  }
  Document document(const std::string& path) {
    const std::scoped_lock lock(mutex_);
    return documents_[path];
  }
  /// As they are after everything that was asked so far.
  MarkList marks(const std::string& document) {
    ask([](ToDesigner& m) { m.mutable_list_files(); });
    const std::scoped_lock lock(mutex_);
    return marks_[document];
  }
  Drawing drawing(const std::string& document, const std::string& page) {
    ask([&](ToDesigner& m) {
      Page& one = *m.mutable_look()->add_pages();
      one.set_document(document);
      one.set_path(page);
    });
    const std::scoped_lock lock(mutex_);
    return drawings_[page];
  }
  Answer try_out(const std::string& document, const std::string& what = "", std::uint32_t count = 1,
                 const std::function<void(Try&)>& more = {}) {
    return ask([&](ToDesigner& m) {
      Try& request = *m.mutable_try_();
      request.set_document(document);
      request.set_robot(what);
      request.set_count(count);
      request.set_execute(true);
      if (more) more(request);
    });
  }
  /// @param programs  of robots that nobody has tried here
  std::vector<std::string> live(const std::string& document, const std::string& page,
                                const std::vector<std::string>& programs = {}) {
    const Answer answer = ask([&](ToDesigner& m) {
      m.mutable_find_live()->set_document(document);
      m.mutable_find_live()->set_page(page);
      for (const std::string& program : programs) m.mutable_find_live()->add_programs(program);
    });
    std::vector<std::string> out;
    for (const LivePaths::At& at : answer.live().places()) out.push_back(at.program() + ":" + at.path());
    return out;
  }

  struct Arrow {
    float x, y, dx, dy;
  };
  Answer field(const std::string& document, const std::string& page, const std::string& node,
               std::uint32_t robot, std::vector<Arrow>* arrows) {
    const Answer answer = ask([&](ToDesigner& m) {
      ReadField& request = *m.mutable_read_field();
      request.set_document(document);
      request.set_page(page);
      request.set_node(node);
      request.set_robot(robot);
      request.mutable_area()->set_x_min(20.0);
      request.mutable_area()->set_y_min(20.0);
      request.mutable_area()->set_x_max(140.0);
      request.mutable_area()->set_y_max(100.0);
      request.set_columns(13);
      request.set_rows(9);
    });
    const std::string& bytes = answer.field().arrows();
    if (arrows != nullptr) {
      arrows->resize(bytes.size() / sizeof(Arrow));
      std::memcpy(arrows->data(), bytes.data(), arrows->size() * sizeof(Arrow));
    }
    return answer;
  }

  /// In the session.
  console::testing::Browser& browser() { return browser_; }
  bool runs_until(double time) {
    return browser_.wait([&] { return browser_.status().time() >= time; }, 120.0);
  }
  documents::testing::ScratchProject& folder() { return folder_; }

 private:
  std::string project() const { return folder_.path("project").string(); }

  documents::testing::ScratchProject folder_;
  console::testing::TestSession session_;
  console::testing::Browser browser_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::map<std::uint32_t, Answer> answers_;
  std::map<std::string, Document> documents_;
  std::map<std::string, Drawing> drawings_;
  std::map<std::string, MarkList> marks_;
  std::uint32_t last_request_ = 0;
  std::unique_ptr<Designer> designer_;  // ends first
};

}  // namespace mlab::designer::testing
