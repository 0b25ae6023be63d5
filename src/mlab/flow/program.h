#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/behavior.h"
#include "mlab/flow/frame.h"
#include "mlab/flow/interventions.h"
#include "mlab/flow/library.h"
#include "mlab/flow/limit.h"
#include "mlab/flow/network.h"
#include "mlab/percept/needs.h"
#include "mlab/text/diagnostic.h"

namespace mlab::flow {

class AsyncRunner;

/// A value of a program that has a name: a parameter, a constant of a node (`node.input`), or a node's output
/// (`node`).
struct Port {
  enum class Role : std::uint8_t { kParameter, kConstant, kOutput };
  std::string path;
  Role role = Role::kOutput;
  const TypeInfo* type = nullptr;
  std::string
      unit;  ///< of the value as it stands in the frame; angles are in radians whatever the author wrote
  std::string help;
  std::uint32_t offset = 0;  ///< in the frame
  double min = -kNoLimit;    ///< of what may be set, in `edge_unit`
  double max = kNoLimit;
  std::string edge_unit;  ///< in which people set and read it: `deg` where the author said so
};

/// What one member adds to a weighted sum in the cycle that ran last.
struct Contribution {
  std::string sum;        ///< path of the node that adds
  std::string member;     ///< path of the node that is added
  geom::Vector weighted;  ///< gain times value [share of full strength, robot frame]
};

/// A node of a program with the wires that come into it, for who looks for what a value was made from.
struct NodeWires {
  const Behavior* behavior = nullptr;  ///< null: a sequence, a selection, a delay
  std::uint32_t output = 0;            ///< offset of its value
  std::vector<std::uint32_t> sources;  ///< offsets of what it may read: triggers and members, too
  bool is_delay = false;               ///< it gives what its source was in the cycle before
};

/// A network made ready to run: operations in order and a port table. Immutable, shared by all robots of a
/// kind; the values are in a Frame for each robot. `step` uses no heap, no strings, no locks.
///
/// All that only reads a frame takes any bytes in it, as a process that is not trusted may have left them.
class Program {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  /// One operation of the cycle. The order within a block is the order of execution.
  struct Instruction : Firing {
    enum class Kind : std::uint8_t { kFire, kSequence, kSelect, kDelay, kStartAsync };
    Kind kind = Kind::kFire;
    bool is_guarded = false;      ///< stands in several blocks: fires once a cycle
    std::uint32_t stamp = kNone;  ///< offset of the cycle in which it fired last; kNone: nobody needs to know
    std::uint32_t inputs = 0;     ///< index into words
    std::uint32_t data = 0;       ///< index into sequences, selects, delays, asyncs
    FireFunction fire = nullptr;
  };
  /// Instructions that run together.
  struct Block {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    // What they need, each once, and their sequences: with those of whatever case a select may choose.
    std::uint32_t first_need = 0;
    std::uint32_t need_count = 0;
    std::uint32_t first_sequence = 0;
    std::uint32_t sequence_count = 0;
  };
  struct TransitionCode {
    std::uint32_t trigger = 0;  ///< offset of a bool
    bool is_negated = false;
    bool restarts = false;
    std::uint32_t target = 0;  ///< index of the state
  };
  struct StateCode {
    Block triggers;
    Block member;
    std::uint32_t value = 0;  ///< offset of the member's value
    std::vector<TransitionCode> transitions;
  };
  struct SequenceCode {
    std::uint32_t active = 0;     ///< offset of the index of the active state
    std::uint32_t stamp = kNone;  ///< offset of the cycle in which it ran last
    std::uint32_t start = 0;
    std::uint32_t value_size = 0;
    std::vector<StateCode> states;

    /// Index of the active state; the start where the frame names none that there is.
    std::uint32_t active_in(const std::byte* frame) const;
  };
  struct CaseCode {
    Block member;
    std::uint32_t value = 0;
  };
  struct SelectCode {
    struct Choice {
      std::int64_t value = 0;
      std::uint32_t index = 0;  ///< of the case
    };
    std::uint32_t selector = 0;
    std::uint32_t selector_size = 4;
    std::uint32_t value_size = 0;
    std::int32_t otherwise = -1;  ///< -1: there is none
    std::vector<CaseCode> cases;
    /// Index of the case, by the value; -1: none. All values of one byte have a place in it.
    std::vector<std::int32_t> direct;
    std::vector<Choice> choices;  ///< of values that `direct` has no place for

    /// The case of the selector's value; null where there is none.
    const CaseCode* chosen_in(const std::byte* frame) const;
  };
  struct DelayCode {
    std::uint32_t stamp = 0;
    std::uint32_t source = 0;
    std::uint32_t next = 0;  ///< what it will put out in its next cycle
    std::uint32_t initial = 0;
    std::uint32_t value_size = 0;
  };
  struct AsyncCode {
    const Behavior* behavior = nullptr;
    std::uint32_t started = 0;           ///< offset of the cycle in which the running job began; 0: none runs
    std::uint32_t fresh = 0;             ///< offset of a bool: the value came in this cycle
    std::uint32_t captured = 0;          ///< offset where the inputs of the running job are kept
    std::vector<std::uint32_t> sources;  ///< per captured input: offset of its source
    std::vector<std::uint32_t> captured_offsets;  ///< and where it is kept
    std::vector<std::uint32_t> sizes;
    std::uint32_t output_size = 0;
  };
  struct NeedCode {
    percept::Sensor sensor = percept::Sensor::kObstacles;
    std::uint32_t range_offset = kNone;  ///< of a double
    double range = 0.0;

    friend auto operator<=>(const NeedCode&, const NeedCode&) = default;
  };
  /// A sequence of a block, which needs more for the states that it may be in.
  struct NeedySequence {
    std::uint32_t sequence = 0;  ///< index
    bool is_in_select = false;   ///< in a case of one: it may go on though its block starts anew

    friend auto operator<=>(const NeedySequence&, const NeedySequence&) = default;
  };
  /// State that a node keeps from cycle to cycle.
  struct KeptCode {
    std::string path;
    std::uint64_t path_hash = 0;
    std::uint32_t offset = 0;
    std::uint32_t size = 0;
  };
  /// A value so large that it stands behind all others, state or output.
  struct LargeCode {
    std::uint32_t offset = 0;
    std::uint32_t stamp = kNone;  ///< of its operation
  };
  struct MixtureCode {
    std::string path;
    std::uint32_t stamp = kNone;
    struct Member {
      std::string path;
      std::uint32_t value = 0;
      std::uint32_t gain = 0;
    };
    std::vector<Member> members;
  };
  const std::string& name() const { return name_; }
  /// All ports in the order in which the network declares them.
  const std::vector<Port>& ports() const { return ports_; }
  /// Null where there is none. Parameters are found by all of their names.
  const Port* find(std::string_view path) const;
  std::size_t frame_size() const { return initial_.size(); }
  /// Equal for two programs whose frames can't be told apart: where the same network was built with the same
  /// library in two processes, either may read the other's frames.
  std::uint64_t layout_hash() const;
  /// How many operations remain after sharing.
  std::size_t instruction_count() const { return instructions_.size(); }
  /// All nodes that have a value, and conversions between two; nodes that share one stand there once.
  const std::vector<NodeWires>& wires() const { return wires_; }
  /// Some behavior of it is asynchronous.
  bool has_asynchronous() const { return !asyncs_.empty(); }

  /// A robot's values before its first cycle.
  Frame make_frame() const { return initial_; }
  const Frame& initial_frame() const { return initial_; }

  /// One cycle: senses are in `percepts`, what the robot does goes into `action`. `number` of the cycle
  /// handed to the behaviors is counted in the frame, from 1.
  /// @param frame  frame_size() bytes, aligned to Frame::kAlignment, made from `initial_frame`
  /// @param async  runs asynchronous behaviors elsewhere; null: they are computed here when their value is
  /// due
  /// @param interventions  what a person makes it do; null: nothing
  void step(std::byte* frame, const percept::Percepts& percepts, percept::Action& action, std::uint64_t seed,
            std::uint32_t robot, AsyncRunner* async = nullptr, Interventions* interventions = nullptr) const;

  /// What the next step may read, given the states in which the robot is, and those that it has to go to.
  percept::Needs needs(const std::byte* frame, const Interventions* interventions = nullptr) const;

  /// Tells the processor that a step comes soon, which then need not wait for most of the frame.
  void fetch(const std::byte* frame) const;
  /// Likewise the first lines of large values that the cycle before computed. Reads what `fetch` fetches.
  void fetch_large(const std::byte* frame) const;

  /// The cycle that ran last; 0 before the first.
  static std::uint64_t cycle(const std::byte* frame);

  /// Room for each value that a person can write.
  using ValueBytes = std::array<std::byte, 512>;
  /// Reads a value of a port's type as a person writes it (in edge_unit).
  /// @errors  a sentence that says what is wrong: not of the type, out of range
  static std::optional<std::string> read(const Port& port, std::string_view text, ValueBytes& out);

  /// False: a number that stands in a frame, at `value`, is none that may be set at the port.
  static bool is_in_range(const Port& port, const std::byte* value);
  /// The output says whether the value of an asynchronous procedure came in this cycle (`X.fresh`).
  bool is_news(const Port& port) const;

  /// Sets a parameter or constant, as a person writes it (in edge_unit). Nothing changes where there is an
  /// error.
  /// @errors  a sentence that says what is wrong: not settable, not of the type, out of range
  std::optional<std::string> set(std::byte* frame, const Port& port, std::string_view text) const;

  /// The first port, in the order of evaluation, whose value is NaN or infinite; null where all are sound.
  const Port* find_fault(const std::byte* frame) const;

  /// The value for a person.
  static std::string print(const std::byte* frame, const Port& port);
  /// The number that a bool, integer, real, choice or mask port holds; the length of a vector; nothing for
  /// others.
  static std::optional<double> number(const std::byte* frame, const Port& port);

  /// The vector that a port holds; nothing for others.
  static std::optional<geom::Vector> vector(const std::byte* frame, const Port& port);

  /// What moved the robot: the members of all weighted sums that were evaluated in the last cycle. A weighted
  /// sum is any behavior with a list of vectors and, after it, a list of gains.
  std::vector<Contribution> contributions(const std::byte* frame) const;

  /// The active states of all sequences, `sequence.state` each, in the network's order.
  std::vector<std::string> active_states(const std::byte* frame) const;
  /// A number that is the same as long as no sequence changes its state; without any text, for every cycle.
  std::uint64_t states_key(const std::byte* frame) const;

  /// A way out of the state in which a sequence is.
  struct WayOut {
    std::string sequence;
    std::string state;
    std::string trigger;      ///< path of the node; empty: a constant
    bool is_negated = false;  ///< it is taken when the trigger is false
    bool trigger_value = false;
    std::string target;
  };
  /// The ways out of the active states of all sequences that ran in the last cycle, in their order.
  std::vector<WayOut> ways_out(const std::byte* frame) const;

  // ---- what happened in the cycle that ran last, for who looks on

  /// How a sequence stands after a cycle.
  struct SequenceState {
    std::uint32_t active = 0;  ///< index of its state
    std::uint32_t cycle = 0;   ///< in which it ran last; 0: never
  };
  /// A transition that was made.
  struct Transit {
    std::uint32_t sequence = 0;  ///< index, for `sequence_name`
    std::uint32_t from = 0;      ///< indices of states, for `state_name`
    /// Among the ways out of `from`, in the order in which they are asked; kNone: it was forced, and there is
    /// no such way.
    std::uint32_t way = 0;
    std::uint32_t to = 0;
    bool is_forced = false;
  };
  std::size_t sequence_count() const { return sequences_.size(); }
  const std::string& sequence_name(std::uint32_t sequence) const { return sequence_names_[sequence]; }
  const std::vector<std::string>& state_names(std::uint32_t sequence) const { return state_names_[sequence]; }
  /// Fills `out`, by index of sequence.
  void sequence_states(const std::byte* frame, std::vector<SequenceState>& out) const;
  /// The transitions of the last cycle. One from a state to itself counts where it restarts it.
  /// @param before  sequence_states after the cycle before; empty: that was not noted, and all count as
  ///                started anew
  /// @param interventions  in that cycle; null: there were none
  std::vector<Transit> transits(const std::byte* frame, std::span<const SequenceState> before,
                                const Interventions* interventions = nullptr) const;
  /// Offsets of the values that the last cycle computed, ascending: a port's value is of this cycle where its
  /// offset is among them.
  std::vector<std::uint32_t> ran(const std::byte* frame, std::span<const SequenceState> before,
                                 const Interventions* interventions = nullptr) const;

 private:
  friend class ProgramBuilder;
  friend class CarryOver;
  friend std::shared_ptr<const Program> with_initial_frame(const Program& program, Frame initial);

  /// The first transition of a state whose trigger is true, as triggers stand.
  std::optional<std::uint32_t> way_taken(const std::byte* frame, std::uint32_t sequence,
                                         std::uint32_t from) const;
  /// The state whose triggers the last cycle asked.
  std::uint32_t state_before(const std::byte* frame, std::uint32_t sequence,
                             std::span<const SequenceState> before) const;
  Transit forced_transit(const std::byte* frame, const Interventions::Forced& forced,
                         std::span<const SequenceState> before) const;
  void add_ran(const Block& block, const std::byte* frame, std::span<const SequenceState> before,
               const Interventions* interventions, std::vector<std::uint32_t>& out) const;

  /// What one cycle is run with.
  struct Run {
    Call call;
    AsyncRunner* async = nullptr;
    Interventions* interventions = nullptr;  ///< not null where kIntervened
  };
  // Twice, so that who looks for no interventions does not pay for them.
  template <bool kIntervened>
  void run(const Block& block, Run& cycle) const;
  template <bool kIntervened>
  void run_sequence(const Instruction& instruction, bool starts_anew, Run& cycle) const;
  void run_async(const Instruction& instruction, bool is_first, Call& call, std::uint32_t now,
                 AsyncRunner* async) const;
  void restart(const Block& block, std::byte* frame) const;
  std::span<const NeedCode> needs_of(const Block& block) const {
    return std::span(needs_).subspan(block.first_need, block.need_count);
  }
  std::span<const NeedySequence> sequences_of(const Block& block) const {
    return std::span(needy_sequences_).subspan(block.first_sequence, block.sequence_count);
  }
  void add_needs(const Block& block, const std::byte* frame, bool starts_anew,
                 const Interventions* interventions, percept::Needs& needs) const;

  std::string name_;
  std::vector<Port> ports_;
  std::map<std::string, std::uint32_t, std::less<>> port_index_;
  std::vector<Instruction> instructions_;
  std::vector<std::uint32_t> words_;
  Block root_;
  std::vector<SequenceCode> sequences_;
  std::vector<std::string> sequence_names_;
  std::vector<std::vector<std::string>> state_names_;
  std::vector<SelectCode> selects_;
  std::vector<DelayCode> delays_;
  std::vector<AsyncCode> asyncs_;
  std::vector<NeedCode> needs_;
  std::vector<NeedySequence> needy_sequences_;
  std::vector<MixtureCode> mixtures_;
  std::vector<NodeWires> wires_;
  Frame initial_;
  std::vector<KeptCode> kept_;    ///< for `carry_over` only
  std::vector<LargeCode> large_;  ///< what stands behind all others
  std::uint32_t near_size_ = 0;   ///< of what stands before them in the frame
};

/// The same program with other values before the first cycle.
/// @param initial  of frame_size()
std::shared_ptr<const Program> with_initial_frame(const Program& program, Frame initial);

/// Builds the program of a network. Null where there were errors; every problem is reported at the author's
/// place: unknown behaviors, inputs, sources; missing, double links; types and units that do not agree;
/// constants that are none of their type or out of range; loops, with their path; nodes that nothing uses,
/// lists without members (warnings).
std::shared_ptr<const Program> build_program(const Network& network, const Library& library,
                                             text::Diagnostics& sink);

}  // namespace mlab::flow
