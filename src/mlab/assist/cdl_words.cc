#include <algorithm>
#include <utility>

#include "mlab/assist/words.h"

namespace mlab::assist {
namespace {

constexpr std::pair<std::string_view, std::string_view> kWords[] = {
    {"use",
     "`use \"FILE\";` reads another configuration, or procedures; in a robot `use DEVICE for BINDING;` "
     "chooses a device"},
    {"architecture", "the family of robots that the file is meant for"},
    {"assemblage", "a skill put together out of others: `assemblage NAME(parameters) -> TYPE { ... }`"},
    {"binding", "what configurations ask for and classes of robots offer"},
    {"class", "a kind of robot: its body and devices"},
    {"robot", "what drives the actuators of a robot: `robot NAME(parameters) is CLASS { ... }`"},
    {"operator", "how members of a society serve binding points: `operator NAME { BINDING = CALL; }`"},
    {"society", "robots together: `society NAME: team of 3 ROBOT by OPERATOR;`"},
    {"test", "what a component does when it is told what it senses: `test \"NAME\" of CALL { ... }`"},
    {"on", "the class of robots that the test runs on; else `Scout`"},
    {"given", "what is sensed from here on: `given obstacle(at = [2 m, 0 m]);`, `given no obstacle;`"},
    {"no", "no longer, or not"},
    {"after", "lets cycles go by: `after 10 cycles;`, `after 2 s;`"},
    {"expect", "what has to be so: `expect length(it) > 0.5;`, `expect within 5 cycles: state Acquiring;`"},
    {"within", "in one of so many cycles: `expect within 5 cycles: ...`"},
    {"state", "the state that a sequence is in: `expect state Acquiring;`"},
    {"action", "what the robot does besides moving: `expect action PickUp;`"},
    {"layout", "where things stand on the designer's canvas; means nothing else"},
    {"note", "words on the designer's canvas: `note 40 200 \"looks around\";`"},
    {"frame", "a frame around nodes on the canvas: `frame 20 20 400 300 \"safety\";`"},
    {"alias", "a historic name of the assemblage"},
    {"let", "a name for one node that any number of readers share"},
    {"as", "names the node: `Noise() as drift`"},
    {"active", "what runs along whenever this is wanted: it moves a sensor"},
    {"not", "true where the trigger is false"},
    {"and", "true where both are"},
    {"or", "true where one of them is"},
    {"delay", "the value of the cycle before; breaks loops"},
    {"initial", "what a `delay` gives in the first cycle"},
    {"cooperate", "cooperation: all members at once, each with its gain in front of a colon"},
    {"compete", "competition: one member at a time, `by priority` or `by strength`"},
    {"priority", "the first member that wants anything"},
    {"strength", "the member with the strongest activation, which stands in front of the colon"},
    {"coordinate", "generic coordination: `coordinate by OPERATOR { ... }`"},
    {"fuse", "perceptual fusion: `fuse by OPERATOR { ... }`"},
    {"sequence", "sequencing: one state at a time, triggers make transitions"},
    {"select", "what the selector says: `select by SELECTOR { case ...: ...; otherwise: ...; }`"},
    {"by", "the operator, rule or selector follows"},
    {"start", "the state that the sequence begins in"},
    {"final", "a state that has no way out on purpose"},
    {"when", "a transition: `when TRIGGER goto STATE;`"},
    {"goto", "the state that the transition leads to"},
    {"restart", "starts the state anew even where it is in it already"},
    {"case", "values of the selector, `:` and what is done then"},
    {"otherwise", "what is done for all other values"},
    {"body", "numbers of the simulated body: `body { radius = 35 cm; }`"},
    {"sensor", "a device that perceives: `sensor NAME: CALL binds BINDING;`"},
    {"actuator", "a device that acts: `actuator NAME: CALL binds BINDING;`"},
    {"binds", "the binding point that the device serves"},
    {"for", "the binding point that the device is to serve; in a test, in each of so many cycles"},
    {"is", "the class of the robot"},
    {"in", "the range of a parameter: `in 0 .. 5`"},
    {"team", "robots that are alike: `team of 3 Forager`"},
    {"of", "how many of which robot; in a test, what is tested"},
    {"caste", "robots that are different: `caste { Forager; Guard; }`"},
};

}  // namespace

std::string_view cdl_word_help(std::string_view word) {
  const auto* const found =
      std::ranges::find(kWords, word, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kWords) ? std::string_view() : found->second;
}

}  // namespace mlab::assist
