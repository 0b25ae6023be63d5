#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mlab/flow/limit.h"
#include "mlab/text/source.h"

namespace mlab::flow {

/// Where an input takes its value from, as the author wrote it. Names are resolved when the program is built.
struct Source {
  enum class Kind { kConstant, kName };
  Kind kind = Kind::kConstant;
  std::string text;  ///< the constant without quotes, or the name of a node or parameter
  text::Place place;
};

struct Link {
  std::string input;
  Source source;
  text::Place place;  ///< of the input's name
};

/// A constant of the network that has a name and can be set from outside: by NEW-ROBOT, by a slider.
struct Parameter {
  std::string name;
  std::string type;  ///< of TypeInfo::name
  std::string unit;
  std::string help;
  std::vector<std::string> other_names;  ///< by which nodes may name it as well
  Source initial;
  double min = -kNoLimit;
  double max = kNoLimit;
  text::Place place;
  /// The named place of the mission's overlay that it is, of type Point, unless the mission says otherwise.
  struct PlaceName {
    std::string text;  ///< empty: it is none
    text::Place place;
  };
  PlaceName place_name = {};
};

struct Transition {
  Source trigger;  ///< of type bool
  bool is_negated = false;
  std::string target;
  bool restarts = false;  ///< matters where the target is the state itself
  text::Place place;
};

struct State {
  std::string name;
  Source member;
  std::vector<Transition> transitions;
  bool is_start = false;
  bool is_final = false;  ///< may lack a way out
  text::Place place;
};

struct Case {
  std::vector<std::int64_t> values;  ///< empty: everything else
  Source member;
  text::Place place;
};

/// One node: an instance of a behavior, or one of the operators that decide what else is evaluated.
struct Node {
  enum class Kind {
    kBehavior,
    kSequence,  ///< the member of the active state; transitions by triggers
    kSelect,    ///< the member whose case holds the selector's value
    kDelay,     ///< the value that `links[0]` had in the last cycle in which the delay was evaluated; breaks
                ///< loops
  };
  Kind kind = Kind::kBehavior;
  std::string name;      ///< unique in the network; the path of its ports starts with it
  std::string behavior;  ///< name or alias in the library; for operators the type of the output
  text::Place behavior_place;
  std::vector<Link> links;
  std::vector<State> states;
  Source selector;
  std::vector<Case> cases;
  bool is_public = false;  ///< evaluated even if nobody consumes it, because somebody watches it
  text::Place place;       ///< of the node's name
};

/// What a program is built from: parameters, nodes and their wiring, still in the author's words.
struct Network {
  std::string name;
  std::vector<Parameter> parameters;
  std::vector<Node> nodes;
};

}  // namespace mlab::flow
