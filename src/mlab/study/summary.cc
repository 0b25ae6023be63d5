#include "mlab/study/summary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shell_word.h"

namespace mlab::study {
namespace {

CellSummary summary_of(const Cell& cell, const Definition& definition,
                       const std::vector<NumberInfo>& numbers) {
  CellSummary out;
  out.successes = cell.successes;
  out.interval = interval_of(definition, cell.successes, definition.confidence);
  std::vector<double> values(cell.rows.size());
  for (const NumberInfo& info : numbers) {
    std::ranges::transform(cell.rows, values.begin(), [&](const Row& row) { return row[info.number]; });
    out.samples.push_back(statistics::sample_of(values));
  }
  return out;
}

Comparison compare(const Cell& one, const Cell& other, const std::vector<NumberInfo>& numbers) {
  Comparison out;
  out.pairs = std::min(one.rows.size(), other.rows.size());
  for (std::size_t i = 0; i < out.pairs; ++i) {
    if (one.rows[i].success && !other.rows[i].success) ++out.successes.only_first;
    if (!one.rows[i].success && other.rows[i].success) ++out.successes.only_second;
  }
  out.p = statistics::mcnemar(out.successes);
  for (const NumberInfo& info : numbers) {
    std::vector<double> differences;
    std::vector<statistics::Pair> pairs;
    for (std::size_t i = 0; i < out.pairs; ++i) {
      pairs.push_back({one.rows[i][info.number], other.rows[i][info.number]});
      differences.push_back(pairs.back().first - pairs.back().second);
    }
    const statistics::Sample sample = statistics::sample_of(differences);
    Comparison::Difference& difference = out.differences.emplace_back();
    difference.pairs = sample.size();
    difference.mean = sample.mean;
    if (!sample.empty()) difference.median = statistics::quantile(sample, 0.5);
    difference.ranks = statistics::signed_ranks(pairs);
  }
  return out;
}

std::vector<FailureGroup> failures_in(const Batch& batch, const Definition& definition, const Plan& plan) {
  std::map<std::string_view, FailureGroup> groups;
  for (const Cell& cell : batch.cells()) {
    for (const Row& row : cell.rows) {
      if (row.success) continue;
      FailureGroup& group = groups[row.cause];
      if (group.count++ > 0) continue;
      group.cause = row.cause;
      group.first = row.key;
      group.message = row.message;
      group.command = command_of(row.key, definition, plan);
    }
  }
  std::vector<FailureGroup> out;
  for (auto& [cause, group] : groups) out.push_back(std::move(group));
  std::ranges::stable_sort(out, std::greater(), &FailureGroup::count);
  return out;
}

Verdict verdict_on(const Requirement& requirement, const Batch& batch, const Definition& definition,
                   const Plan& plan) {
  Verdict out;
  out.requirement = &requirement;
  for (std::uint32_t i = 0; i < plan.combinations(); ++i) {
    out.intervals.push_back(interval_of(definition, batch.cell(0, i).successes, requirement.confidence));
    if (!requirement.is_met(out.intervals.back())) out.unmet.push_back(i);
  }
  return out;
}

}  // namespace

std::vector<NumberInfo> shown_numbers() {
  std::vector<NumberInfo> out;
  std::ranges::copy_if(kNumbers, std::back_inserter(out), &NumberInfo::is_compared);
  return out;
}

bool Summary::are_all_met() const {
  return std::ranges::all_of(verdicts, &Verdict::is_met);
}

Summary summary_of(const Batch& batch, const Definition& definition, const Plan& plan) {
  const std::vector<NumberInfo> numbers = shown_numbers();
  Summary out;
  for (std::uint32_t version = 0; version < plan.versions(); ++version) {
    for (std::uint32_t i = 0; i < plan.combinations(); ++i) {
      CellSummary cell = summary_of(batch.cell(version, i), definition, numbers);
      cell.version = version;
      cell.combination = i;
      cell.settings = plan.settings(i);
      out.runs += cell.successes.trials;
      out.failed += cell.successes.trials - cell.successes.successes;
      out.cells.push_back(std::move(cell));
    }
  }
  out.failures = failures_in(batch, definition, plan);
  for (const Requirement& one : definition.requirements)
    out.verdicts.push_back(verdict_on(one, batch, definition, plan));
  for (std::uint32_t i = 0; plan.versions() == 2 && i < plan.combinations(); ++i) {
    out.comparisons.push_back(compare(batch.cell(0, i), batch.cell(1, i), numbers));
    out.comparisons.back().combination = i;
  }
  return out;
}

std::string command_of(const RunKey& key, const Definition& definition, const Plan& plan) {
  std::string out =
      fmt::format("mlab run {} --headless --proceed --seed {}",
                  text::shell_word(key.version == 0 ? definition.mission.text : definition.against.text),
                  plan.seed(key.run));
  for (const mdl::Setting& one : plan.settings(key))
    out += " --set " + text::shell_word(one.name) + "=" + text::shell_word(one.value);
  if (!definition.start_time.empty()) out += " --start-time " + text::shell_word(definition.start_time);
  if (definition.patience != Definition{}.patience) out += " --patience " + shortest(definition.patience);
  if (definition.duration) out += " --for " + shortest(*definition.duration);
  if (definition.limit) out += " --limit " + shortest(*definition.limit);
  if (!definition.environment.empty())
    out += " --environment " + text::shell_word(definition.environment.text);
  return out;
}

std::string replay_of(const std::string& recording) {
  return "mlab replay " + text::shell_word(recording.starts_with('-') ? "./" + recording : recording);
}

}  // namespace mlab::study
