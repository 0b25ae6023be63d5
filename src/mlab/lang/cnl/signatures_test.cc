#include "mlab/lang/cnl/signatures.h"

#include <span>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/flow/program.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/parser.h"

// NOLINTNEXTLINE(misc-use-internal-linkage): it is defined in generated code
std::span<const mlab::flow::Behavior* const> mlab_cnl_state();

namespace mlab::cnl {
namespace {

text::SourcePtr state_file() {
  return text::read_source(base::source_folder() + "/src/mlab/lang/cnl/testdata/run/state.cnl")
      .value_or(nullptr);
}

TEST(Signatures, SayWhatTheCompiledDescriptorsSay) {
  text::Diagnostics sink;
  const Tree tree = parse(state_file(), sink);
  const flow::Library types;
  const Signatures signatures(tree, [&](std::string_view name) { return types.find_type(name); });
  const auto compiled = mlab_cnl_state();
  ASSERT_EQ(signatures.behaviors().size(), compiled.size());
  for (std::size_t i = 0; i < compiled.size(); ++i) {
    const flow::Behavior& a = *signatures.behaviors()[i];
    const flow::Behavior& b = *compiled[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.help, b.help);
    EXPECT_EQ(a.file, b.file);
    EXPECT_EQ(a.output_unit, b.output_unit);
    EXPECT_EQ(a.is_pure, b.is_pure);
    EXPECT_EQ(a.latency_cycles, b.latency_cycles);
    ASSERT_EQ(a.output == nullptr, b.output == nullptr);
    if (a.output) {
      EXPECT_EQ(a.output->name, b.output->name);
    }
    ASSERT_EQ(a.inputs.size(), b.inputs.size());
    for (std::size_t j = 0; j < a.inputs.size(); ++j) {
      EXPECT_EQ(a.inputs[j].name, b.inputs[j].name);
      EXPECT_EQ(a.inputs[j].type->name, b.inputs[j].type->name);
      EXPECT_EQ(a.inputs[j].unit, b.inputs[j].unit);
      EXPECT_EQ(a.inputs[j].help, b.inputs[j].help);
      EXPECT_EQ(a.inputs[j].is_list, b.inputs[j].is_list);
      EXPECT_EQ(a.inputs[j].default_text, b.inputs[j].default_text);
      EXPECT_EQ(a.inputs[j].min, b.inputs[j].min);
      EXPECT_EQ(a.inputs[j].max, b.inputs[j].max);
    }
    ASSERT_EQ(a.aliases.size(), b.aliases.size());
    for (std::size_t j = 0; j < a.aliases.size(); ++j) {
      EXPECT_EQ(a.aliases[j].name, b.aliases[j].name);
      EXPECT_EQ(a.aliases[j].output_unit, b.aliases[j].output_unit);
      ASSERT_EQ(a.aliases[j].inputs.size(), b.aliases[j].inputs.size());
      for (std::size_t k = 0; k < a.aliases[j].inputs.size(); ++k) {
        EXPECT_EQ(a.aliases[j].inputs[k].name, b.aliases[j].inputs[k].name);
        EXPECT_EQ(a.aliases[j].inputs[k].unit, b.aliases[j].inputs[k].unit);
      }
      EXPECT_EQ(a.aliases[j].ignored_inputs.size(), b.aliases[j].ignored_inputs.size());
    }
    ASSERT_EQ(a.needs.size(), b.needs.size());
    for (std::size_t j = 0; j < a.needs.size(); ++j) {
      EXPECT_EQ(a.needs[j].sensor, b.needs[j].sensor);
      EXPECT_EQ(a.needs[j].range_input, b.needs[j].range_input);
      EXPECT_EQ(a.needs[j].range, b.needs[j].range);
    }
  }
}

TEST(Signatures, AreEnoughToCheckANetwork) {
  text::Diagnostics sink;
  const Tree tree = parse(state_file(), sink);
  flow::Library library;
  const Signatures signatures(tree, [&](std::string_view name) { return library.find_type(name); });
  library.add(signatures.behaviors());
  EXPECT_TRUE(flow::build_program(elaborate(tree, sink), library, sink)) << text::render(sink);
  EXPECT_FALSE(sink.has_errors()) << text::render(sink);
}

}  // namespace
}  // namespace mlab::cnl
