#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/lang/cdl/lower/binder.h"
#include "mlab/lang/cdl/lower/call_lowering.h"
#include "mlab/lang/cdl/lower/evaluator.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/value.h"
#include "mlab/lang/cdl/types/types.h"

namespace mlab::cdl {

/// The operators: cooperation, competition, generic coordination and fusion, sequencing, selection.
class OperatorLowering {
 public:
  struct Parts {
    const flow::Library& library;
    const Types& types;
    Findings& findings;
    Binder& binder;
    CallLowering& calls;
    Evaluator& values;
    flow::Network& network;
  };
  explicit OperatorLowering(const Parts& parts)
      : library_(parts.library),
        types_(parts.types),
        findings_(parts.findings),
        binder_(parts.binder),
        calls_(parts.calls),
        values_(parts.values),
        network_(parts.network) {}

  /// @param path  of the node that gives the value
  Value cooperate(const Cooperate& what, Scope& scope, const std::string& path, const text::Place& place);
  Value compete(const Compete& what, Scope& scope, const std::string& path, const text::Place& place);
  /// `coordinate by Op(...) { ... }` and `fuse by Op(...) { ... }`: members go to the first list input,
  /// weights to the second.
  Value generic(const Call& by, const std::vector<Member>& members, Scope& scope, const std::string& path,
                const text::Place& place);
  Value sequence(const Sequence& what, Scope& scope, const std::string& path, const text::Place& place);
  Value select(const Select& what, Scope& scope, const std::string& path, const text::Place& place);

 private:
  flow::State state(const State& state, Scope& scope, Value& member);
  std::optional<std::int64_t> case_value(const Word& word, const flow::TypeInfo& type);
  bool check_members(const std::vector<Member>& members, const char* what, const text::Place& place);
  /// The type that members of a sequence or select have in common.
  PortType common_type(const std::vector<Value>& members, const text::Place& place, const char* what);

  const flow::Library& library_;
  const Types& types_;
  Findings& findings_;
  Binder& binder_;
  CallLowering& calls_;
  Evaluator& values_;
  flow::Network& network_;
};

}  // namespace mlab::cdl
