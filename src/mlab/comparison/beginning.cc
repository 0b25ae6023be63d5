#include "mlab/comparison/beginning.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include <fmt/chrono.h>
#include <fmt/core.h>

#include "mlab/text/kept_lines.h"
#include "mlab/text/shown.h"

namespace mlab::comparison {
namespace {

constexpr std::size_t kMostLines = 40;        // of one text's difference
constexpr std::size_t kMostCharacters = 160;  // of a line
constexpr std::size_t kMostTexts = 200;

using Texts = std::vector<text::SourcePtr>;

std::string file_name(std::string_view path) {
  return std::filesystem::path(path).filename().string();
}

std::string shown_line(char sign, std::string_view line) {
  while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
  return sign + text::shown(line, kMostCharacters);
}

// Pieces that differ, each behind a line that says where it begins.
TextDifference difference_of(const text::SourcePtr& a, const text::SourcePtr& b) {
  TextDifference out{{a ? a->name() : "", b ? b->name() : ""}, {}, 0};
  if (!a || !b) return out;
  const std::vector<std::string_view> before = text::lines_of(a->text());
  const std::vector<std::string_view> after = text::lines_of(b->text());
  const std::vector<int> kept = text::kept_lines(before, after);
  const auto add = [&](std::string line) {
    if (out.lines.size() < kMostLines)
      out.lines.push_back(std::move(line));
    else
      ++out.left_out;
  };
  std::size_t in_after = 0;
  bool is_open = false;
  const auto begin_piece = [&](std::size_t line) {
    if (!is_open) add(fmt::format("@ {}", line + 1));
    is_open = true;
  };
  for (std::size_t i = 0; i <= before.size(); ++i) {
    const bool is_kept = i < before.size() && kept[i] >= 0;
    const std::size_t end = i == before.size() ? after.size()
                            : is_kept          ? static_cast<std::size_t>(kept[i])
                                               : in_after;
    for (; in_after < end; ++in_after) {
      begin_piece(i);
      add(shown_line('+', after[in_after]));
    }
    if (is_kept) {
      is_open = false;
      ++in_after;
    } else if (i < before.size()) {
      begin_piece(i);
      add(shown_line('-', before[i]));
    }
  }
  return out;
}

Texts texts_of(const history::History& history) {
  const wire::HistoryBeginning& beginning = history.beginning();
  std::set<std::uint32_t> ids(beginning.mission().texts().begin(), beginning.mission().texts().end());
  if (beginning.environment() != 0) ids.insert(beginning.environment());
  Texts out;
  for (const std::uint32_t id : ids) {
    if (text::SourcePtr source = history.text(id)) out.push_back(std::move(source));
  }
  return out;
}

// Takes out of both what belongs together.
template <class Name>
void pair_up(Texts& a, Texts& b, Name name, std::vector<std::pair<text::SourcePtr, text::SourcePtr>>& out) {
  std::multimap<std::string, text::SourcePtr> theirs;
  for (const text::SourcePtr& source : b) theirs.emplace(name(*source), source);
  Texts left;
  for (const text::SourcePtr& source : a) {
    const auto found = theirs.find(name(*source));
    if (found == theirs.end()) {
      left.push_back(source);
      continue;
    }
    out.emplace_back(source, found->second);
    theirs.erase(found);
  }
  a = std::move(left);
  b.clear();
  for (const auto& [key, source] : theirs) b.push_back(source);
}

void compare_texts(const Both<const history::History*>& histories, Beginning& out) {
  Texts a = texts_of(*histories[0]);
  Texts b = texts_of(*histories[1]);
  std::vector<std::pair<text::SourcePtr, text::SourcePtr>> pairs;
  pair_up(a, b, [](const text::Source& source) { return source.name(); }, pairs);
  // The missions themselves are versions of each other whatever their files are called.
  const auto own = [](const history::History& history) { return history.beginning().mission().path(); };
  pair_up(
      a, b,
      [&](const text::Source& source) {
        return source.name() == own(*histories[0]) || source.name() == own(*histories[1]) ? ""
                                                                                          : source.name();
      },
      pairs);
  pair_up(a, b, [](const text::Source& source) { return file_name(source.name()); }, pairs);
  for (const text::SourcePtr& source : a) pairs.emplace_back(source, nullptr);
  for (const text::SourcePtr& source : b) pairs.emplace_back(nullptr, source);
  std::ranges::stable_sort(pairs, {}, [](const auto& pair) {
    return std::string(pair.first ? pair.first->name() : pair.second->name());
  });
  for (const auto& [one, other] : pairs) {
    if (one && other && one->text() == other->text()) continue;
    if (out.texts.size() < kMostTexts) out.texts.push_back(difference_of(one, other));
  }
}

class Facts {
 public:
  explicit Facts(std::vector<Fact>& out) : out_(out) {}
  void note(std::string what, const std::string& a, const std::string& b, bool matters = true) {
    if (a != b) out_.push_back({std::move(what), {text::shown(a, 200), text::shown(b, 200)}, matters});
  }
  void number(std::string what, double a, double b, bool matters = true) {
    note(std::move(what), fmt::format("{}", a), fmt::format("{}", b), matters);
  }
  void yes_or_no(std::string what, bool a, bool b) {
    note(std::move(what), a ? "yes" : "no", b ? "yes" : "no");
  }

 private:
  std::vector<Fact>& out_;
};

template <class List>
std::string joined(const List& list) {
  std::string out;
  for (const auto& one : list) out += (out.empty() ? "" : ", ") + one;
  return out;
}

void compare_settings(const wire::HistoryMission& a, const wire::HistoryMission& b, Facts& facts) {
  std::map<std::string, Both<std::string>> settings;
  for (const wire::HistorySetting& one : a.set()) settings[one.name()][0] = one.value();
  for (const wire::HistorySetting& one : b.set()) settings[one.name()][1] = one.value();
  for (const auto& [name, values] : settings)
    facts.note("set " + text::shown(name, 80), values[0], values[1]);
  facts.note("typed before", joined(a.typed()), joined(b.typed()));
  facts.note("programs in executables", joined(a.executables()), joined(b.executables()));
}

// In the clock's own time zone.
std::string time_text(const wire::HistoryExecutive& options) {
  constexpr double kLast = 253'402'300'799.0;  // of the year 9999
  const double seconds = options.epoch_seconds() + options.zone_offset();
  if (!(seconds >= 0.0 && seconds <= kLast)) return fmt::format("{} s", seconds);
  return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

void compare_manner(const wire::HistoryBeginning& a, const wire::HistoryBeginning& b, Facts& facts) {
  const wire::HistoryExecutive& one = a.executive();
  const wire::HistoryExecutive& other = b.executive();
  facts.yes_or_no("every question is answered with yes", one.proceed_all(), other.proceed_all());
  facts.number("patience [s]", one.patience(), other.patience());
  facts.number("longest bound [m]", one.bound_length(), other.bound_length());
  facts.number("spacing [m]", one.spacing(), other.spacing());
  facts.number("phase lines count ahead [s]", one.phase_line_ahead(), other.phase_line_ahead());
  facts.note("mission clock at the start", time_text(one), time_text(other), false);
  facts.yes_or_no("time stands still for the operator", a.stands_still_for_operator(),
                  b.stands_still_for_operator());
  facts.yes_or_no("goes on when the mission is done", a.goes_on_when_done(), b.goes_on_when_done());
  facts.yes_or_no("robots elsewhere, in real time", a.is_in_real_time(), b.is_in_real_time());
}

}  // namespace

bool Beginning::is_same() const {
  return texts.empty() && std::ranges::none_of(facts, &Fact::matters);
}

Beginning compare_beginnings(const Both<const history::History*>& histories) {
  Beginning out;
  const wire::HistoryBeginning& a = histories[0]->beginning();
  const wire::HistoryBeginning& b = histories[1]->beginning();
  Facts facts(out.facts);
  facts.note("missionlab", a.version(), b.version());
  facts.note("arithmetic of the machine", fmt::format("{:016x}", a.arithmetic()),
             fmt::format("{:016x}", b.arithmetic()));
  facts.note("mission", a.mission().path(), b.mission().path(), false);
  facts.note("seed", std::to_string(a.seed()), std::to_string(b.seed()));
  if (a.obstacle_seed() != a.seed() || b.obstacle_seed() != b.seed())
    facts.note("seed of obstacles", std::to_string(a.obstacle_seed()), std::to_string(b.obstacle_seed()));
  compare_settings(a.mission(), b.mission(), facts);
  facts.yes_or_no("the world changes", a.environment() != 0, b.environment() != 0);
  compare_manner(a, b, facts);
  compare_texts(histories, out);
  return out;
}

}  // namespace mlab::comparison
