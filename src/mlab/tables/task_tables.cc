#include "mlab/tables/task_tables.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/lang/mdl/token.h"
#include "mlab/mission/tasks.h"
#include "mlab/percept/formation_names.h"

namespace mlab::tables {
namespace {

using mission::ClauseKind;
using mission::kTasks;
using mission::TaskInfo;

// Longer ones first, so that a regular expression doesn't stop at `LINE` of `LINE-LEFT`.
std::string alternatives(std::vector<std::string_view> words) {
  std::ranges::stable_sort(words, std::greater(), &std::string_view::size);
  return fmt::format("{}", fmt::join(words, "|"));
}

template <class Fits>
std::vector<std::string_view> keywords(Fits fits) {
  std::vector<std::string_view> out;
  for (const mdl::Keyword& one : mdl::keywords()) {
    if (one.kind == mdl::TokenKind::kWord && fits(one.word)) out.push_back(one.text);
  }
  return out;
}

std::vector<std::string_view> task_keywords(bool only_with_place) {
  return keywords([&](mdl::Word word) {
    const std::optional<mission::Task> task = mdl::task_of(word);
    return task && !(only_with_place && mission::info(*task).place.empty());
  });
}

std::vector<std::string_view> clauses_of(mission::Task task) {
  std::vector<std::string_view> out;
  for (const mission::ClauseInfo& clause : mission::kClauses) {
    if (mission::takes(task, clause.kind)) out.push_back(clause.word);
  }
  return out;
}

// No formation comes last: it is what one says to have none.
template <class Get>
std::vector<std::string_view> formations(Get get) {
  std::vector<std::string_view> out;
  for (const percept::FormationInfo& one : percept::kFormations) {
    if (one.formation != percept::Formation::kNone) out.push_back(get(one));
  }
  out.push_back(get(percept::kFormations[0]));
  return out;
}
constexpr auto kName = [](const percept::FormationInfo& one) { return one.name; };
constexpr auto kKeyword = [](const percept::FormationInfo& one) { return one.keyword; };

// What stands behind the word, in the grammar.
std::string_view place_in_grammar(std::string_view place) {
  if (place == "line" || place == "area") return "name";
  if (place == "places") return "place { place }";
  return place == "place [dx dy]" ? "place [ NUMBER NUMBER ]" : place;
}

}  // namespace

std::string task_rows() {
  std::vector<const TaskInfo*> in_order;
  for (const TaskInfo& one : kTasks) {
    if (!one.label.empty()) in_order.push_back(&one);
  }
  std::ranges::sort(in_order, {}, &TaskInfo::menu);
  std::string out;
  for (const TaskInfo* one : in_order) {
    out += fmt::format(
        "  {{\n    task: \"{}\",\n    label: \"{}\",\n    help: \"{}\",\n    takesFormation: {},\n"
        "    takesHeading: {},\n    takesTechnique: {},\n    takesSpeed: {},\n    takesSwath: {},\n"
        "    place: \"{}\",\n  }},\n",
        one->word, one->label, one->purpose, mission::takes(one->task, ClauseKind::kFormation),
        mission::takes(one->task, ClauseKind::kHeading), mission::takes(one->task, ClauseKind::kTechnique),
        mission::takes(one->task, ClauseKind::kSpeed), mission::takes(one->task, ClauseKind::kSwath),
        one->place);
  }
  return out;
}

std::string formation_names() {
  std::string out;
  for (const std::string_view name : formations(kName)) out += fmt::format("  \"{}\",\n", name);
  return out;
}

std::string task_documentation() {
  std::string out = "| command | what it does | clauses |\n|---|---|---|\n";
  for (const TaskInfo& one : kTasks) {
    const std::vector<std::string_view> clauses = clauses_of(one.task);
    out += fmt::format("| `{}{}{}` | {} | {} |\n", one.word, one.place.empty() ? "" : " ", one.place,
                       one.meaning, clauses.empty() ? "none" : fmt::format("{}", fmt::join(clauses, " ")));
  }
  return out;
}

std::string task_ends() {
  std::string out = "| command | the command is done when |\n|---|---|\n";
  for (const TaskInfo& one : kTasks) out += fmt::format("| {} | {} |\n", one.word, one.done);
  return out;
}

std::string task_grammar() {
  std::string out = "```ebnf\n";
  for (const TaskInfo& one : kTasks) {
    const std::string_view place = place_in_grammar(one.place);
    out += fmt::format("{} \"{}\"{}{}{}\n", &one == kTasks.data() ? "action      =" : "            |",
                       one.word, place.empty() ? "" : " ", place, one.clauses != 0 ? " { clause }" : "");
  }
  out.pop_back();
  return out + " ;\n```\n";
}

std::string formation_documentation() {
  return fmt::format("Formations are `{}`.\n", fmt::join(formations(kName), "`, `"));
}

std::string mdl_placed_words() {
  return alternatives(task_keywords(true));
}
std::string mdl_task_words() {
  return alternatives(task_keywords(false));
}
std::string mdl_task_string() {
  return fmt::format("  \"{} QUIT\",\n", fmt::join(task_keywords(false), " "));
}
std::string mdl_statement_words() {
  return alternatives(keywords(mdl::is_statement));
}
std::string mdl_clause_words() {
  return alternatives(keywords(mdl::is_clause));
}
std::string mdl_option_words() {
  return alternatives(keywords(mdl::is_option));
}

std::string mdl_word_string() {
  std::string out;
  for (const auto fits : {mdl::is_statement, mdl::is_clause, mdl::is_option}) {
    std::string line;
    for (const std::string_view each : keywords(fits)) {
      if (line.size() + each.size() > 110) out += "  " + line + "\n", line.clear();
      line += (line.empty() ? "" : " ") + std::string(each);
    }
    out += "  " + line + "\n";
  }
  return out;
}

std::string formation_words() {
  return alternatives(formations(kName));
}
std::string formation_string() {
  return fmt::format("  {}\n", fmt::join(formations(kKeyword), " "));
}

std::string mdl_dictionary() {
  std::string out;
  for (const mdl::Keyword& one : mdl::keywords()) out += fmt::format("\"{}\"\n", one.text);
  return out;
}

}  // namespace mlab::tables
