#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "mlab/comparison/comparer.h"
#include "mlab/history/testing/written_run.h"

namespace mlab::comparison::testing {

using HistoryPtr = std::shared_ptr<const history::History>;

/// A mission of the project that is carried out for so many cycles, and what somebody does after some of
/// them.
HistoryPtr carried_out(const std::string& file, std::uint64_t seed, int cycles,
                       const std::function<void(history::testing::WrittenRun&, int cycle)>& meddle = {});

/// The same history with other texts: `from` is written as `to` in all of them. What was computed then is
/// left out, so it can be computed anew.
HistoryPtr with_other_texts(const history::testing::WrittenRun& written, const std::string& from,
                            const std::string& to);
HistoryPtr of_entries(const std::vector<wire::HistoryEntry>& entries);

/// Ready to be computed again.
Recorded recorded(const std::string& name, const HistoryPtr& history);
Comparison compared(const HistoryPtr& a, const HistoryPtr& b);

/// Some of the sentences has this in it.
bool has(const std::vector<std::string>& sentences, std::string_view part);

}  // namespace mlab::comparison::testing
