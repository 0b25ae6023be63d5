#include "mlab/export/btcpp_names.h"

#include <algorithm>
#include <array>

namespace mlab::exports {
namespace {

// Nodes that every factory of BehaviorTree.CPP 3.8 to 4.9 has registered, and elements of the format.
constexpr auto kKept = std::to_array<std::string_view>({
    "Action",
    "AlwaysFailure",
    "AlwaysSuccess",
    "AsyncFallback",
    "AsyncSequence",
    "BehaviorTree",
    "Condition",
    "ConsumeQueue",
    "Control",
    "Decorator",
    "Delay",
    "Fallback",
    "FallbackStar",
    "ForceFailure",
    "ForceSuccess",
    "IfThenElse",
    "Inverter",
    "KeepRunningUntilFailure",
    "LoopBool",
    "LoopDouble",
    "LoopInt",
    "LoopString",
    "ManualSelector",
    "Parallel",
    "ParallelAll",
    "Precondition",
    "ReactiveFallback",
    "ReactiveSequence",
    "Repeat",
    "RetryUntilSuccessful",
    "RetryUntilSuccesful",
    "Root",
    "RunOnce",
    "Script",
    "ScriptCondition",
    "Sequence",
    "SequenceStar",
    "SequenceWithMemory",
    "SetBlackboard",
    "SkipUnlessUpdated",
    "Sleep",
    "SubTree",
    "SubTreePlus",
    "Switch2",
    "Switch3",
    "Switch4",
    "Switch5",
    "Switch6",
    "Timeout",
    "TreeNodesModel",
    "TryCatch",
    "UnsetBlackboard",
    "WaitValueUpdate",
    "WasEntryUpdated",
    "WhileDoElse",
    "include",
    "root",
});

std::string_view without_end(std::string_view name) {
  while (name.ends_with('_')) name.remove_suffix(1);
  return name;
}

}  // namespace

std::string btcpp_skill(std::string_view name) {
  const bool is_kept = std::ranges::find(kKept, without_end(name)) != kKept.end();
  return std::string(name) + (is_kept ? "_" : "");
}

std::string btcpp_port(std::string_view name) {
  const std::string_view stem = without_end(name);
  std::string out = std::string(name) + (stem == "name" || stem == "ID" ? "_" : "");
  // `_x` is `port_x`; so one that is called `port_x` already moves on, too.
  constexpr std::string_view kFront = "port";
  std::string_view rest = name;
  while (rest.starts_with(kFront)) rest.remove_prefix(kFront.size());
  return rest.starts_with('_') ? std::string(kFront) + out : out;
}

std::string btcpp_key(std::string_view name) {
  return (name.starts_with("true") || name.starts_with("false") ? "in_" : "") + std::string(name);
}

bool btcpp_is_pointer(std::string_view text) {
  if (text == "=") return true;  // the port's own name
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text.size() >= 3 && text.starts_with('{') && text.ends_with('}');
}

bool btcpp_fits_script(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '\''; });
}

}  // namespace mlab::exports
