#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "mlab/flow/program.h"
#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/parser.h"

#include "library_probe.h"

namespace mlab::library_test {

/// The program of a network in CNL over the component library. Errors fail the test, and warnings unless
/// told.
inline std::shared_ptr<const flow::Program> program_of(std::string_view name, std::string_view cnl_text,
                                                       bool may_warn = false) {
  const auto source = std::make_shared<text::Source>(std::string(name), std::string(cnl_text));
  text::Diagnostics diagnostics;
  const cnl::Tree tree = cnl::parse(source, diagnostics);
  cnl::check_declarations(tree, diagnostics);
  const flow::Network network = cnl::elaborate(tree, diagnostics);
  auto program = flow::build_program(network, library(), diagnostics);
  EXPECT_TRUE(diagnostics.items().empty() || (may_warn && !diagnostics.has_errors()))
      << text::render(diagnostics);
  return program;
}

}  // namespace mlab::library_test
