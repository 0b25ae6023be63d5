#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/export/format.h"
#include "mlab/text/source.h"

namespace mlab::exports {

struct Argument;

/// A constant, or the call of a skill or percept with its arguments, parameters resolved.
struct Value {
  enum class Kind { kNumber, kText, kWord, kList, kCall };
  Kind kind = Kind::kWord;
  double number = 0.0;              ///< in SI units
  std::string text;                 ///< text, word, or what is called
  std::vector<Value> items;         ///< kList
  std::vector<Argument> arguments;  ///< kCall
};
struct Argument {
  std::string name;
  Value value;
};

/// When a transition is made.
struct Condition {
  enum class Kind { kValue, kNot, kAnd, kOr };
  Kind kind = Kind::kValue;
  Value value;
  std::vector<Condition> operands;
};

struct Plan;

/// A state of a plan: one skill, or a plan of its own.
struct Step {
  struct Exit {
    Condition condition;
    std::size_t target = 0;  ///< index of the step
    bool restarts = false;
    text::Place place;
  };
  std::string name;
  bool is_final = false;
  Value skill;
  std::unique_ptr<Plan> plan;  ///< null: `skill` holds
  std::vector<Exit> exits;
  text::Place place;
};

/// A sequenced assemblage as plans see it.
struct Plan {
  std::string name;
  std::size_t start = 0;
  std::vector<Step> steps;
  text::Place place;
};

/// What drives the robot's first actuator, as a plan: an assemblage that is a sequence is one inside, one
/// that only calls another stands for that, any other is a skill.
///
/// @param format  for messages: `SAUSAGES`
/// @return  null where the robot has no such shape
/// @errors  `no-sequence`, `no-skill` (an operator right in a state), `nested-too-deep`
std::unique_ptr<Plan> plan_of(const Subject& subject, const char* format, text::Diagnostics& sink);

}  // namespace mlab::exports
