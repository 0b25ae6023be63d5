#include "mlab/comparison/testing/two_runs.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mlab/cell/testing/permission.h"

namespace mlab::comparison::testing {

using history::testing::WrittenRun;

HistoryPtr carried_out(const std::string& file, std::uint64_t seed, int cycles,
                       const std::function<void(WrittenRun&, int)>& meddle) {
  WrittenRun written(file, seed, true);
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < cycles; ++i) {
    if (meddle) meddle(written, i);
    written.step();
  }
  written.end();
  return written.history();
}

HistoryPtr of_entries(const std::vector<wire::HistoryEntry>& entries) {
  auto out = std::make_shared<history::History>();
  for (const wire::HistoryEntry& entry : entries) {
    const auto problem = out->add(entry);
    EXPECT_FALSE(problem) << *problem;
  }
  return out;
}

HistoryPtr with_other_texts(const WrittenRun& written, const std::string& from, const std::string& to) {
  std::vector<wire::HistoryEntry> entries;
  bool is_found = false;
  for (wire::HistoryEntry entry : written.entries()) {
    if (entry.has_mark() || entry.has_end()) continue;
    if (entry.has_text()) {
      std::string content = entry.text().content();
      for (std::size_t at = content.find(from); at != std::string::npos;
           at = content.find(from, at + to.size())) {
        content.replace(at, from.size(), to);
        is_found = true;
      }
      entry.mutable_text()->set_content(content);
    }
    entries.push_back(std::move(entry));
  }
  EXPECT_TRUE(is_found) << from;
  return of_entries(entries);
}

Recorded recorded(const std::string& name, const HistoryPtr& history) {
  Recorded out;
  out.name = name;
  out.history = history;
  text::Diagnostics sink;
  out.replay = history::Replay::make(history, {cell::testing::code_permitted()}, sink);
  if (!out.replay) out.why_not = history->why_not_recomputed();
  return out;
}

Comparison compared(const HistoryPtr& a, const HistoryPtr& b) {
  Comparer comparer({recorded("a.mcap", a), recorded("b.mcap", b)});
  while (comparer.step()) {
  }
  return comparer.finish();
}

bool has(const std::vector<std::string>& sentences, std::string_view part) {
  return std::ranges::any_of(sentences,
                             [&](const std::string& one) { return one.find(part) != std::string::npos; });
}

}  // namespace mlab::comparison::testing
