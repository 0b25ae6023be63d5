#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mlab/flow/network.h"
#include "mlab/flow/program.h"
#include "mlab/text/source.h"

namespace mlab::component_test {

/// What a node said in a cycle.
struct NodeValue {
  std::string what;   ///< as its author wrote it where that is short, else its path
  std::string value;  ///< for a person
  std::string path;
};

inline constexpr std::size_t kMostSaid = 12;

/// What the nodes said that a node takes its value from, the nearest first, at most kMostSaid; without those
/// that the cycle did not evaluate.
///
/// @param ran     `Program::ran` of the cycle
/// @param inside  what the author wrote in there is told in his words, all else by its path
std::vector<NodeValue> feeding(const flow::Network& network, const flow::Program& program,
                               const std::byte* frame, std::span<const std::uint32_t> ran,
                               const std::string& node, const text::Place& inside);

/// Of a node, and of those that it takes its value from, those which the author wrote in there.
std::vector<const flow::Port*> written_below(const flow::Network& network, const flow::Program& program,
                                             const std::string& node, const text::Place& inside);

/// On one line, and not a long one.
std::string in_short(std::string_view text, std::size_t most = 72);

}  // namespace mlab::component_test
