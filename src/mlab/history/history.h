#pragma once

#include <algorithm>
#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/history.pb.h"
#include "mlab/run/input.h"
#include "mlab/text/source.h"

namespace mlab::history {

/// What came in, and when. What it means is known once its texts were read.
struct InputEntry {
  run::Moment moment;
  double time = 0.0;  ///< [s]
  wire::HistoryInput input;
};

/// How the run stood.
struct MarkEntry {
  std::uint64_t cycle = 0;
  std::uint64_t digest = 0;
};

struct PosesEntry {
  std::uint64_t cycle = 0;
  double time = 0.0;  ///< [s]
  wire::HistoryPoses poses;
};

struct EventEntry {
  std::uint64_t cycle = 0;
  double time = 0.0;  ///< [s]
  std::string text;
  bool is_warning = false;
};

struct EndEntry {
  std::uint64_t cycle = 0;
  std::string outcome;
  bool has_looked = false;
  std::uint64_t digest = 0;
};

/// What robots answered whose programs can't be computed again, in the cycles behind those of the entry
/// before, up to this one. It is in order, and each answer is one that a robot can give.
struct AnswersEntry {
  std::uint64_t cycle = 0;
  wire::HistoryAnswers answers;
};

/// The history of one run, as far as it was written. A plain value; whatever it was read from, it is whole:
/// what refers to a text finds it, and cycles never go back.
class History {
 public:
  static constexpr std::uint32_t kFormat = 1;
  /// Of texts, together [bytes].
  static constexpr std::size_t kMostText = std::size_t{256} << 20;

  /// The next entry of a file, or of a run that goes on. Anything may come.
  /// @errors  a sentence: what is wrong with it; nothing has changed then
  std::optional<std::string> add(const wire::HistoryEntry& entry);

  /// The run goes on, and has come so far, though no entry says so yet. It never goes back.
  /// @param time  [s]
  void reach(std::uint64_t cycle, double time);

  /// Nothing before the run's beginning was read.
  bool has_begun() const { return beginning_.has_value(); }
  const wire::HistoryBeginning& beginning() const { return *beginning_; }
  /// By id; null: there is none.
  text::SourcePtr text(std::uint32_t id) const;
  const std::vector<InputEntry>& inputs() const { return inputs_; }
  /// The version of the mission that is in force after a cycle, before anything comes in behind it.
  const wire::HistoryMission& version_at(std::uint64_t cycle) const;
  const std::vector<MarkEntry>& marks() const { return marks_; }
  const std::vector<PosesEntry>& poses() const { return poses_; }
  const std::vector<EventEntry>& events() const { return events_; }
  const std::vector<AnswersEntry>& answers() const { return answers_; }
  /// Why a robot's program was not brought to life after that cycle; null: it was.
  /// @param start  which of the robot's starts it was, from 1
  const std::string* why_not_started(std::uint64_t cycle, std::uint32_t robot, std::uint32_t start) const;
  /// What a robot's program did in that cycle instead of acting, one that is computed again; null: it acted.
  const std::string* why_failed(std::uint64_t cycle, std::uint32_t robot) const;
  /// A robot whose program failed.
  struct Failure {
    std::uint64_t cycle = 0;
    std::uint32_t robot = 0;
    std::uint32_t start = 0;  ///< where it was not started: as `why_not_started`; 0: each of that cycle

    auto operator<=>(const Failure&) const = default;
  };
  using Failures = std::map<Failure, std::string>;              // with what it did
  const Failures& not_started() const { return not_started_; }  ///< after that cycle
  const Failures& failed() const { return failed_; }            ///< in that cycle
  /// Nothing where the run was not told to its end: it goes on, or it was killed.
  const std::optional<EndEntry>& end() const { return end_; }
  /// The last that is known of, and its time [s]. Where robots' answers are a part of the history, the last
  /// of which they are known.
  std::uint64_t last_cycle() const { return needs_answers_ ? std::min(last_cycle_, answered_) : last_cycle_; }
  double last_time() const { return needs_answers_ ? std::min(last_time_, answered_time_) : last_time_; }

  /// Why the run can't be computed again whatever program reads this, as a sentence; empty: it can.
  std::string why_not_recomputed() const;
  /// Why nobody can go on with the run from where it ends, as a sentence; empty: the run can be computed
  /// again, and gone on with.
  std::string why_not_gone_on() const;
  /// The same of a run of which all is recorded, known before that.
  /// @param executable  a program of it that is in one; empty: none is
  static std::string why_not_gone_on(bool is_in_real_time, const std::string& executable);

 private:
  std::optional<std::string> add_text(const wire::HistoryText& text);
  std::optional<std::string> check(const wire::HistoryMission& mission) const;
  std::optional<std::string> add_body(const wire::HistoryEntry& entry);
  std::optional<std::string> add_answers(const wire::HistoryEntry& entry);
  void note_need_of_answers(const wire::HistoryMission& mission, const wire::HistoryEntry& entry);
  std::string executable() const;

  std::optional<wire::HistoryBeginning> beginning_;
  std::map<std::uint32_t, text::SourcePtr> texts_;
  std::size_t text_bytes_ = 0;
  std::vector<InputEntry> inputs_;
  std::vector<MarkEntry> marks_;
  std::vector<PosesEntry> poses_;
  std::vector<EventEntry> events_;
  std::vector<AnswersEntry> answers_;
  Failures not_started_;
  Failures failed_;
  bool needs_answers_ = false;
  std::uint64_t answered_ = 0;  // up to this cycle, if it needs answers
  double answered_time_ = 0.0;  // of it [s]
  std::optional<EndEntry> end_;
  std::uint64_t last_cycle_ = 0;
  double last_time_ = 0.0;
};

}  // namespace mlab::history
