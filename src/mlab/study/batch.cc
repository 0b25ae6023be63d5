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
             const std::vector<std::unique_ptr<Scene>>& scenes, Keeper* kept, Share share)
    : definition_(definition),
      plan_(plan),
      scenes_(scenes),
      kept_(kept),
      share_(std::move(share)),
      next_(share_.rank),
      choice_(share_.rank) {
  cells_.resize(plan.versions() * plan.combinations());
  open_.resize(cells_.size());
}

void Batch::take(std::vector<Row> rows) {
  const std::lock_guard lock(mutex_);
  for (Row& row : rows) {
    const bool is_planned = row.key.version < plan_.versions() &&
                            row.key.combination < plan_.combinations() && row.key.run < plan_.runs() &&
                            row.seed == plan_.seed(row.key.run);
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

bool Batch::is_counted(const RunKey& key) const {
  const std::size_t at = index(key);
  return open_[at].is_closed || key.run < cells_[at].rows.size() || open_[at].waiting.contains(key.run);
}

std::shared_ptr<Batch::Running> Batch::begin(std::uint64_t place) {
  auto out = std::make_shared<Running>();
  out->key = plan_.key(place);
  out->place = place;
  running_.push_back(out);
  return out;
}

void Batch::forget(const Running& running) {
  std::erase_if(running_, [&](const auto& one) { return one.get() == &running; });
}

std::shared_ptr<Batch::Running> Batch::next() {
  const std::lock_guard lock(mutex_);
  if (is_not_kept_ || is_over_) return nullptr;
  while (next_ < plan_.all()) {
    const std::uint64_t place = std::exchange(next_, next_ + share_.count);
    if (!is_counted(plan_.key(place))) return begin(place);
  }
  if (share_.is_alone()) return nullptr;
  if (others_.empty()) {
    for (std::uint64_t place = plan_.all(); place-- > 0;) others_.push_back(place);
  }
  hear();
  const auto place = place_of_others();
  return place && !is_over_ ? begin(*place) : nullptr;
}

std::optional<std::uint64_t> Batch::place_of_others() {
  // With early stopping those that come later may never count.
  const std::size_t near = 8 * std::size_t{share_.count};
  constexpr int kTries = 32;
  const auto is_running = [this](std::uint64_t place) {
    return std::ranges::any_of(running_, [&](const auto& one) { return one->place == place; });
  };
  for (int i = 0; i < kTries && others_.size() > near; ++i) {
    const std::size_t among = definition_.until ? near : others_.size();
    const auto at = others_.end() - 1 - static_cast<std::ptrdiff_t>(choice_.below(among));
    const std::uint64_t place = *at;
    if (is_counted(plan_.key(place))) {
      // Only with early stopping their order matters.
      if (!definition_.until) std::swap(*at, others_.back());
      others_.erase(definition_.until ? at : others_.end() - 1);
    } else if (!is_running(place)) {
      return place;
    }
  }
  std::erase_if(others_, [this](std::uint64_t place) { return is_counted(plan_.key(place)); });
  const std::size_t first = others_.empty() ? 0 : choice_.below(std::min(near, others_.size()));
  for (std::size_t i = 0; i < others_.size(); ++i) {
    const std::uint64_t place = others_[others_.size() - 1 - (first + i) % others_.size()];
    if (!is_running(place)) return place;
  }
  return std::nullopt;
}

void Batch::hear() {
  constexpr std::chrono::milliseconds kBetween{20};
  const auto now = std::chrono::steady_clock::now();
  if (share_.is_alone() || kept_ == nullptr || now - heard_ < kBetween) return;
  heard_ = now;
  for (Row& row : kept_->news()) {
    const bool is_planned = row.key.version < plan_.versions() &&
                            row.key.combination < plan_.combinations() && row.key.run < plan_.runs();
    if (is_planned) count(std::move(row));
  }
  is_over_ = kept_->is_over();
  for (const auto& one : running_) {
    if (is_over_ || is_counted(one->key)) one->is_needless = true;
  }
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

void Batch::finish(Row row, const Running& running) {
  const std::lock_guard lock(mutex_);
  forget(running);
  if (is_counted(row.key)) return;
  if (kept_ != nullptr && !kept_->append(row)) is_not_kept_ = true;
  const RunKey key = row.key;
  count(std::move(row));
  if (!open_[index(key)].is_closed) return;
  for (const auto& one : running_) {
    if (index(one->key) == index(key)) one->is_needless = true;
  }
}

void Batch::work(const std::function<bool()>& wants_end) {
  while (!wants_end()) {
    const std::shared_ptr<Running> running = next();
    if (!running) return;
    bool is_given_up = false;
    Row row = carry_out_one(running->key, [&] { return running->is_needless || wants_end(); }, is_given_up);
    if (!is_given_up) {
      finish(std::move(row), *running);
      continue;
    }
    const std::lock_guard lock(mutex_);
    forget(*running);
    if (!running->is_needless) return;
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
    hear();
    look(progress());
  }
  workers.clear();
  if (is_not_kept_) return End::kNotKept;
  if (is_over_) return End::kOver;
  return is_complete() ? End::kDone : End::kInterrupted;
}

bool Batch::is_complete() const {
  return std::ranges::all_of(open_, &Open::is_closed);
}

}  // namespace mlab::study
