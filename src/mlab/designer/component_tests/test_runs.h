#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/component_test/component_test.h"
#include "mlab/console/server/connection_id.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/component_tests/loaded_tests.h"
#include "mlab/designer/component_tests/test_cycle.h"
#include "mlab/designer/component_tests/test_file.h"
#include "mlab/designer/latest_jobs.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"

namespace mlab::designer {

/// The texts in which tests are looked for.
struct TestTexts {
  std::vector<text::SourcePtr> sources;
  std::shared_ptr<const text::Files> files;  ///< what they may use; read on other threads
};

/// Finds the tests of a project's texts and runs them, on threads of its own: nothing that a test does makes
/// anybody wait. Its functions belong to one thread, on which `post` does what it is handed.
class TestRuns {
 public:
  /// At most so many tests are listed; the rest is told of.
  static constexpr std::size_t kMostListed = 1000;

  using Post = std::function<void(std::function<void()> task)>;
  /// @param programs  whether C++ may be compiled and run, and how far
  TestRuns(const robot::ProgramSources& programs, Post post);
  ~TestRuns();
  TestRuns(const TestRuns&) = delete;
  TestRuns& operator=(const TestRuns&) = delete;

  // ---- who looks

  void watch(console::ConnectionId who, const std::string& document, bool is_wanted);
  void close(console::ConnectionId who) { watchers_.erase(who); }
  bool is_watched() const { return !watchers_.empty(); }
  bool is_watched_by(console::ConnectionId who, const std::string& document) const;

  // ---- what there is

  /// Looks for tests anew where a text is another one than before.
  void look(TestTexts texts);
  /// Grows when something in a list is otherwise.
  std::uint64_t number() const { return number_; }
  /// @param document     its id
  /// @param source       name of its text
  /// @param document_of  the id of the document that a source is the text of
  TestList list(const std::string& document, const std::string& source,
                const std::function<std::string(std::string_view source)>& document_of) const;
  /// Name of the text in which a listed test stands; empty: there is no such test.
  std::string source_of(const TestName& test,
                        const std::function<std::string(std::string_view source)>& document_of) const;

  // ---- what is done

  /// A test by the name of its text and its own.
  using Key = std::pair<std::string, std::string>;
  /// Gives up what runs. What is none of those that there are is left out.
  void run(const std::vector<Key>& tests);

  /// The values of a cycle, or a sentence that says why there are none.
  using TakeCycle = std::function<void(text::Result<TestCycle> shown)>;
  /// @param asker  whose newest question alone is answered with values
  void show(const std::string& asker, const Key& test, std::uint64_t cycle, LookedPage page, TakeCycle shown);

 private:
  /// What came of a test the last time.
  struct Verdict {
    std::uint64_t seal = 0;  ///< TestFile::seal of what was run
    std::string why;         ///< it can't run; empty: it ran
    text::Place trouble;     ///< where that is
    std::uint64_t cycles = 0;
    std::optional<component_test::Failure> failure;
  };
  using Verdicts = std::vector<std::pair<Key, Verdict>>;
  using FilePtr = std::shared_ptr<const TestFile>;
  /// Tests of one text.
  struct Batch {
    text::SourcePtr source;
    std::set<std::string> names;
  };
  using FoundFiles = std::vector<FilePtr>;

  void start_finding();
  void find(const TestTexts& texts, const LatestJobs::IsStale& is_stale);
  void take(FoundFiles found);
  /// @param ends  asked for by who gives the run up
  void work(std::uint64_t run, const std::vector<Batch>& batches,
            const std::shared_ptr<const text::Files>& files, const std::stop_token& ends);
  static Verdict verdict_of(const component_test::Test& test, const std::stop_token& ends);
  void take(std::uint64_t run, Verdicts verdicts, bool is_last);
  /// As it stands now; null where there is none.
  text::SourcePtr source_named(const std::string& name) const;
  /// On the thread of `shows_`.
  text::Result<TestCycle> shown_cycle(const text::SourcePtr& source, const text::Files& files,
                                      const std::string& test, std::uint64_t cycle, const LookedPage& page,
                                      const LatestJobs::IsStale& is_stale);
  void add_test(const TestFile& file, const WrittenTest& test,
                const std::function<std::string(std::string_view source)>& document_of, TestList& out) const;

  const Post post_;
  std::map<console::ConnectionId, std::set<std::string>> watchers_;  // documents
  TestTexts texts_;
  FoundFiles files_;  // with tests
  bool is_known_ = false;
  bool is_cut_ = false;  // there are more tests than are looked at
  std::map<Key, Verdict> verdicts_;
  std::set<Key> running_;
  std::uint64_t run_ = 0;  // number of the newest
  std::stop_source run_ends_;
  std::stop_source all_end_;
  std::uint64_t number_ = 1;
  struct Waiting {
    std::uint64_t question = 0;
    TakeCycle shown;
  };
  std::map<std::string, Waiting> waiting_;  // by asker
  std::uint64_t questions_ = 0;
  LoadedTests runs_loaded_;   // of the thread of `runs_`
  LoadedTests shows_loaded_;  // of that of `shows_`
  LatestJobs finds_;
  LatestJobs runs_;
  LatestJobs shows_;
};

}  // namespace mlab::designer
