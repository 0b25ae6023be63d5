#include "mlab/study/batch.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <thread>
#include <utility>

#include "mlab/study/one_run.h"

namespace mlab::study {

statistics::Interval interval_of(const Definition& definition, statistics::Count count, double confidence) {
  return definition.until ? statistics::confidence_sequence(count, confidence)
                          : statistics::clopper_pearson(count, confidence);
}

Batch::Batch(const Definition& definition, const Plan& plan,
             const std::vector<std::unique_ptr<Scene>>& scenes, ResultsFile* kept)
    : definition_(definition), plan_(plan), scenes_(scenes), kept_(kept) {
  cells_.resize(plan.versions() * plan.combinations());
  open_.resize(cells_.size());
}

void Batch::take(std::vector<Row> rows) {
  const std::lock_guard lock(mutex_);
  for (Row& row : rows) {
    const bool is_planned = row.key.version < plan_.versions() &&
                            row.key.combination < plan_.combinations() && row.key.run < plan_.runs();
    if (is_planned) count(std::move(row));
  }
  before_ = progress().done;
}

bool Batch::is_enough(const Cell& cell) const {
  if (!definition_.until) return false;
  const Until& until = *definition_.until;
  if (!until.is_decided)
    return statistics::confidence_sequence(cell.successes, until.confidence).width() <=
           2.0 * until.half_width;
  return std::ranges::all_of(definition_.requirements, [&](const Requirement& one) {
    const statistics::Interval interval = statistics::confidence_sequence(cell.successes, one.confidence);
    return one.is_met(interval) || one.is_refuted(interval);
  });
}

void Batch::count(Row row) {
  const std::size_t at = index(row.key);
  Cell& cell = cells_[at];
  Open& open = open_[at];
  if (open.is_closed || row.key.run < cell.rows.size()) return;
  open.waiting.emplace(row.key.run, std::move(row));
  while (!open.is_closed && !open.waiting.empty() && open.waiting.begin()->first == cell.rows.size()) {
    cell.rows.push_back(std::move(open.waiting.begin()->second));
    open.waiting.erase(open.waiting.begin());
    ++cell.successes.trials;
    if (cell.rows.back().success) ++cell.successes.successes;
    open.is_closed = cell.rows.size() == plan_.runs() || is_enough(cell);
  }
  if (open.is_closed) open.waiting.clear();
}

std::optional<RunKey> Batch::next() {
  const std::lock_guard lock(mutex_);
  while (!is_not_kept_ && next_ < plan_.all()) {
    const RunKey key = plan_.key(next_++);
    const std::size_t at = index(key);
    if (open_[at].is_closed || key.run < cells_[at].rows.size() || open_[at].waiting.contains(key.run))
      continue;
    return key;
  }
  return std::nullopt;
}

Row Batch::carry_out_one(const RunKey& key, const std::function<bool()>& wants_end, bool& is_given_up) const {
  Row row;
  if (auto run = scenes_[key.version]->make_run(key)) {
    const std::optional<run::RunEnd> end = carry_out(**run, definition_, wants_end);
    is_given_up = !end;
    if (end) row = row_of(**run, *end, definition_);
  } else {
    row = row_of_none(run.error());
  }
  row.key = key;
  row.seed = plan_.seed(key.run);
  return row;
}

void Batch::work(const std::function<bool()>& wants_end) {
  while (!wants_end()) {
    const std::optional<RunKey> key = next();
    if (!key) return;
    bool is_given_up = false;
    Row row = carry_out_one(*key, wants_end, is_given_up);
    if (is_given_up) return;
    const std::lock_guard lock(mutex_);
    if (open_[index(*key)].is_closed) continue;
    if (kept_ != nullptr && !kept_->append(row)) is_not_kept_ = true;
    count(std::move(row));
  }
}

Progress Batch::progress() const {
  Progress out;
  out.before = before_;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const std::uint64_t done = cells_[i].rows.size() + open_[i].waiting.size();
    out.done += done;
    out.all += open_[i].is_closed ? done : plan_.runs();
    out.failed += cells_[i].successes.trials - cells_[i].successes.successes;
  }
  return out;
}

Batch::End Batch::run(int threads, const std::function<bool()>& wants_end,
                      const std::function<void(const Progress&)>& look) {
  constexpr std::chrono::milliseconds kBetweenLooks{200};
  std::mutex mutex;
  std::condition_variable changed;
  int working = threads;
  std::vector<std::jthread> workers;
  for (int i = 0; i < threads; ++i) {
    workers.emplace_back([&] {
      work(wants_end);
      const std::lock_guard lock(mutex);
      --working;
      changed.notify_all();
    });
  }
  for (bool is_over = false; !is_over;) {
    {
      std::unique_lock lock(mutex);
      is_over = changed.wait_for(lock, kBetweenLooks, [&] { return working == 0; });
    }
    const std::lock_guard lock(mutex_);
    look(progress());
  }
  workers.clear();
  if (is_not_kept_) return End::kNotKept;
  return std::ranges::all_of(open_, &Open::is_closed) ? End::kDone : End::kInterrupted;
}

}  // namespace mlab::study
