#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/behavior.h"
#include "mlab/lang/cnl/tree.h"

namespace mlab::cnl {

/// Descriptors of a file's procedures without their code: enough to check a network that uses them, when
/// nothing of the file may be compiled or run. A program built with them does nothing. The descriptors point
/// into this object.
class Signatures {
 public:
  /// @param tree       has passed `check_declarations`
  /// @param find_type  null where there is no type of that name; the file's own types need not be known
  Signatures(const Tree& tree, const std::function<const flow::TypeInfo*(std::string_view)>& find_type);
  Signatures(const Signatures&) = delete;
  Signatures& operator=(const Signatures&) = delete;

  std::span<const flow::Behavior* const> behaviors() const { return pointers_; }

  /// What only the compiled code of a procedure knows: how large its state is [bytes], and whether its header
  /// does anything. A name that there is not changes nothing.
  void set_state(std::string_view procedure, std::uint32_t size, std::uint32_t alignment, bool has_header);
  /// The same of a type that the file declares.
  void set_type(std::string_view type, std::uint32_t size, std::uint32_t alignment);

 private:
  /// Everything that one descriptor points at.
  struct Parts {
    std::vector<flow::Input> inputs;
    std::vector<flow::Alias> aliases;
    std::deque<std::vector<flow::Alias::Port>> ports;
    std::deque<std::vector<std::string_view>> ignored;
    std::vector<flow::Need> needs;
    flow::Behavior behavior;
  };

  std::string_view keep(std::string text) { return texts_.emplace_back(std::move(text)); }
  void add(const Procedure& procedure);
  void add_alias(const Procedure& procedure, const AliasDecl& alias, Parts& parts);
  const flow::TypeInfo* type(const Word& name);

  std::function<const flow::TypeInfo*(std::string_view)> find_type_;
  std::deque<std::string> texts_;
  std::deque<flow::TypeInfo> own_types_;
  std::deque<Parts> parts_;
  std::vector<const flow::Behavior*> pointers_;
};

}  // namespace mlab::cnl
