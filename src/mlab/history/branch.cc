#include "mlab/history/branch.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/text/one_line.h"
#include "mlab/text/shown.h"

namespace mlab::history {
namespace {

bool is_of_program(const std::string& path) {
  constexpr std::array<std::string_view, 5> kEndings = {".cdl", ".cnl", ".cc", ".h", ".toml"};
  return std::ranges::any_of(kEndings, [&](std::string_view ending) { return path.ends_with(ending); });
}

// What a line says is read against what is known; nothing is read from this machine's disk for it.
mdl::LoadOptions options_without_files() {
  mdl::LoadOptions out;
  out.files.is_file = [](const std::string&) { return false; };
  out.files.read = [](const std::string& path) -> text::Result<text::SourcePtr> {
    text::Diagnostic missing;
    missing.kind = "cannot-read";
    missing.message = fmt::format("cannot read `{}` here", text::shown(path));
    return std::unexpected(std::move(missing));
  };
  return out;
}

// Its place is in the line, which has no file.
std::string sentence_of(const std::string& line, const text::Diagnostics& problems) {
  const auto first = std::ranges::find(problems.items(), text::Severity::kError, &text::Diagnostic::severity);
  if (first == problems.items().end())
    return fmt::format("the order `{}` can't be understood", text::shown(line, 200));
  text::Diagnostic problem = *first;
  std::string where;
  if (const text::SourcePtr source = std::exchange(problem.place.source, nullptr))
    where = fmt::format(", column {}", source->line_column(problem.place.span.begin).column);
  return fmt::format("the order `{}`{}: {}", text::shown(line, 200), where, text::one_line(problem));
}

class Brancher {
 public:
  Brancher(const History& from, const Departure& departure)
      : from_(from), departure_(departure), version_(from.version_at(departure.cycle)) {}

  std::expected<Branch, std::string> make(const mission::Mission& mission) {
    begin();
    std::size_t next = 0;
    const std::vector<InputEntry>& inputs = from_.inputs();
    for (; next < inputs.size() && inputs[next].moment.cycle < departure_.cycle; ++next) {
      copy_failures(inputs[next].moment.cycle);
      copy(inputs[next]);
    }
    copy_failures(departure_.cycle);
    if (auto problem = change_texts()) return std::unexpected(std::move(*problem));
    if (auto problem = type_lines(mission)) return std::unexpected(std::move(*problem));
    for (; departure_.with_later && next < inputs.size(); ++next) {
      copy_failures(inputs[next].moment.cycle);
      if (!inputs[next].input.has_exchanged() || !is_another_version_) copy(inputs[next]);
    }
    if (departure_.with_later) copy_failures(from_.last_cycle());
    if (problem_) return std::unexpected(std::move(*problem_));
    out_.history->reach(departure_.cycle, departure_.time);
    return std::move(out_);
  }

 private:
  void put(std::uint64_t cycle, double time, wire::HistoryEntry entry) {
    entry.set_cycle(cycle);
    entry.set_time(time);
    if (auto problem = out_.history->add(entry); problem && !problem_) problem_ = std::move(problem);
  }

  void put_text(std::uint32_t id, std::string_view path, std::string_view content, std::uint64_t cycle,
                double time) {
    wire::HistoryEntry entry;
    entry.mutable_text()->set_id(id);
    entry.mutable_text()->set_path(std::string(path));
    entry.mutable_text()->set_content(std::string(content));
    last_text_ = std::max(last_text_, id);
    put(cycle, time, std::move(entry));
  }

  // All texts of a version; those that are there already are not told again.
  void put_texts(const wire::HistoryMission& version) {
    for (const std::uint32_t id : version.texts()) put_known_text(id);
  }

  void put_known_text(std::uint32_t id) {
    if (id == 0 || out_.history->text(id)) return;
    const text::SourcePtr text = from_.text(id);
    if (text) put_text(id, text->name(), text->text(), 0, 0.0);
  }

  // Texts come first: so no later one has the number of one that departs.
  void begin() {
    const wire::HistoryBeginning& beginning = from_.beginning();
    put_texts(beginning.mission());
    put_known_text(beginning.environment());
    for (const InputEntry& one : from_.inputs()) put_texts(one.input.exchanged().mission());
    wire::HistoryEntry entry;
    *entry.mutable_beginning() = beginning;
    put(0, 0.0, std::move(entry));
  }

  void copy(const InputEntry& input) {
    wire::HistoryEntry entry;
    *entry.mutable_input() = input.input;
    put(input.moment.cycle, std::max(input.time, out_.history->last_time()), std::move(entry));
  }

  // Programs that failed up to a cycle: what came in behind it comes later.
  void copy_failures(std::uint64_t cycle) {
    wire::HistoryEntry entry;
    const auto copy_to = [&](History::Failures::const_iterator& next, const History::Failures& all,
                             auto add) {
      for (; next != all.end() && next->first.cycle <= cycle; ++next) {
        auto& out = *add();
        out.set_before(static_cast<std::uint32_t>(cycle - next->first.cycle));
        out.set_robot(next->first.robot);
        if constexpr (requires { out.set_start(1); }) out.set_start(next->first.start);
        out.set_failure(next->second);
      }
    };
    wire::HistoryAnswers& out = *entry.mutable_answers();
    copy_to(next_not_started_, from_.not_started(), [&] { return out.add_not_started(); });
    copy_to(next_failed_, from_.failed(), [&] { return out.add_failed(); });
    if (out.not_started().empty() && out.failed().empty()) return;
    put(cycle, out_.history->last_time(), std::move(entry));
  }

  void exchange(bool takes_over) {
    is_another_version_ = true;
    wire::HistoryEntry entry;
    *entry.mutable_input()->mutable_exchanged()->mutable_mission() = version_;
    entry.mutable_input()->mutable_exchanged()->set_takes_over(takes_over);
    put(departure_.cycle, departure_.time, std::move(entry));
  }

  std::optional<std::string> change_texts() {
    bool changes = false;
    for (const auto& [path, content] : departure_.texts) {
      const auto id = std::ranges::find_if(*version_.mutable_texts(), [&, &name = path](std::uint32_t one) {
        return from_.text(one) && from_.text(one)->name() == name;
      });
      if (id == version_.mutable_texts()->end())
        return fmt::format("there is no text `{}` that the mission of that moment is made from",
                           text::shown(path));
      if (from_.text(*id)->text() == content) continue;
      *id = last_text_ + 1;
      put_text(*id, path, content, departure_.cycle, departure_.time);
      changes = true;
      out_.takes_over = out_.takes_over || is_of_program(path);
    }
    if (changes) exchange(out_.takes_over);
    return std::nullopt;
  }

  std::optional<std::string> type_lines(const mission::Mission& mission) {
    std::shared_ptr<const mission::Mission> edited;
    for (const std::string& line : departure_.lines) {
      text::Diagnostics problems;
      const auto read =
          mdl::parse_immediate(line, edited ? *edited : mission, problems, options_without_files());
      if (!read) return sentence_of(line, problems);
      if (read->edited) {
        edited = read->edited;
        version_.add_typed(line);
        exchange(false);
      }
      if (read->commands.empty()) continue;
      wire::HistoryEntry entry;
      entry.mutable_input()->mutable_posted()->set_kind(wire::HistoryPosted::TYPED);
      entry.mutable_input()->mutable_posted()->set_line(line);
      put(departure_.cycle, departure_.time, std::move(entry));
    }
    return std::nullopt;
  }

  const History& from_;
  const Departure& departure_;
  wire::HistoryMission version_;
  bool is_another_version_ = false;
  std::uint32_t last_text_ = 0;
  History::Failures::const_iterator next_not_started_ = from_.not_started().begin();
  History::Failures::const_iterator next_failed_ = from_.failed().begin();
  Branch out_{std::make_shared<History>(), false};
  std::optional<std::string> problem_;
};

}  // namespace

std::expected<Branch, std::string> branch(const History& from, const Departure& departure,
                                          const mission::Mission& mission) {
  return Brancher(from, departure).make(mission);
}

}  // namespace mlab::history
