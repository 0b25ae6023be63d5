#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/designer.h"
#include "mlab/designer/testing/whole_text.h"
#include "mlab/documents/testing/scratch_project.h"

namespace mlab::designer::testing {

/// A designer on a folder of its own, and one browser.
class Browser {
 public:
  Browser() { start(); }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  void start(const std::string& open = "") {
    designer_.reset();
    marks_.clear();
    DesignerSettings settings;
    settings.project_folder = folder_.path("project").string();
    settings.example_folder = base::source_folder() + "/missions";
    settings.state_folder = folder_.path("state").string();
    settings.open = open;
    settings.permission = permission_;
    settings.include_root = include_root_;
    designer_ = std::make_unique<Designer>(settings, [this](console::ConnectionId to, const auto& bytes) {
      FromDesigner message;
      ASSERT_TRUE(message.ParseFromString(*bytes));
      const std::scoped_lock lock(mutex_);
      take(to.value, message);
      arrived_.notify_all();
    });
    greet(1);
  }
  /// The C++ of procedures is compiled from now on; for the next `start`.
  void set_include_root(const std::string& folder) { include_root_ = folder; }
  /// Likewise.
  void set_permission(const cell::Permission& permission) { permission_ = permission; }
  void greet(std::uint32_t who) {
    ask([](ToDesigner& m) { m.mutable_greeting()->set_protocol(1); }, who);
  }

  Answer ask(const std::function<void(ToDesigner&)>& fill, std::uint32_t who = 1) {
    return answer_to(send(fill, who));
  }
  /// The number of the request, which may be answered later.
  std::uint32_t send(const std::function<void(ToDesigner&)>& fill, std::uint32_t who = 1) {
    auto message = std::make_unique<ToDesigner>();
    const std::uint32_t request = ++last_request_;
    message->set_request(request);
    fill(*message);
    designer_->receive({who}, std::move(message));
    return request;
  }
  Answer answer_to(std::uint32_t request) {
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
  Palette palette(const std::string& document) {
    const std::scoped_lock lock(mutex_);
    return palettes_[document];
  }
  /// How often that browser has been sent the document.
  std::size_t times_told(const std::string& path, std::uint32_t who = 1) {
    const std::scoped_lock lock(mutex_);
    return times_told_[{who, path}];
  }
  /// As they are after everything that was asked so far.
  MarkList marks(const std::string& document) {
    ask([](ToDesigner& m) { m.mutable_list_files(); });
    const std::scoped_lock lock(mutex_);
    return marks_[document];
  }
  /// As it is after everything that was asked so far.
  Differences differences(const std::string& document) {
    ask([](ToDesigner& m) { m.mutable_list_files(); });
    const std::scoped_lock lock(mutex_);
    return differences_[document];
  }
  PageDifference page_difference(const std::string& page) {
    const std::scoped_lock lock(mutex_);
    return page_differences_[page];
  }
  TestList tests(const std::string& document) {
    const std::scoped_lock lock(mutex_);
    return tests_[document];
  }
  /// Only under `waits_for`.
  const TestList& seen_tests(const std::string& document) { return tests_[document]; }
  std::string folder() const { return folder_.path("project").string(); }
  const Hello& hello() const { return hello_; }
  std::optional<Lists> lists(std::uint32_t who) {
    const std::scoped_lock lock(mutex_);
    const auto found = lists_.find(who);
    return found == lists_.end() ? std::nullopt : std::optional(found->second);
  }
  std::vector<FileChanged> changed(std::uint32_t who) {
    const std::scoped_lock lock(mutex_);
    return changed_[who];
  }
  /// Only under `waits_for`.
  const std::vector<FileChanged>& seen_changes(std::uint32_t who) { return changed_[who]; }

  std::string state_folder() const { return folder_.path("state").string(); }
  std::string project_folder() const { return folder_.path("project").string(); }
  void write(const std::string& name, const std::string& text) { folder_.write("project/" + name, text); }
  std::string read(const std::string& name) const { return folder_.read("project/" + name); }
  void type(const std::string& path, const std::string& text) {
    const Document now = document(path);
    const Answer answer = ask([&](ToDesigner& m) { *m.mutable_edit_text() = whole_text(now, text); });
    ASSERT_TRUE(answer.ok()) << answer.error();
  }

 private:
  void take(std::uint32_t who, const FromDesigner& message) {
    if (message.has_answer()) answers_[message.answer().request()] = message.answer();
    if (message.has_hello()) hello_ = message.hello();
    if (message.has_document()) {
      documents_[{who, message.document().path()}] = message.document();
      ++times_told_[{who, message.document().path()}];
    }
    if (message.has_palette()) palettes_[message.palette().document()] = message.palette();
    if (message.has_drawing()) drawings_[message.drawing().page().path()] = message.drawing();
    if (message.has_marks()) marks_[message.marks().document()] = message.marks();
    if (message.has_differences()) differences_[message.differences().document()] = message.differences();
    if (message.has_page_difference())
      page_differences_[message.page_difference().page().path()] = message.page_difference();
    if (message.has_tests()) tests_[message.tests().document()] = message.tests();
    if (message.has_lists()) lists_[who] = message.lists();
    if (message.has_file_changed()) changed_[who].push_back(message.file_changed());
  }

  documents::testing::ScratchProject folder_;
  std::string include_root_;
  cell::Permission permission_ = cell::testing::code_permitted();
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::map<std::uint32_t, Answer> answers_;
  std::map<std::pair<std::uint32_t, std::string>, Document> documents_;
  std::map<std::pair<std::uint32_t, std::string>, std::size_t> times_told_;
  std::map<std::string, Drawing> drawings_;
  std::map<std::string, Palette> palettes_;
  std::map<std::string, MarkList> marks_;
  std::map<std::string, Differences> differences_;
  std::map<std::string, PageDifference> page_differences_;
  std::map<std::string, TestList> tests_;
  std::map<std::uint32_t, Lists> lists_;
  std::map<std::uint32_t, std::vector<FileChanged>> changed_;
  Hello hello_;
  std::uint32_t last_request_ = 0;
  std::unique_ptr<Designer> designer_;  // ends first
};

}  // namespace mlab::designer::testing
