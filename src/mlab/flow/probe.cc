#include "mlab/flow/probe.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/core.h>

namespace mlab::flow {
namespace {

[[noreturn]] void refuse(const std::string& message) {
  fmt::print(stderr, "BehaviorProbe: {}\n", message);
  std::abort();
}

constexpr std::size_t aligned(std::size_t offset) {
  return (offset + Frame::kAlignment - 1) / Frame::kAlignment * Frame::kAlignment;
}

}  // namespace

BehaviorProbe::BehaviorProbe(const Behavior& behavior, std::uint64_t seed, std::uint32_t robot)
    : behavior_(behavior), seed_(seed), robot_(robot), values_(behavior.inputs.size()) {
  state_offset_ = static_cast<std::uint32_t>(aligned(behavior.output == nullptr ? 0 : behavior.output->size));
  output_and_state_ = Frame(state_offset_ + aligned(behavior.state_size));
  if (behavior.output != nullptr && behavior.write_initial_output != nullptr) {
    behavior.write_initial_output(output_and_state_.data());
  }
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Input& input = behavior.inputs[i];
    if (input.is_list) continue;
    values_[i].assign(1, std::vector<std::byte>(input.type->size));
    if (!input.default_text.empty() &&
        (input.type->parse == nullptr || !input.type->parse(input.default_text, values_[i][0].data()))) {
      refuse(fmt::format("default `{}` of input `{}` of {} is no {}", input.default_text, input.name,
                         behavior.name, input.type->name));
    }
  }
}

std::size_t BehaviorProbe::find(std::string_view name, const TypeInfo& type, bool is_list) const {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Input& input = behavior_.inputs[i];
    if (input.name != name) continue;
    if (!same_type(*input.type, type))
      refuse(fmt::format("input `{}` of {} is a {}, not a {}", name, behavior_.name, input.type->name,
                         type.name));
    if (input.is_list != is_list)
      refuse(fmt::format("input `{}` of {} is {}a list", name, behavior_.name, input.is_list ? "" : "not "));
    return i;
  }
  refuse(fmt::format("{} has no input `{}`", behavior_.name, name));
}

void BehaviorProbe::write(std::size_t input, std::size_t position, const void* value) {
  const auto* bytes = static_cast<const std::byte*>(value);
  values_[input][position].assign(bytes, bytes + behavior_.inputs[input].type->size);
}

BehaviorProbe& BehaviorProbe::set_text(std::string_view name, std::string_view text) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Input& input = behavior_.inputs[i];
    if (input.name != name) continue;
    if (input.is_list || input.type->parse == nullptr || !input.type->parse(text, values_[i][0].data())) {
      refuse(fmt::format("`{}` is no {}", text, input.type->name));
    }
    return *this;
  }
  refuse(fmt::format("{} has no input `{}`", behavior_.name, name));
}

void BehaviorProbe::step() {
  ++cycle_;
  // A frame for this one cycle: output and state first, then the inputs.
  std::size_t size = output_and_state_.size();
  for (const auto& input : values_) {
    for (const auto& value : input) size += aligned(value.size());
  }
  Frame frame(size);
  if (output_and_state_.size() > 0) {
    std::memcpy(frame.data(), output_and_state_.data(), output_and_state_.size());
  }
  std::vector<std::uint32_t> words;
  std::size_t offset = output_and_state_.size();
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (behavior_.inputs[i].is_list) words.push_back(static_cast<std::uint32_t>(values_[i].size()));
    for (const auto& value : values_[i]) {
      std::memcpy(frame.data() + offset, value.data(), value.size());
      words.push_back(static_cast<std::uint32_t>(offset));
      offset += aligned(value.size());
    }
  }
  action = {};
  const Cycle context{&percepts, &action, cycle_, seed_, robot_};
  Call call{{0, state_offset_, 0},
            &context,
            frame.data(),
            words.data(),
            static_cast<std::uint32_t>(cycle_),
            static_cast<std::uint32_t>(last_fired_)};
  behavior_.fire(call);
  last_fired_ = cycle_;
  if (output_and_state_.size() > 0) {
    std::memcpy(output_and_state_.data(), frame.data(), output_and_state_.size());
  }
  percepts.time += percepts.cycle_duration;
}

void BehaviorProbe::skip() {
  ++cycle_;
  percepts.time += percepts.cycle_duration;
}

const void* BehaviorProbe::output_of(const TypeInfo& type) const {
  if (behavior_.output == nullptr || !same_type(*behavior_.output, type)) {
    refuse(fmt::format("{} puts out {}, not {}", behavior_.name,
                       behavior_.output == nullptr ? "nothing" : behavior_.output->name, type.name));
  }
  return output_and_state_.data();
}

}  // namespace mlab::flow
