#include "mlab/flow/program.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/base/hash.h"
#include "mlab/flow/async_runner.h"
#include "mlab/flow/port_types.h"
#include "mlab/flow/type_words.h"
#include "mlab/text/shown.h"

namespace mlab::flow {
namespace {

// A stamp that is no cycle: the node fired once, and must restart when it fires next.
constexpr std::uint32_t kMustRestart = 0xffffffffU;

template <class T>
T& at(std::byte* frame, std::uint32_t offset) {
  return *std::launder(reinterpret_cast<T*>(frame + offset));
}
template <class T>
const T& at(const std::byte* frame, std::uint32_t offset) {
  return *std::launder(reinterpret_cast<const T*>(frame + offset));
}

// The first eight bytes of every frame.
std::uint64_t& cycle_of(std::byte* frame) {
  return at<std::uint64_t>(frame, 0);
}

// Who looks on may be shown a frame of another process, in which any bytes may stand.
bool flag_at(const std::byte* frame, std::uint32_t offset) {
  return frame[offset] != std::byte{0};
}

/// As memcpy; most values are numbers, vectors and truth values, for which a call costs more than the copy.
[[gnu::always_inline]] inline void copy_value(std::byte* to, const std::byte* from, std::uint32_t size) {
  if (size == sizeof(double))
    std::memcpy(to, from, sizeof(double));
  else if (size == sizeof(geom::Vector))
    std::memcpy(to, from, sizeof(geom::Vector));
  else if (size == sizeof(bool))
    *to = *from;
  else
    std::memcpy(to, from, size);
}

std::int64_t integer_at(const std::byte* frame, std::uint32_t offset, std::uint32_t size) {
  switch (size) {
    case 1:
      return at<std::uint8_t>(frame, offset);
    case 2:
      return at<std::uint16_t>(frame, offset);
    case 4:
      return at<std::int32_t>(frame, offset);
    default:
      return at<std::int64_t>(frame, offset);
  }
}

/// Of a select, in a robot's frame; null where there is none.
[[gnu::always_inline]] inline const Program::CaseCode* case_of(const Program::SelectCode& select,
                                                               const std::byte* frame) {
  std::int32_t index = select.otherwise;
  const bool is_byte = select.selector_size == 1;
  const std::int64_t value = is_byte ? at<std::uint8_t>(frame, select.selector)
                                     : integer_at(frame, select.selector, select.selector_size);
  if (is_byte || static_cast<std::uint64_t>(value) < select.direct.size()) [[likely]] {
    index = select.direct[static_cast<std::size_t>(value)];
  } else {
    for (const Program::SelectCode::Choice& choice : select.choices) {
      if (choice.value == value) index = static_cast<std::int32_t>(choice.index);
    }
  }
  return index < 0 ? nullptr : &select.cases[static_cast<std::size_t>(index)];
}

}  // namespace

const Port* Program::find(std::string_view path) const {
  const auto it = port_index_.find(path);
  return it == port_index_.end() ? nullptr : &ports_[it->second];
}

std::uint32_t Program::SequenceCode::active_in(const std::byte* frame) const {
  const std::uint32_t index = at<std::uint32_t>(frame, active);
  return index < states.size() ? index : start;
}

const Program::CaseCode* Program::SelectCode::chosen_in(const std::byte* frame) const {
  return case_of(*this, frame);
}

std::uint64_t Program::layout_hash() const {
  std::uint64_t key = initial_.size();
  const auto add = [&key](std::initializer_list<std::uint64_t> parts) {
    for (const std::uint64_t part : parts) key = base::combine_bits(key, part);
  };
  for (const Port& port : ports_) add({base::hash_text(port.path), port.offset, port.type->size});
  for (const Instruction& i : instructions_) {
    add({static_cast<std::uint64_t>(i.kind), i.stamp, i.inputs, i.output, i.state, i.data, i.path_hash});
  }
  for (const std::uint32_t word : words_) add({word});
  for (const SequenceCode& sequence : sequences_) add({sequence.active, sequence.states.size()});
  return key;
}

std::uint64_t Program::cycle(const std::byte* frame) {
  return at<std::uint64_t>(frame, 0);
}

void Program::step(std::byte* frame, const percept::Percepts& percepts, percept::Action& action,
                   std::uint64_t seed, std::uint32_t robot, AsyncRunner* async,
                   Interventions* interventions) const {
  const std::uint64_t number = ++cycle_of(frame);
  const Cycle context{&percepts, &action, number, seed, robot};
  const auto now = static_cast<std::uint32_t>(number);
  Run cycle;
  cycle.call.cycle = &context;
  cycle.call.frame = frame;
  cycle.call.now = now;
  cycle.async = async;
  cycle.interventions = interventions;
  if (interventions == nullptr)
    run<false>(root_, cycle);
  else
    run<true>(root_, cycle);
  for (const DelayCode& delay : delays_) {
    if (at<std::uint32_t>(frame, delay.stamp) == now)
      copy_value(frame + delay.next, frame + delay.source, delay.value_size);
  }
}

template <bool kIntervened>
void Program::run(const Block& block, Run& cycle) const {
  Call& call = cycle.call;
  std::byte* const frame = call.frame;
  const std::uint32_t now = call.now;
  const std::uint32_t* const words = words_.data();
  const Instruction* const end = instructions_.data() + block.first + block.count;
  for (const Instruction* i = instructions_.data() + block.first; i != end; ++i) {
    if (i->stamp != kNone) {
      // Only what stands in several blocks may have fired in this cycle.
      auto& stamp = at<std::uint32_t>(frame, i->stamp);
      if (stamp == now) continue;
      call.fired = stamp;
      stamp = now;
    }
    Interventions::Held* held = nullptr;
    if constexpr (kIntervened) {
      held = cycle.interventions->held_at(i->output);
      if (held != nullptr) std::memcpy(frame + held->offset, held->computed.data(), held->size);
    }
    if (i->kind == Instruction::Kind::kFire) [[likely]] {
      call.inputs = words + i->inputs;
      static_cast<Firing&>(call) = *i;
      i->fire(call);
    } else if (i->kind == Instruction::Kind::kSelect) {
      const SelectCode& select = selects_[i->data];
      const CaseCode* const chosen = case_of(select, frame);
      if (chosen != nullptr) {
        if (chosen->member.count > 0) run<kIntervened>(chosen->member, cycle);
        copy_value(frame + i->output, frame + chosen->value, select.value_size);
      } else {
        std::memset(frame + i->output, 0, select.value_size);
      }
    } else if (i->kind == Instruction::Kind::kSequence) {
      run_sequence<kIntervened>(*i, call.is_restart(), cycle);
    } else if (i->kind == Instruction::Kind::kDelay) {
      const DelayCode& delay = delays_[i->data];
      copy_value(frame + i->output, frame + (call.is_restart() ? delay.initial : delay.next),
                 delay.value_size);
    } else {
      run_async(*i, call.is_first(), call, now, cycle.async);
    }
    if constexpr (kIntervened) {
      if (held == nullptr) continue;
      std::memcpy(held->computed.data(), frame + held->offset, held->size);
      std::memcpy(frame + held->offset, held->value.data(), held->size);
    }
  }
}

template <bool kIntervened>
void Program::run_sequence(const Instruction& instruction, bool starts_anew, Run& cycle) const {
  const SequenceCode& sequence = sequences_[instruction.data];
  std::byte* const frame = cycle.call.frame;
  auto& active = at<std::uint32_t>(frame, sequence.active);
  if (starts_anew) active = sequence.start;
  Interventions::Forced* forced = nullptr;
  if constexpr (kIntervened) forced = cycle.interventions->coming(instruction.data);
  if (forced != nullptr) {
    forced->was_done = true;
    if (forced->state == active) restart(sequence.states[active].member, frame);
    active = forced->state;
  } else {
    const StateCode& before = sequence.states[active];
    run<kIntervened>(before.triggers, cycle);
    for (const TransitionCode& transition : before.transitions) {
      if (at<bool>(frame, transition.trigger) == transition.is_negated) continue;
      if (transition.restarts && transition.target == active) restart(before.member, frame);
      active = transition.target;
      break;
    }
  }
  const StateCode& state = sequence.states[active];
  run<kIntervened>(state.member, cycle);
  copy_value(frame + instruction.output, frame + state.value, sequence.value_size);
}

void Program::run_async(const Instruction& instruction, bool is_first, Call& call, std::uint32_t now,
                        AsyncRunner* async) const {
  const AsyncCode& code = asyncs_[instruction.data];
  auto& started = at<std::uint32_t>(call.frame, code.started);
  auto& fresh = at<bool>(call.frame, code.fresh);
  // Time, cycle duration and a flag stand before the captured inputs.
  auto& time = at<double>(call.frame, code.captured);
  auto& duration = at<double>(call.frame, code.captured + 8);
  auto& first_job = at<bool>(call.frame, code.captured + 16);
  const JobKey key{call.cycle->robot, instruction.path_hash, started};
  const auto job_of = [&] {
    Job job;
    job.behavior = code.behavior;
    job.frame = Frame(frame_size());
    std::memcpy(job.frame.data(), call.frame, frame_size());
    job.inputs.assign(
        words_.begin() + instruction.inputs,
        words_.begin() + instruction.inputs + static_cast<std::ptrdiff_t>(code.captured_offsets.size()));
    job.output = instruction.output;
    job.state = instruction.state;
    job.is_first = first_job;
    job.path_hash = instruction.path_hash;
    job.time = time;
    job.cycle_duration = duration;
    job.seed = call.cycle->seed;
    job.robot = call.cycle->robot;
    job.cycle = started;
    return job;
  };
  fresh = false;
  if (started != 0 && now - started >= static_cast<std::uint32_t>(code.behavior->latency_cycles)) {
    Job job;
    if (async == nullptr || !async->take(key, job)) {
      job = job_of();
      job.compute();
    }
    std::memcpy(call.frame + instruction.output, job.frame.data() + instruction.output, code.output_size);
    if (code.behavior->state_size > 0) {
      std::memcpy(call.frame + instruction.state, job.frame.data() + instruction.state,
                  code.behavior->state_size);
    }
    started = 0;
    fresh = true;
  }
  if (started == 0) {
    for (std::size_t i = 0; i < code.sources.size(); ++i) {
      std::memcpy(call.frame + code.captured_offsets[i], call.frame + code.sources[i], code.sizes[i]);
    }
    time = call.cycle->percepts->time;
    duration = call.cycle->percepts->cycle_duration;
    first_job = is_first;
    started = now;
    if (async != nullptr) async->start({call.cycle->robot, instruction.path_hash, now}, job_of());
  }
}

void Program::restart(const Block& block, std::byte* frame) const {
  for (std::uint32_t n = block.first; n < block.first + block.count; ++n) {
    const Instruction& i = instructions_[n];
    if (i.stamp == kNone || i.is_guarded) continue;
    auto& stamp = at<std::uint32_t>(frame, i.stamp);
    if (stamp == 0) continue;
    stamp = kMustRestart;
    // What runs inside starts anew as well, even where it starts in the state in which it is.
    if (i.kind == Instruction::Kind::kSequence) {
      const SequenceCode& sequence = sequences_[i.data];
      const StateCode& state = sequence.states[at<std::uint32_t>(frame, sequence.active)];
      restart(state.triggers, frame);
      restart(state.member, frame);
    } else if (i.kind == Instruction::Kind::kSelect) {
      for (const CaseCode& one : selects_[i.data].cases) restart(one.member, frame);
    }
  }
}

void Program::add_needs(const Block& block, const std::byte* frame, bool starts_anew,
                        const Interventions* interventions, percept::Needs& needs) const {
  for (const NeedCode& need : needs_of(block)) {
    const double range = need.range_offset == kNone ? need.range : at<double>(frame, need.range_offset);
    needs.want(need.sensor, range);
  }
  const auto last = static_cast<std::uint32_t>(cycle(frame));
  for (const auto& [index, is_in_select] : sequences_of(block)) {
    const SequenceCode& sequence = sequences_[index];
    const bool starts =
        (starts_anew && !is_in_select) || last == 0 || at<std::uint32_t>(frame, sequence.stamp) != last;
    const StateCode& state = sequence.states[starts ? sequence.start : sequence.active_in(frame)];
    add_needs(state.triggers, frame, starts, interventions, needs);
    add_needs(state.member, frame, starts, interventions, needs);
    for (const TransitionCode& transition : state.transitions) {
      add_needs(sequence.states[transition.target].member, frame, true, interventions, needs);
    }
    const auto* const forced = interventions == nullptr ? nullptr : interventions->coming(index);
    if (forced != nullptr)
      add_needs(sequence.states[forced->state].member, frame, true, interventions, needs);
  }
}

void Program::fetch(const std::byte* frame) const {
  constexpr std::uint32_t kLines = 8;  // without a question whether there are more; nothing is read in vain
  for (std::uint32_t at = 0; at < near_size_; at += kLines * Frame::kAlignment) {
#pragma GCC unroll 8
    for (std::uint32_t i = 0; i < kLines; ++i) __builtin_prefetch(frame + at + i * Frame::kAlignment, 1);
  }
}

void Program::fetch_large(const std::byte* frame) const {
  constexpr std::size_t kLines = 4;  // of a way more than are read as long as it has few corners
  const auto last = static_cast<std::uint32_t>(cycle(frame));
  for (const LargeCode& one : large_) {
    if (one.stamp != kNone && at<std::uint32_t>(frame, one.stamp) != last) continue;
    for (std::size_t i = 0; i < kLines; ++i)
      __builtin_prefetch(frame + one.offset + i * Frame::kAlignment, 1);
  }
}

percept::Needs Program::needs(const std::byte* frame, const Interventions* interventions) const {
  percept::Needs out;
  add_needs(root_, frame, false, interventions, out);
  return out;
}

namespace {

// With its range and its unit.
std::string expected_of(const Port& port) {
  std::string out = flow::expected_of(*port.type);
  const bool is_number = port.type->kind == TypeKind::kReal || port.type->kind == TypeKind::kInteger;
  const bool has_min = is_number && is_limit(port.min);
  const bool has_max = is_number && is_limit(port.max);
  if (has_min && has_max) out += fmt::format(", {} .. {}", port.min, port.max);
  if (has_min && !has_max) out += fmt::format(", at least {}", port.min);
  if (has_max && !has_min) out += fmt::format(", at most {}", port.max);
  return port.edge_unit.empty() ? out : fmt::format("{} [{}]", out, port.edge_unit);
}

}  // namespace

std::optional<std::string> Program::read(const Port& port, std::string_view text, ValueBytes& out) {
  if (port.type->parse == nullptr || port.type->size > out.size())
    return why_not_written(port.path, *port.type);
  if (!port.type->parse(text, out.data()))
    return fmt::format("`{}` is no {}: `{}` takes {}", text::shown(text, 100), noun_of(*port.type), port.path,
                       expected_of(port));
  if (port.type->kind != TypeKind::kReal && port.type->kind != TypeKind::kInteger) return std::nullopt;
  double number = 0.0;
  if (port.type->kind == TypeKind::kReal) std::memcpy(&number, out.data(), sizeof number);
  if (port.type->kind == TypeKind::kInteger)
    number = static_cast<double>(integer_at(out.data(), 0, port.type->size));
  if (number < port.min || number > port.max) {
    return fmt::format("{} is out of range: `{}` takes {} .. {}{}{}", text, port.path, port.min, port.max,
                       port.edge_unit.empty() ? "" : " ", port.edge_unit);
  }
  if (port.edge_unit == "deg" && port.unit != "deg") {
    number = base::radians(number);
    std::memcpy(out.data(), &number, sizeof number);
  }
  return std::nullopt;
}

// Within what converting units may have cost.
bool Program::is_in_range(const Port& port, const std::byte* value) {
  double number = 0.0;
  if (port.type->kind == TypeKind::kReal)
    std::memcpy(&number, value, sizeof number);
  else if (port.type->kind == TypeKind::kInteger)
    number = static_cast<double>(integer_at(value, 0, port.type->size));
  else
    return true;
  if (port.edge_unit == "deg" && port.unit != "deg") number = base::degrees(number);
  const auto slack = [](double limit) { return 1e-9 * std::fabs(limit); };
  return number >= port.min - slack(port.min) && number <= port.max + slack(port.max);
}

bool Program::is_news(const Port& port) const {
  return port.role == Port::Role::kOutput &&
         std::ranges::find(asyncs_, port.offset, &AsyncCode::fresh) != asyncs_.end();
}

std::optional<std::string> Program::set(std::byte* frame, const Port& port, std::string_view text) const {
  if (port.role == Port::Role::kOutput)
    return fmt::format("`{}` is the output of a node, not a parameter", port.path);
  alignas(Frame::kAlignment) ValueBytes value{};
  if (auto problem = read(port, text, value)) return problem;
  std::memcpy(frame + port.offset, value.data(), port.type->size);
  return std::nullopt;
}

const Port* Program::find_fault(const std::byte* frame) const {
  const Port* fault = nullptr;
  for (const Port& port : ports_) {
    if (port.type->is_finite == nullptr || port.type->is_finite(frame + port.offset)) continue;
    if (fault == nullptr || port.offset < fault->offset)
      fault = &port;  // offsets grow in the order of evaluation
  }
  return fault;
}

std::string Program::print(const std::byte* frame, const Port& port) {
  if (port.type->kind == TypeKind::kReal && port.edge_unit == "deg" && port.unit != "deg") {
    return fmt::format("{}", base::degrees(at<double>(frame, port.offset)));
  }
  return port.type->print == nullptr ? fmt::format("<{}>", port.type->name)
                                     : port.type->print(frame + port.offset);
}

std::optional<double> Program::number(const std::byte* frame, const Port& port) {
  switch (port.type->kind) {
    case TypeKind::kReal:
      return at<double>(frame, port.offset);
    case TypeKind::kVector:
      return geom::length(at<geom::Vector>(frame, port.offset));
    case TypeKind::kBool:
    case TypeKind::kInteger:
    case TypeKind::kChoice:
    case TypeKind::kMask:
      return static_cast<double>(integer_at(frame, port.offset, port.type->size));
    case TypeKind::kPoint:
    case TypeKind::kPose:
    case TypeKind::kText:
    case TypeKind::kList:
    case TypeKind::kOther:
      return std::nullopt;
  }
  return std::nullopt;
}

std::vector<Contribution> Program::contributions(const std::byte* frame) const {
  std::vector<Contribution> out;
  const auto now = static_cast<std::uint32_t>(cycle(frame));
  for (const MixtureCode& mixture : mixtures_) {
    if (now == 0 || at<std::uint32_t>(frame, mixture.stamp) != now) continue;
    for (const MixtureCode::Member& member : mixture.members) {
      out.push_back({mixture.path, member.path,
                     at<geom::Vector>(frame, member.value) * at<double>(frame, member.gain)});
    }
  }
  return out;
}

std::vector<std::string> Program::active_states(const std::byte* frame) const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < sequences_.size(); ++i) {
    out.push_back(sequence_names_[i] + "." + state_names_[i][sequences_[i].active_in(frame)]);
  }
  return out;
}

std::uint64_t Program::states_key(const std::byte* frame) const {
  std::uint64_t key = 0;
  for (const SequenceCode& sequence : sequences_)
    key = base::combine_bits(key, at<std::uint32_t>(frame, sequence.active));
  return key;
}

std::vector<Program::WayOut> Program::ways_out(const std::byte* frame) const {
  std::vector<WayOut> out;
  const auto now = static_cast<std::uint32_t>(cycle(frame));
  for (const Instruction& instruction : instructions_) {
    if (instruction.kind != Instruction::Kind::kSequence) continue;
    const bool ran =
        now != 0 && (instruction.stamp == kNone || at<std::uint32_t>(frame, instruction.stamp) == now);
    if (!ran) continue;
    const SequenceCode& sequence = sequences_[instruction.data];
    const std::vector<std::string>& names = state_names_[instruction.data];
    const std::uint32_t active = sequence.active_in(frame);
    for (const TransitionCode& transition : sequence.states[active].transitions) {
      WayOut& way = out.emplace_back();
      way.sequence = sequence_names_[instruction.data];
      way.state = names[active];
      way.target = names[transition.target];
      way.is_negated = transition.is_negated;
      way.trigger_value = flag_at(frame, transition.trigger);
      const auto port = std::ranges::find_if(ports_, [&](const Port& p) {
        return p.role == Port::Role::kOutput && p.offset == transition.trigger;
      });
      if (port != ports_.end()) way.trigger = port->path;
    }
  }
  return out;
}

std::shared_ptr<const Program> with_initial_frame(const Program& program, Frame initial) {
  auto out = std::make_shared<Program>(program);
  out->initial_ = std::move(initial);
  return out;
}

}  // namespace mlab::flow
