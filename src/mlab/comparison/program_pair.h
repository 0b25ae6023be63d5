#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/comparison/comparison.h"
#include "mlab/flow/program.h"

namespace mlab::comparison {

/// The programs of a robot in two runs, which may be two versions: what both have, by path and type.
class ProgramPair {
 public:
  using Frames = Both<const std::byte*>;

  /// @param programs  outlive it
  explicit ProgramPair(const Both<const flow::Program*>& programs);

  /// An output, or a parameter or constant, that both have.
  struct PortPair {
    Both<const flow::Port*> ports;
  };
  /// Where both frames hold the same bytes, no value differs; false as well where that can't be told so.
  bool are_equal_bytes(const Frames& frames) const;
  bool differs(const PortPair& pair, const Frames& frames) const;

  /// The first output that differs, in the order in which the first program computes them; null: none does.
  const PortPair* first_difference(const Frames& frames) const;
  /// The first sequence that is in another state; nothing: none is.
  std::optional<Value> state_difference(const Frames& frames) const;

  const std::vector<PortPair>& outputs() const { return outputs_; }
  const std::vector<PortPair>& settings() const { return settings_; }
  const Both<const flow::Program*>& programs() const { return programs_; }
  /// Paths of outputs that only one of them has.
  const Both<std::vector<std::string>>& only() const { return only_; }

 private:
  Both<const flow::Program*> programs_;
  bool is_same_layout_ = false;
  std::vector<PortPair> outputs_;
  std::vector<PortPair> settings_;
  Both<std::vector<std::string>> only_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sequences_;  // that both have
};

/// Both values of a port, for a person.
Value value_of(const ProgramPair::PortPair& pair, const ProgramPair::Frames& frames);

}  // namespace mlab::comparison
