#include "mlab/export/format.h"

#include "mlab/export/btcpp.h"
#include "mlab/export/graph.h"
#include "mlab/export/sausages.h"
#include "mlab/export/scxml.h"
#include "mlab/lang/cdl/formula/formula.h"

namespace mlab::exports {
namespace {

std::optional<std::string> write_formula(const Subject& subject, text::Diagnostics& sink) {
  const std::size_t errors_before = sink.error_count();
  const cdl::Formula formula = cdl::formula(subject.configuration, subject.library, sink);
  if (sink.error_count() > errors_before) return std::nullopt;
  return cdl::print(formula);
}

constexpr Format kFormats[] = {
    {"btcpp", "the sequence as a behavior tree (BehaviorTree.CPP 4)", write_btcpp},
    {"dot", "the network for Graphviz", write_dot},
    {"formula", "sentences of the grammar G, and what their names stand for", write_formula},
    {"graph", "the network as JSON: nodes, ports, wires, states, layout", write_graph},
    {"sausages", "the sequence as a SAUSAGES plan (architecture UGV)", write_sausages},
    {"scxml", "the sequences as a state chart (SCXML)", write_scxml},
};

}  // namespace

std::span<const Format> formats() {
  return kFormats;
}

const Format* find_format(std::string_view name) {
  for (const Format& format : kFormats) {
    if (format.name == name) return &format;
  }
  return nullptr;
}

}  // namespace mlab::exports
