#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "mlab/console/inbox.h"
#include "mlab/designer/component_tests/test_runs.h"
#include "mlab/designer/session/answers.h"
#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/request.h"
#include "mlab/project/project_texts.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::designer {

/// Tests of components: listed, run, written, and shown cycle by cycle.
class TestOrders {
 public:
  /// @param texts     that tests are looked for in, besides what is open
  /// @param inbox     where what came of them is posted
  /// @param programs  as TestRuns
  TestOrders(Desk& desk, project::ProjectTexts& texts, Answers& answers,
             std::shared_ptr<console::Inbox> inbox, const robot::ProgramSources& programs);

  void watch(const Sender& sender, const WatchTests& request, Answer& out);
  void run(const RunTests& request);
  Answered show_cycle(const Sender& sender, const ShowTestCycle& request, Answer& out);
  void add(const AddTest& request, Answer& out);

  void leave(console::ConnectionId connection) { tests_.close(connection); }
  /// Looks for tests anew where something has changed, though not with every letter that is typed.
  void follow();

  // ---- for whoever tells of them

  bool is_watched_by(console::ConnectionId who, const std::string& document) const {
    return tests_.is_watched_by(who, document);
  }
  /// Grows when something in a list is otherwise.
  std::uint64_t number() const { return tests_.number(); }
  TestList list(const OpenConfiguration& document) const;

 private:
  /// What tests are looked for in: the project as it stands, and what is open besides.
  TestTexts texts();
  /// What somebody asks about now is of the texts as they stand.
  void follow_at_once();
  /// Of what is open.
  std::string stamp();
  void look(std::string stamp);
  std::function<std::string(std::string_view source)> document_of() const;

  Desk& desk_;
  project::ProjectTexts& texts_;
  Answers& answers_;
  TestRuns tests_;     // posts to the inbox
  std::string stamp_;  // when tests were looked for
  double last_look_ = 0.0;
};

}  // namespace mlab::designer
