#include "mlab/designer/session/test_orders.h"

#include <set>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/designer/component_tests/first_test.h"

namespace mlab::designer {
namespace {

// Between two looks at all files of the project [s]: while somebody types, and otherwise.
constexpr double kTypingPause = 0.3;
constexpr double kTestFilesPause = 2.0;

}  // namespace

TestOrders::TestOrders(Desk& desk, project::ProjectTexts& texts, Answers& answers,
                       std::shared_ptr<console::Inbox> inbox, const robot::ProgramSources& programs)
    : desk_(desk),
      texts_(texts),
      answers_(answers),
      tests_(programs,
             [inbox = std::move(inbox)](std::function<void()> task) { inbox->post(std::move(task)); }) {}

std::function<std::string(std::string_view source)> TestOrders::document_of() const {
  return [this](std::string_view source) { return desk_.document_of(source); };
}

// ---- looking for them

TestTexts TestOrders::texts() {
  TestTexts out;
  std::set<std::string> names;
  const auto add = [&](const text::SourcePtr& source) {
    if (names.insert(source->name()).second) out.sources.push_back(source);
  };
  for (const OpenConfiguration* document : desk_.all()) add(document->model->source());
  for (const assist::Text& text : texts_.all()) add(text.source);
  out.files = desk_.store().snapshot();
  return out;
}

std::string TestOrders::stamp() {
  std::string out;
  for (const OpenConfiguration* document : desk_.all())
    out += fmt::format("{} {}\n", document->path, document->model_number);
  return out;
}

void TestOrders::follow() {
  if (!tests_.is_watched()) return;
  std::string stamp = this->stamp();
  const double pause = stamp == stamp_ ? kTestFilesPause : kTypingPause;
  if (wall_time() - last_look_ > pause) look(std::move(stamp));
}

void TestOrders::follow_at_once() {
  if (tests_.is_watched()) look(stamp());
}

void TestOrders::look(std::string stamp) {
  last_look_ = wall_time();
  stamp_ = std::move(stamp);
  tests_.look(texts());
}

TestList TestOrders::list(const OpenConfiguration& document) const {
  return tests_.list(document.path, document.model->source()->name(), document_of());
}

// ---- what is asked

void TestOrders::watch(const Sender& sender, const WatchTests& request, Answer& out) {
  if (request.is_wanted() && opened(desk_, request.document(), out) == nullptr) return;
  tests_.watch(sender.asker.connection, request.document(), request.is_wanted());
  follow_at_once();
}

void TestOrders::run(const RunTests& request) {
  follow_at_once();
  std::vector<TestRuns::Key> tests;
  for (const TestName& test : request.tests()) {
    const std::string source = tests_.source_of(test, document_of());
    if (!source.empty()) tests.emplace_back(source, test.name());
  }
  tests_.run(tests);
}

Answered TestOrders::show_cycle(const Sender& sender, const ShowTestCycle& request, Answer& out) {
  const OpenConfiguration* page = opened(desk_, request.document(), out);
  if (page == nullptr) return Answered::kNow;
  follow_at_once();
  const std::string source = tests_.source_of(request.test(), document_of());
  tests_.show(fmt::format("{}", sender.asker.connection.value), {source, request.test().name()},
              request.cycle(), {page->drawn->source()->name(), request.page()},
              [this, asker = sender.asker](const text::Result<TestCycle>& shown) {
                Answer answer = answer_for(asker);
                if (shown)
                  *answer.mutable_test_cycle() = *shown;
                else
                  fail(answer, shown.error());
                answers_.add(asker, std::move(answer));
              });
  return Answered::kLater;
}

void TestOrders::add(const AddTest& request, Answer& out) {
  OpenConfiguration* document = editable(desk_, request.document(), out);
  if (document == nullptr) return;
  if (document->is_outdated()) {
    refuse(out, "the text has a slip of grammar: mend it first");
    return;
  }
  const text::Result<std::string> test = first_test_of(*document->model, request.component());
  if (!test) {
    fail(out, test.error());
    return;
  }
  const std::string_view text = document->text.text();
  if (text.size() + test->size() + 2 > text::Source::kMaxBytes) {
    refuse(out, "the text would be too long");
    return;
  }
  std::string added = text.empty() ? "" : text.ends_with('\n') ? "\n" : "\n\n";
  const auto end = static_cast<std::uint32_t>(text.size());
  const auto begin = static_cast<std::uint32_t>(text.size() + added.size());
  added += *test;
  desk_.store().change({{document, {{end, end}, added}}}, "new test", wall_time(), false);
  Location& at = *out.mutable_location();
  at.set_document(document->path);
  at.set_begin(begin);
  at.set_end(begin + static_cast<std::uint32_t>(test->size()) - 1);
}

}  // namespace mlab::designer
