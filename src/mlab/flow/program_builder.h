#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mlab/flow/program.h"

namespace mlab::flow {

/// One construction of a program: names are resolved and checked (program_builder.cc, program_operators.cc),
/// then the operations are laid out in a frame and put in order (program_layout.cc). Used by build_program
/// only.
class ProgramBuilder {
 public:
  ProgramBuilder(const Network& network, const Library& library, text::Diagnostics& sink)
      : network_(network), library_(library), sink_(sink), program_(std::make_shared<Program>()) {}

  std::shared_ptr<const Program> build();

 private:
  static constexpr std::uint32_t kNone = Program::kNone;

  // What an input reads: the output of an operation, or a slot that holds a parameter or a constant.
  struct Ref {
    enum class Kind : std::uint8_t { kNothing, kOp, kSlot, kFresh };
    Kind kind = Kind::kNothing;
    std::uint32_t index = 0;
    const TypeInfo* type = nullptr;
    std::string native_unit;  // in which the value stands in the frame
    std::string seen_unit;    // in which the author thinks of it

    friend auto operator<=>(const Ref& a, const Ref& b) {
      return std::pair(a.kind, a.index) <=> std::pair(b.kind, b.index);
    }
    friend bool operator==(const Ref& a, const Ref& b) { return a.kind == b.kind && a.index == b.index; }
  };
  struct Slot {
    std::uint32_t port = 0;  // index into Program::ports_
    std::vector<std::byte> value;
    std::uint32_t offset = 0;
  };
  struct StateRefs {
    std::vector<Ref> triggers;
    std::vector<std::uint32_t> targets;
    Ref member;
  };
  // The states of one sequence.
  struct StateNames {
    std::vector<std::string> names;                              // in their order
    std::unordered_map<std::string_view, std::uint32_t> places;  // the first of each name
  };
  // What a behavior's inputs are linked with, by its input.
  struct InputLinks {
    std::vector<std::vector<Ref>> refs;
    std::vector<const Link*> first;  // as written; null: it was not
  };
  // One operation to evaluate: a node of the network, or a conversion between two.
  struct Op {
    Program::Instruction::Kind kind = Program::Instruction::Kind::kFire;
    const Node* node = nullptr;  // null: a conversion
    std::string path;
    const Behavior* behavior = nullptr;
    const Alias* alias = nullptr;
    const TypeInfo* type = nullptr;  // null: a sink
    std::string native_unit;
    std::string seen_unit;
    std::vector<std::vector<Ref>> inputs;  // in the behavior's order; a scalar has one
    std::vector<StateRefs> states;
    std::uint32_t start = 0;
    Ref selector;
    std::vector<Ref> cases;
    Ref value;  // of a delay
    Ref initial;
    std::uint32_t same_as = kNone;  // shares the value of that operation
    bool is_reached = false;

    std::uint32_t output = 0;
    std::uint32_t state = 0;
    std::uint32_t stamp = kNone;
    std::uint32_t data = kNone;
    std::uint32_t fresh = 0;
    std::uint32_t captured = 0;
    std::uint32_t blocks = 0;  // in how many blocks it stands
  };
  struct Name {
    Ref ref;
    text::Place place;
  };

  // program_builder.cc: from names to references
  void declare_parameters();
  void declare_nodes();
  void declare_name(const std::string& name, const text::Place& place, Ref ref);
  void declare_behavior(const Node& node, Op& op);
  void link_node(std::uint32_t op);
  void link_behavior(std::uint32_t index);
  void link_given(const Node& node, std::uint32_t index, InputLinks& links);
  void link_default(const Node& node, std::uint32_t index, std::size_t input, InputLinks& links);
  void link_sequence(std::uint32_t index);
  std::uint32_t start_of(const Node& node);
  StateRefs link_state(const Node& node, const TypeInfo* type, const State& state, const StateNames& names);
  void tell_unreached(const Node& node, const std::vector<StateRefs>& states, std::uint32_t start);
  void link_select(std::uint32_t index);
  void link_delay(std::uint32_t index);
  int input_named(const Op& op, std::string_view name, std::string& unit) const;
  bool is_ignored_input(const Op& op, std::string_view name) const;
  std::vector<std::string> input_names(const Op& op) const;
  Ref resolve(const Source& source, const TypeInfo& type, const std::string& native_unit,
              const std::string& seen_unit, const std::string& constant_path, const Input* input);
  Ref constant(const Source& source, const TypeInfo& type, const std::string& native_unit,
               const std::string& seen_unit, const std::string& path, const Input* input);
  Ref connect(Ref from, const TypeInfo& type, const std::string& native_unit, const std::string& seen_unit,
              const text::Place& place);
  Ref convert(Ref from, const Behavior& conversion, const std::string& unit);
  std::uint32_t add_slot(Port port, std::vector<std::byte> value);
  void share_pure_calls();
  void refuse_loops();
  void warn_about_unused();
  void check_lists(const Op& op);
  template <class Visit>
  void for_each_source(const Op& op, Visit visit);

  // program_layout.cc: from references to offsets and instructions
  void lay_out();
  void place_values();
  void list_kept();
  void add_fresh_ports();
  void write_initial_frame();
  std::uint32_t allocate(std::size_t size, std::size_t alignment);
  std::uint32_t offset_of(const Ref& ref) const;
  std::uint32_t canonical(std::uint32_t op) const;
  std::vector<std::uint32_t> roots() const;
  std::vector<std::uint32_t> order(const std::vector<std::uint32_t>& roots, bool with_members = false);
  std::vector<std::uint32_t> order_of_cycle();
  Program::Block emit(const std::vector<std::uint32_t>& roots);
  Program::Instruction emit_op(std::uint32_t i);
  std::vector<std::uint32_t> take_what_waits(const std::vector<std::uint32_t>& ops);
  Program::Block emit_for(const std::vector<Ref>& refs);
  std::uint32_t emit_sequence(const Op& op);
  std::uint32_t emit_select(const Op& op);
  static void list_choices(const Node& node, Program::SelectCode& code);
  std::uint32_t emit_delay(const Op& op);
  std::uint32_t emit_async(const Op& op, std::uint32_t words);
  std::uint32_t emit_inputs(const Op& op);
  void emit_needs(const std::vector<std::uint32_t>& ops, Program::Block& block);
  Program::NeedCode need_of(const Op& op, const Need& need) const;
  bool has_own_stamp(const Op& op) const;
  void assign_stamps();
  bool is_mixture(const Op& op) const;
  void emit_mixtures();
  void emit_wires();
  std::string path_of(const Ref& ref) const;

  const Network& network_;
  const Library& library_;
  text::Diagnostics& sink_;
  std::shared_ptr<Program> program_;
  std::vector<Slot> slots_;
  std::vector<Op> ops_;
  std::map<std::string, Name, std::less<>> names_;
  std::vector<std::uint32_t> op_ports_;         // per op: index of its port, kNone for conversions and sinks
  std::vector<std::uint32_t> instruction_ops_;  // per instruction: its op
  std::vector<std::uint32_t> delay_ops_;
  std::vector<char> is_begun_;  // per op: blocks of its states or cases are being emitted
  // By such an op: what delays in those blocks keep for the next cycle, and needs its value.
  std::map<std::uint32_t, std::vector<std::uint32_t>> waiting_;
  std::vector<std::uint32_t> visited_;  // per op: the block that saw it last
  std::uint32_t block_number_ = 0;
  std::uint32_t frame_size_ = 8;  // the cycle comes first
};

}  // namespace mlab::flow
