// Words of CNL, MDL and ODL.

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "mlab/assist/words.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/odl/token.h"
#include "mlab/mission/failsafe.h"
#include "mlab/mission/tasks.h"

namespace mlab::assist {
namespace {

using Entry = std::pair<std::string_view, std::string_view>;

constexpr Entry kCnl[] = {
    {"procedure", "a behavior: typed inputs, one output, a few lines of C++"},
    {"nprocedure", "a historic kind of procedure, which is refused"},
    {"external", "only the signature: the procedure is compiled elsewhere"},
    {"init", "C++ at file scope, up to `iend`"},
    {"iend", "ends `init`"},
    {"type", "a type of your own: `type <NAME>;`"},
    {"module", "read, and means nothing"},
    {"modulename", "read, and means nothing"},
    {"parameter", "a constant with a name, which missions and sliders set"},
    {"node", "an instance of a procedure: `node NAME is PROCEDURE with INPUT = SOURCE; nend`"},
    {"public", "runs even when nobody needs its value"},
    {"sequence", "one state at a time: `sequence NAME of TYPE with ... nend`"},
    {"select", "the member of the case that holds the selector's value"},
    {"delay", "the value of the cycle before; breaks loops"},
    {"with", "inputs or links follow"},
    {"nend", "ends a node"},
    {"once", "C++ that runs in the first cycle in which the node runs at all"},
    {"header", "C++ that runs whenever the node starts"},
    {"body", "C++ that runs in every cycle in which the node runs"},
    {"pend", "ends a procedure"},
    {"pure", "nothing but the inputs counts, so equal calls are shared"},
    {"latency", "the value comes that many cycles after its inputs"},
    {"senses", "which sensor is read, `within` how far"},
    {"within", "how far the sensor is read: metres, or an input"},
    {"alias", "what historic networks call it"},
    {"list", "the input takes any number of links"},
    {"in", "the range of the values that may be set"},
    {"state", "`state NAME is MEMBER;`"},
    {"start", "the state that the sequence begins in"},
    {"final", "a state that has no way out on purpose"},
    {"when", "a transition: `when TRIGGER goto STATE;`"},
    {"not", "where the trigger is false"},
    {"goto", "the state that the transition leads to"},
    {"restart", "starts the state's nodes anew even where it is in it already"},
    {"case", "values of the selector"},
    {"otherwise", "all other values"},
};

constexpr Entry kMdl[] = {
    {"MISSION NAME", "the title of the mission"},
    {"SCENARIO", "a second title"},
    {"OVERLAY", "`OVERLAY file`: loads a map"},
    {"MISSION-AREA", "`MISSION-AREA width height` in metres"},
    {"LOAD-MAP", "`LOAD-MAP file`: a background picture"},
    {"SP", "`SP name x y`: a start place"},
    {"OBSTACLE", "`OBSTACLE x y radius` in metres"},
    {"CREATE-OBSTACLES", "random obstacles, in place of all others"},
    {"NEW-ROBOT", "`NEW-ROBOT type program [colour [host]] [(parameters)]`: a type of robots"},
    {"UNIT", "in the preamble `UNIT <name> robots`: a group of robots; in a step `UNIT name action`"},
    {"SET", "`SET option value`"},
    {"PRINT", "prints what is known of the map or of the robots"},
    {"FAILSAFE",
     "`FAILSAFE condition action`: what a robot does when something is wrong, whatever its program says"},
    {"COMMAND LIST:", "the steps follow"},
    {"QUIT", "ends the run"},
    {"AND", "another command that begins together with this one"},
    {"TIMEOUT", "seconds, from when the unit is in place"},
    {"ACKNOWLEDGE", "a text that the operator acknowledges"},
    {"WAIT", "the unit halts until it is acknowledged"},
    {"ROBOT", "in the preamble the standard robot; in a step `ROBOT number action`: one robot by its number"},
    {"ROBOTS", "`ROBOTS numbers action`: robots that are a unit as long as the command lasts"},
};

std::string_view found(std::span<const Entry> words, std::string_view word, bool is_exact) {
  const auto one = std::ranges::find_if(words, [&](const Entry& entry) {
    return is_exact ? entry.first == word : mdl::equal_without_case(entry.first, word);
  });
  return one == words.end() ? std::string_view() : one->second;
}

}  // namespace

std::string_view cnl_word_help(std::string_view word) {
  return found(kCnl, word, true);
}
std::string mdl_word_help(std::string_view word) {
  for (const mission::TaskInfo& task : mission::kTasks) {
    if (!mdl::equal_without_case(task.word, word)) continue;
    return task.place.empty() ? std::string(task.help)
                              : fmt::format("`{} {}`: {}", task.word, task.place, task.help);
  }
  for (const mission::ClauseInfo& clause : mission::kClauses) {
    if (mdl::equal_without_case(clause.word, word)) return std::string(clause.help);
  }
  for (const mission::FailsafeConditionInfo& condition : mission::kFailsafeConditions) {
    if (mdl::equal_without_case(condition.word, word)) return std::string(condition.help);
  }
  for (const mission::FailsafeActionInfo& action : mission::kFailsafeActions) {
    if (mdl::equal_without_case(action.word, word)) return std::string(action.help);
  }
  return std::string(found(kMdl, word, false));
}
std::string_view odl_word_help(std::string_view word) {
  const odl::Keyword keyword = odl::find_keyword(word);
  const auto one = std::ranges::find(odl::words(), keyword, &odl::Word::keyword);
  return one == odl::words().end() ? std::string_view() : one->help;
}

}  // namespace mlab::assist
