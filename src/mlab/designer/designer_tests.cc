// Tests of components: listed, run, written, and shown cycle by cycle.

#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/component_tests/first_test.h"
#include "mlab/designer/component_tests/test_runs.h"
#include "mlab/designer/designer_parts.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

// Between two looks at all files of the project [s]: while somebody types, and otherwise.
constexpr double kTypingPause = 0.3;
constexpr double kTestFilesPause = 2.0;

}  // namespace

// What tests are looked for in: the project as it stands, and what is open besides.
void Designer::Parts::look_at_tests(bool is_at_once) {
  if (!tests_->is_watched()) return;
  std::string stamp;
  for (const OpenConfiguration* one : desk_.all())
    stamp += fmt::format("{} {}\n", one->path, one->model_number);
  const double since = now() - last_test_look_;
  const bool is_due = stamp == tests_stamp_ ? since > kTestFilesPause : since > kTypingPause;
  if (!is_due && !is_at_once) return;
  last_test_look_ = now();
  tests_stamp_ = std::move(stamp);
  TestTexts texts;
  std::set<std::string> names;
  const auto add = [&](const text::SourcePtr& source) {
    if (names.insert(source->name()).second) texts.sources.push_back(source);
  };
  for (const OpenConfiguration* one : desk_.all()) add(one->model->source());
  for (const language::Text& text : texts_.all()) add(text.source);
  texts.files = desk_.store().snapshot();
  tests_->look(std::move(texts));
}

void Designer::Parts::watch_tests(console::ConnectionId from, const WatchTests& request, Answer& out) {
  if (request.is_wanted() && opened(request.document(), out) == nullptr) return;
  tests_->watch(from, request.document(), request.is_wanted());
  look_at_tests(true);
}

void Designer::Parts::run_tests(const RunTests& request) {
  look_at_tests(true);
  const auto document_of = [this](std::string_view source) { return desk_.document_of(source); };
  std::vector<TestRuns::Key> tests;
  for (const TestName& test : request.tests()) {
    const std::string source = tests_->source_of(test, document_of);
    if (!source.empty()) tests.emplace_back(source, test.name());
  }
  tests_->run(tests);
}

void Designer::Parts::show_test_cycle(console::ConnectionId from, std::uint32_t number,
                                      const ShowTestCycle& request, Answer& out) {
  const OpenConfiguration* page = opened(request.document(), out);
  if (page == nullptr) return;
  look_at_tests(true);
  const std::string source =
      tests_->source_of(request.test(), [this](std::string_view one) { return desk_.document_of(one); });
  is_deferred_ = true;
  tests_->show(fmt::format("{}", from.value), {source, request.test().name()}, request.cycle(),
               {page->drawn->source()->name(), request.page()},
               [this, from, number](const text::Result<TestCycle>& shown) {
                 FromDesigner message;
                 Answer& answer = *message.mutable_answer();
                 answer.set_request(number);
                 answer.set_ok(true);
                 if (shown)
                   *answer.mutable_test_cycle() = *shown;
                 else
                   fail(answer, shown.error());
                 if (number != 0) answers_.emplace_back(from, std::move(message));
               });
}

void Designer::Parts::add_test(const AddTest& request, Answer& out) {
  OpenConfiguration* one = editable(request.document(), out);
  if (one == nullptr) return;
  if (one->is_outdated()) {
    out.set_ok(false);
    out.set_error("the text has a slip of grammar: mend it first");
    return;
  }
  const text::Result<std::string> test = first_test_of(*one->model, request.component());
  if (!test) {
    fail(out, test.error());
    return;
  }
  const std::string_view text = one->text.text();
  if (text.size() + test->size() + 2 > text::Source::kMaxBytes) {
    out.set_ok(false);
    out.set_error("the text would be too long");
    return;
  }
  std::string added = text.empty() ? "" : text.ends_with('\n') ? "\n" : "\n\n";
  const auto end = static_cast<std::uint32_t>(text.size());
  const auto begin = static_cast<std::uint32_t>(text.size() + added.size());
  added += *test;
  desk_.store().change({{one, {{end, end}, added}}}, "new test", now(), false);
  desk_.changed(*one);
  Location& at = *out.mutable_location();
  at.set_document(one->path);
  at.set_begin(begin);
  at.set_end(begin + static_cast<std::uint32_t>(test->size()) - 1);
}

void Designer::Parts::publish_tests(console::ConnectionId to, Client& client) {
  for (const std::string& path : client.documents) {
    const OpenConfiguration* one = desk_.find(path);
    if (one == nullptr || !tests_->is_watched_by(to, path)) continue;
    const std::string version = fmt::format("{}", tests_->number());
    if (std::exchange(client.sent["seen tests " + path + ' '], version) == version) continue;
    FromDesigner message;
    *message.mutable_tests() =
        tests_->list(path, one->model->source()->name(),
                     [this](std::string_view source) { return desk_.document_of(source); });
    send_once(to, client, "tests " + path + ' ', message);
  }
}

}  // namespace mlab::designer
