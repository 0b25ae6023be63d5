#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::cdl {

/// A word as its author wrote it, and where. Empty text: it was not said.
struct Word {
  std::string text;
  text::Place place;
};

struct Expression;
using ExpressionPtr = std::shared_ptr<const Expression>;

/// Where a value should stand and none does: only in what is read as it is written (`read_as_written`).
struct Hole {};

// Of what stands in a file a `whole` says from where to where. What was changed since has none: it is printed
// from its parts, while what has one is taken over as it stands there (`reprint`).

/// `2 m`, `-0.5`, `30 deg`
struct Number {
  double value = 0.0;  ///< in the unit as written
  /// Empty: none said; with a place, then one could stand there, where the text ends.
  Word unit;
  text::Span whole = {};
};

/// `"Flag|Basket"`, without its quotes; there are no escapes.
struct Text {
  std::string value;
};

/// A name without parentheses: a `let`, a parameter, or a word of the type that is wanted (`Orange`, `true`).
struct Name {
  Word name;
};

/// `[a, b, c]`: for a list input.
struct List {
  std::vector<ExpressionPtr> items;
};

/// `name = value`, or just the value: by position, before those with a name.
struct Argument {
  Word name;
  ExpressionPtr value;
};

/// `Wander(curious = 0.8)`: an assemblage, a procedure or a binding point.
struct Call {
  Word callee;
  std::vector<Argument> arguments;
  bool is_closed = true;        ///< its `)` stands there
  bool has_parentheses = true;  ///< `coordinate by Operator { ... }` has none
};

enum class Connective { kNot, kAnd, kOr };
/// `not a`, `a and b`, `a or b`.
struct Logic {
  Connective connective = Connective::kNot;
  std::vector<ExpressionPtr> operands;
};

/// What a sign between two values, or before one, means.
enum class Operation {
  kNegate,
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kLess,
  kLessOrEqual,
  kGreater,
  kGreaterOrEqual,
  kEqual,
  kUnequal
};
/// `-a`, `a + b - c`, `a * b / c`, `a < b`: what is on one level of precedence, computed from the left.
/// Functions such as `min(a, b)` are calls.
struct Arithmetic {
  std::vector<Operation> operations;  ///< of `-a` one, else one less than operands
  std::vector<ExpressionPtr> operands;
};

/// One member of an operator: `0.8: Noise(persistence = 10 s) as drift;`
struct Member {
  ExpressionPtr weight;  ///< in front of the colon; null: none said
  ExpressionPtr value;
  std::string help;  ///< `///` lines above it
};

/// `cooperate { ... }`: weighted sum.
struct Cooperate {
  std::vector<Member> members;
};

enum class CompetitionRule { kPriority, kStrength };
/// `compete by priority { ... }`: the first member that wants anything. `compete by strength { ... }`: the
/// member with the strongest activation, which stands in front of the colon; without one its vector's length.
struct Compete {
  CompetitionRule rule = CompetitionRule::kPriority;
  Word rule_word;
  std::vector<Member> members;
};

/// `coordinate by Operator(argument = ...) { ... }`: any operator of the library. Members go to its first
/// list input, what stands in front of a colon to the list input behind it.
struct Coordinate {
  Call by;
  std::vector<Member> members;
};

/// `fuse by Operator(...) { ... }`: the same over percepts.
struct Fuse {
  Call by;
  std::vector<Member> members;
};

/// `when Detect(attractor) goto Acquiring;`
struct Transition {
  ExpressionPtr trigger;
  Word target;
  bool restarts = false;  ///< `goto Searching restart`: matters where the target is the state itself
  std::string help;
  text::Place place;
};

/// `start Searching: Wander();` and the transitions below it.
struct State {
  Word name;
  bool is_start = false;
  bool is_final = false;
  ExpressionPtr member;
  std::vector<Transition> transitions;
  std::string help;
  text::Place place;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

/// `sequence { ... }`: over movements, or over percepts.
struct Sequence {
  std::vector<State> states;
};

/// `case 2, 4, 5: navigate;` without values: `otherwise: stand;`
struct Case {
  std::vector<Word> values;  ///< whole numbers, or words of the selector's type
  ExpressionPtr member;
  text::Place place;
};

/// `select by task { case MoveTo: ...; otherwise: ...; }`
struct Select {
  ExpressionPtr by;
  std::vector<Case> cases;
};

/// `delay(value, initial = 0)`: the value of the cycle before; breaks loops.
struct Delay {
  ExpressionPtr value;
  ExpressionPtr initial;  ///< null: the type's zero
};

/// Anything that has a value. `as NAME` names its node; else the node is called as what it instantiates.
struct Expression {
  std::variant<Hole, Number, Text, Name, List, Call, Logic, Arithmetic, Cooperate, Compete, Coordinate, Fuse,
               Sequence, Select, Delay>
      what;
  Word as;
  ExpressionPtr active;   ///< `... active LookAt(...)`: the part that moves a sensor; null: none
  text::Place place;      ///< of the whole expression
  text::Span whole = {};  ///< with the parentheses around it
};

/// `sphere: double [m] = 1 m in 0 .. 100`
struct Parameter {
  Word name;
  Word type;  ///< of flow's types, or one of the quantities `gain`, `length`, `speed`, `angle`, `duration`,
              ///< ...
  Word unit;
  ExpressionPtr initial;  ///< null: has to be given
  std::optional<Number> low;
  std::optional<Number> high;
  std::string help;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

/// `let obstacles = DetectObstacles(range = 30 m);`: one node, any number of readers.
struct Let {
  Word name;
  ExpressionPtr value;
  std::string help;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

struct Assemblage {
  Word name;
  std::vector<Parameter> parameters;
  Word result_type;  ///< behind `->`; empty: as its body has
  std::vector<Let> lets;
  ExpressionPtr body;  ///< null: declared and empty (an import that knew no more); stands still
  std::string help;
  std::vector<Word> historic_names;  ///< `alias "MOVE_TO";`
  bool has_braces = false;           ///< though nothing may stand between them
  text::Span whole = {};             ///< from its first word to its end, without its help
};

/// `binding sense_obstacles(range: length) -> Obstacles;`: what configurations ask for and robot classes
/// offer.
struct Binding {
  Word name;
  std::vector<Parameter> parameters;
  Word result_type;  ///< empty: an actuator
  std::string help;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

/// `sensor sonars: SonarObstacles(...) binds sense_obstacles;`, `actuator base: SynchroDrive(...) binds
/// movement;`
struct Device {
  bool is_actuator = false;
  Word name;
  Call by;  ///< the procedure or assemblage that serves it; the binding's own arguments are added to these
  Word binds;
  std::string help;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

/// A number that the simulated body has: `radius = 0.35 m;`
struct BodySetting {
  Word name;
  ExpressionPtr value;
};

/// `class MRV2 { body { radius = 0.35 m; } sensor ...; actuator ...; }`
struct RobotClass {
  Word name;
  std::vector<Parameter> parameters;
  bool has_parentheses = false;  ///< though nothing may stand between them
  std::vector<BodySetting> body;
  std::vector<Device> devices;
  std::string help;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

/// `movement = Forage(attractor = attractor);`: what an actuator of the robot is driven by.
struct Drive {
  Word binding;  ///< or the device's own name, where several serve the binding
  ExpressionPtr value;
};

/// `use sonars for sense_obstacles;`: which device, where several fit.
struct Choice {
  Word device;
  Word binding;
};

/// `robot Forager(attractor: object_class = Orange) is MRV2 { movement = ...; }` Its parameters can be set by
/// a mission's NEW-ROBOT.
struct Robot {
  Word name;
  std::vector<Parameter> parameters;
  bool has_parentheses = false;  ///< though nothing may stand between them
  Word class_name;               ///< empty: abstract
  std::vector<Let> lets;
  std::vector<Choice> choices;
  std::vector<Drive> drives;
  std::string help;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

/// Of a society, and of each team in it.
inline constexpr int kMostRobotsOfASociety = 10'000;

/// `team of 3 Forager`, `caste { ... }`, or the name of a robot or society.
struct SocietyMember {
  enum class Kind { kName, kTeam, kCaste };
  Kind kind = Kind::kName;
  Word name;                           ///< kName, kTeam: a robot or society
  int count = 1;                       ///< kTeam
  std::vector<SocietyMember> members;  ///< kCaste
  Word by;                             ///< the operator that coordinates it; empty: none
  text::Place place;
};

/// `society Foragers: team of 3 Forager by DistinctTargets;`
struct Society {
  Word name;
  SocietyMember what;
  std::string help;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

/// `operator DistinctTargets { choose_target = ClaimClosest(...); }`: how members of a society serve binding
/// points while they are in it.
struct SocietyOperator {
  Word name;
  std::vector<Device> devices;
  std::string help;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

/// `use "skills.cdl";`
struct Use {
  Word path;
  text::Span whole = {};
};

/// `architecture UGV;`
struct Architecture {
  Word name;
  text::Span whole = {};
};

/// Where a node of a drawing stands, by its name inside of its owner.
struct LayoutEntry {
  Word node;
  double x = 0.0;
  double y = 0.0;
  text::Span whole = {};
};

/// A comment on the canvas (`note 40 200 "words";`, perhaps `note 40 200 120 60 "words";`), or a frame around
/// nodes (`frame 20 20 400 300 "words";`). Texts behind each other are its lines.
struct LayoutNote {
  bool is_frame = false;
  double x = 0.0;
  double y = 0.0;
  double width = 0.0;  ///< 0: as wide as its words
  double height = 0.0;
  std::vector<std::string> lines;
  text::Place place;  ///< of the statement, without its `;`
  text::Span whole = {};
};

/// `layout Wander { Noise 120 40; Probe 120 160; }` at the end of the file.
struct Layout {
  Word owner;  ///< empty: the file, whose declarations are laid out; its place is where it would stand
  std::vector<LayoutEntry> entries;
  std::vector<LayoutNote> notes;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

/// `given obstacle(at = [2 m, 0 m]);`, `given no obstacle;`, `after 10 cycles;`, `expect it;`,
/// `expect within 5 cycles: state Acquiring;`, `expect for 2 s: no action PickUp;`
struct TestStep {
  enum class Kind { kGiven, kGivenNo, kExpect, kAfter };
  enum class When { kNow, kWithin, kFor };
  enum class About { kCondition, kState, kAction };
  Kind kind = Kind::kGiven;
  Call percept;                     ///< kGiven; of kGivenNo only the callee
  When when = When::kNow;           ///< kExpect
  Number span;                      ///< kAfter, and an expectation with `within` or `for`
  About about = About::kCondition;  ///< kExpect
  bool is_negated = false;          ///< `no state X`
  ExpressionPtr condition;          ///< kCondition
  Word fact;                        ///< name of the state, perhaps `Outer.Inner`, or of the action
  text::Place place;                ///< of the statement, without its `;`
  std::string help;                 ///< `///` lines above it
  text::Span whole = {};            ///< from its first word to its end, without its help
};

/// `test "turns away" of AvoidStaticObstacles(...) on Scout { given ...; expect ...; }`: what a component
/// does when it is told what it senses.
struct Test {
  Word name;              ///< its place is that of the text with its quotes
  ExpressionPtr subject;  ///< `as` says what its value is called in conditions; else `it`
  Word class_name;        ///< on whose sensors it runs; empty: `Scout`
  std::vector<Let> lets;
  std::vector<TestStep> steps;
  std::string help;
  text::Span whole = {};  ///< from its first word to its end, without its help
};

using Item = std::variant<Use, Architecture, Assemblage, Binding, RobotClass, Robot, SocietyOperator, Society,
                          Test, Layout>;

/// One file, as it was written. After errors it has holes, never wrong parts.
struct Tree {
  text::SourcePtr source;  ///< null where the tree was made by a program
  std::vector<Item> items;
};

}  // namespace mlab::cdl
