#include "mlab/designer/component_tests/test_runs.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"
#include "mlab/text/utf8.h"

namespace mlab::designer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongestTest{10};
constexpr std::chrono::milliseconds kBetweenNews{100};

std::unexpected<text::Diagnostic> not_shown(std::string why) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, "no-test-cycle", std::move(why), {}, {}, {}, {}});
}

bool is_same(const std::vector<text::SourcePtr>& a, const std::vector<text::SourcePtr>& b) {
  return std::ranges::equal(a, b, [](const text::SourcePtr& x, const text::SourcePtr& y) {
    return x == y || (x->name() == y->name() && x->text() == y->text());
  });
}

void encode_place(const text::Place& place,
                  const std::function<std::string(std::string_view source)>& document_of, Location& out) {
  if (!place.source) return;
  out.set_document(document_of(place.source->name()));
  out.set_begin(place.span.begin);
  out.set_end(place.span.end);
}

const text::Diagnostic& first_error(const text::Diagnostics& problems) {
  return *std::ranges::find(problems.items(), text::Severity::kError, &text::Diagnostic::severity);
}

}  // namespace

TestRuns::TestRuns(const robot::ProgramSources& programs, Post post)
    : post_(std::move(post)), runs_loaded_(programs), shows_loaded_(programs) {}

TestRuns::~TestRuns() {
  run_ends_.request_stop();
  all_end_.request_stop();
}

void TestRuns::watch(console::ConnectionId who, const std::string& document, bool is_wanted) {
  if (is_wanted) {
    watchers_[who].insert(document);
    ++number_;
    return;
  }
  const auto watcher = watchers_.find(who);
  if (watcher == watchers_.end()) return;
  watcher->second.erase(document);
  if (watcher->second.empty()) watchers_.erase(watcher);
}

bool TestRuns::is_watched_by(console::ConnectionId who, const std::string& document) const {
  const auto watcher = watchers_.find(who);
  return watcher != watchers_.end() && watcher->second.contains(document);
}

void TestRuns::look(TestTexts texts) {
  if (is_known_ && is_same(texts.sources, texts_.sources)) return;
  texts_ = std::move(texts);
  start_finding();
}

void TestRuns::start_finding() {
  finds_.start("find",
               [this, texts = texts_](const LatestJobs::IsStale& is_stale) { find(texts, is_stale); });
}

void TestRuns::find(const TestTexts& texts, const LatestJobs::IsStale& is_stale) {
  FoundFiles found;
  for (const text::SourcePtr& source : texts.sources) {
    if (is_stale()) return;
    if (!source->name().ends_with(".cdl")) continue;
    if (std::optional<TestFile> file = test_file_of(source, *texts.files))
      found.push_back(std::make_shared<const TestFile>(*std::move(file)));
  }
  post_([this, found = std::move(found)]() mutable { take(std::move(found)); });
}

void TestRuns::take(FoundFiles found) {
  files_ = std::move(found);
  is_known_ = true;
  ++number_;
  std::set<Key> there;
  for (const FilePtr& file : files_) {
    for (const WrittenTest& test : file->tests) there.emplace(file->source->name(), test.name);
  }
  std::erase_if(verdicts_, [&](const auto& one) { return !there.contains(one.first); });
}

text::SourcePtr TestRuns::source_named(const std::string& name) const {
  const auto found = std::ranges::find_if(
      texts_.sources, [&](const text::SourcePtr& source) { return source->name() == name; });
  return found == texts_.sources.end() ? nullptr : *found;
}

TestList TestRuns::list(const std::string& document, const std::string& source,
                        const std::function<std::string(std::string_view source)>& document_of) const {
  TestList out;
  out.set_document(document);
  out.set_is_known(is_known_);
  std::size_t left_out = 0;
  // Its own first.
  for (const bool is_own : {true, false}) {
    for (const FilePtr& file : files_) {
      if ((file->source->name() == source) != is_own || !file->used.contains(source)) continue;
      for (const WrittenTest& test : file->tests) {
        if (static_cast<std::size_t>(out.tests_size()) < kMostListed)
          add_test(*file, test, document_of, out);
        else
          ++left_out;
      }
    }
  }
  if (left_out > 0) out.set_left_out(fmt::format("{} more are not listed", left_out));
  return out;
}

void TestRuns::add_test(const TestFile& file, const WrittenTest& test,
                        const std::function<std::string(std::string_view source)>& document_of,
                        TestList& out) const {
  TestList::Test& told = *out.add_tests();
  encode_place(test.place, document_of, *told.mutable_at());
  told.mutable_test()->set_file(told.at().document());
  told.mutable_test()->set_name(test.name);
  told.set_component(text::as_utf8(test.component));
  told.set_line(file.source->line_column(test.place.span.begin).line);
  told.set_brings_code(file.brings_code);
  if (test.declared.source) {
    encode_place(test.declared, document_of, *told.mutable_page());
    told.mutable_page()->set_page(text::as_utf8(test.assemblage));
  }
  const Key key = {file.source->name(), test.name};
  const auto verdict = verdicts_.find(key);
  if (verdict != verdicts_.end()) {
    const Verdict& last = verdict->second;
    told.set_is_outdated(last.seal != file.seal);
    told.set_cycles(static_cast<std::uint32_t>(last.cycles));
    told.set_state(!last.why.empty() ? TestList::CANT_RUN
                   : last.failure    ? TestList::FAILED
                                     : TestList::PASSED);
    told.set_why(text::as_utf8(last.why));
    encode_place(last.trouble, document_of, *told.mutable_trouble());
    if (last.failure) {
      TestList::Failure& failure = *told.mutable_failure();
      failure.set_expected(text::as_utf8(last.failure->expected));
      failure.set_reason(text::as_utf8(last.failure->reason));
      failure.set_label(text::as_utf8(last.failure->label));
      failure.set_cycle(static_cast<std::uint32_t>(last.failure->cycle));
      for (const std::string& finding : component_test::findings(*last.failure))
        failure.add_findings(text::as_utf8(finding));
      const text::Place& place = last.failure->place;
      encode_place(place, document_of, *failure.mutable_place());
      if (place.source) failure.set_line(place.source->line_column(place.span.begin).line);
    }
  }
  if (running_.contains(key)) told.set_state(TestList::RUNNING);
}

std::string TestRuns::source_of(
    const TestName& test, const std::function<std::string(std::string_view source)>& document_of) const {
  for (const FilePtr& file : files_) {
    if (document_of(file->source->name()) == test.file()) return file->source->name();
  }
  return "";
}

void TestRuns::run(const std::vector<Key>& tests) {
  run_ends_.request_stop();
  run_ends_ = std::stop_source();
  running_.clear();
  ++run_;
  ++number_;
  std::vector<Batch> batches;
  for (const Key& key : tests) {
    const text::SourcePtr source = source_named(key.first);
    if (!source) continue;
    auto batch = std::ranges::find(batches, source, &Batch::source);
    if (batch == batches.end()) batch = batches.insert(batches.end(), {source, {}});
    batch->names.insert(key.second);
    running_.insert(key);
  }
  runs_.start(
      "run", [this, run = run_, batches = std::move(batches), files = texts_.files,
              ends = run_ends_.get_token()](const LatestJobs::IsStale&) { work(run, batches, files, ends); });
}

void TestRuns::work(std::uint64_t run, const std::vector<Batch>& batches,
                    const std::shared_ptr<const text::Files>& files, const std::stop_token& ends) {
  Verdicts news;
  Clock::time_point told = Clock::now();
  const auto tell = [&](bool is_last) {
    post_([this, run, news = std::exchange(news, {}), is_last]() mutable {
      take(run, std::move(news), is_last);
    });
    told = Clock::now();
  };
  for (const Batch& batch : batches) {
    if (ends.stop_requested()) return;
    const std::optional<TestFile> file = test_file_of(batch.source, *files);
    const std::uint64_t seal = file ? file->seal : 0;
    const LoadedFile& loaded = runs_loaded_.of(batch.source, seal, *files, ends);
    for (const std::string& name : batch.names) {
      const component_test::Test* test = loaded.find(name);
      Verdict verdict;
      if (loaded.problems.has_errors()) {
        const text::Diagnostic& error = first_error(loaded.problems);
        verdict.why = error.message;
        verdict.trouble = error.place;
      } else if (test == nullptr) {
        verdict.why = "it is not there any more";
      } else {
        verdict = verdict_of(*test, ends);
      }
      if (ends.stop_requested()) return;
      verdict.seal = seal;
      news.emplace_back(Key{batch.source->name(), name}, std::move(verdict));
      if (Clock::now() - told > kBetweenNews) tell(false);
    }
  }
  tell(true);
}

TestRuns::Verdict TestRuns::verdict_of(const component_test::Test& test, const std::stop_token& ends) {
  const Clock::time_point latest = Clock::now() + kLongestTest;
  const component_test::Outcome outcome = component_test::run(
      test, {.is_stopped = [&] { return ends.stop_requested() || Clock::now() > latest; }});
  Verdict out;
  out.cycles = outcome.cycles;
  out.failure = outcome.failure;
  if (outcome.was_stopped && !outcome.failure)
    out.why =
        fmt::format("it is not done after {} s: that were {} cycles", kLongestTest.count(), outcome.cycles);
  return out;
}

void TestRuns::take(std::uint64_t run, Verdicts verdicts, bool is_last) {
  if (run != run_) return;
  bool is_other = false;
  for (auto& [key, verdict] : verdicts) {
    running_.erase(key);
    const auto file =
        std::ranges::find(files_, key.first, [](const FilePtr& one) { return one->source->name(); });
    is_other = is_other || (file != files_.end() && (*file)->seal != verdict.seal);
    verdicts_[key] = std::move(verdict);
  }
  if (is_last) running_.clear();
  // A file that nobody looks at has changed, such as a header.
  if (is_other) start_finding();
  ++number_;
}

void TestRuns::show(const std::string& asker, const Key& test, std::uint64_t cycle, LookedPage page,
                    TakeCycle shown) {
  if (const auto before = waiting_.find(asker); before != waiting_.end()) {
    before->second.shown(not_shown("another cycle was asked for since"));
    waiting_.erase(before);
  }
  const text::SourcePtr source = source_named(test.first);
  if (!source) {
    shown(not_shown("the test is not there any more"));
    return;
  }
  const std::uint64_t question = ++questions_;
  waiting_[asker] = {question, std::move(shown)};
  shows_.start(asker, [this, asker, question, source, files = texts_.files, name = test.second, cycle,
                       page = std::move(page)](const LatestJobs::IsStale& is_stale) {
    text::Result<TestCycle> found = shown_cycle(source, *files, name, cycle, page, is_stale);
    post_([this, asker, question, found = std::move(found)] {
      const auto waiting = waiting_.find(asker);
      if (waiting == waiting_.end() || waiting->second.question != question) return;
      const TakeCycle answer = std::move(waiting->second.shown);
      waiting_.erase(waiting);
      answer(found);
    });
  });
}

text::Result<TestCycle> TestRuns::shown_cycle(const text::SourcePtr& source, const text::Files& files,
                                              const std::string& test, std::uint64_t cycle,
                                              const LookedPage& page, const LatestJobs::IsStale& is_stale) {
  const Clock::time_point latest = Clock::now() + kLongestTest;
  const std::stop_token ends = all_end_.get_token();
  const std::optional<TestFile> file = test_file_of(source, files);
  LoadedFile& loaded = shows_loaded_.of(source, file ? file->seal : 0, files, ends);
  if (loaded.problems.has_errors()) return not_shown(first_error(loaded.problems).message);
  const component_test::Test* found = loaded.find(test);
  if (found == nullptr) return not_shown(fmt::format("there is no test \"{}\"", text::shown(test)));
  TestCycle out = test_cycle(loaded, *found, cycle, page,
                             [&] { return ends.stop_requested() || is_stale() || Clock::now() > latest; });
  if (out.cycle() == 0) return not_shown("no cycle of the test can run");
  return out;
}

}  // namespace mlab::designer
