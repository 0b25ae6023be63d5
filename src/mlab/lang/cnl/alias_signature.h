#pragma once

#include <string>
#include <vector>

#include "mlab/lang/cnl/tree.h"

namespace mlab::cnl {

/// What a procedure has under one of its other names, as flow::Alias tells it.
struct AliasSignature {
  struct Port {
    std::string name;  ///< two historic names of one input are told as `a|b`
    std::string unit;
  };
  std::vector<Port> inputs;          ///< of the procedure, in their order
  std::vector<std::string> ignored;  ///< what is accepted and means nothing
  std::string output_unit;
};

/// What an alias does not speak of is as the procedure has it.
AliasSignature signature_of(const Procedure& procedure, const AliasDecl& alias);

}  // namespace mlab::cnl
