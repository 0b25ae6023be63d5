#pragma once

#include <cstdint>
#include <span>

#include "mlab/flow/behavior.h"

/// What a shared library with procedures gives to the program that loads it. The library exports one C
/// function, `const mlab::flow::Module* mlab_cnl_module_v1()`. It is loaded once and stays: behaviors have
/// static lifetime.

namespace mlab::flow {

/// Changes with every change of the structs below that old libraries would misread.
inline constexpr std::uint32_t kModuleAbi = 2;

/// A fingerprint of what both sides have to agree on byte by byte: a library made from other headers has
/// another one.
constexpr std::uint64_t module_layout() {
  std::uint64_t h = kModuleAbi;
  for (const std::uint64_t part :
       {sizeof(Behavior), sizeof(Input), sizeof(Alias), sizeof(Need), sizeof(Call), sizeof(Cycle),
        sizeof(TypeInfo), sizeof(percept::Percepts), sizeof(percept::Action), sizeof(percept::Obstacle),
        sizeof(percept::RobotReading), sizeof(percept::ObjectReading), sizeof(percept::RangeReading),
        sizeof(percept::Order), sizeof(percept::UnitPercept), sizeof(Obstacles), sizeof(base::Random)}) {
    h = h * 1099511628211ULL ^ part;
  }
  return h;
}

struct Module {
  std::uint32_t abi = 0;
  std::uint64_t layout = 0;
  const Behavior* const* behaviors = nullptr;
  std::uint64_t behavior_count = 0;
};

inline constexpr const char* kModuleEntry = "mlab_cnl_module_v1";
using ModuleEntry = const Module* (*)();

inline Module make_module(std::span<const Behavior* const> behaviors) {
  return {kModuleAbi, module_layout(), behaviors.data(), behaviors.size()};
}

}  // namespace mlab::flow
