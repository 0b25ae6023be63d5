#include "mlab/designer/component_tests/test_file.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "mlab/base/hash.h"
#include "mlab/component_test/feeding.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/tests.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl/syntax/walk.h"
#include "mlab/lang/cnl/native_module.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/text/utf8.h"

namespace mlab::designer {
namespace {

/// The first assemblage that an expression calls.
const cdl::Assemblage* called_in(const cdl::Expression& expression, const cdl::Configuration& configuration) {
  const cdl::Assemblage* found = nullptr;
  cdl::for_each_expression(expression, [&](const cdl::Expression& part) {
    const auto* call = std::get_if<cdl::Call>(&part.what);
    if (call != nullptr && found == nullptr) found = configuration.assemblage_named(call->callee);
  });
  return found;
}

}  // namespace

std::optional<TestFile> test_file_of(const text::SourcePtr& source, const text::Files& files) {
  if (source->text().find("test") == std::string_view::npos) return std::nullopt;
  const auto written = cdl::read_as_written(source);
  const std::vector<const cdl::Test*> tests = cdl::tests_of(written.tree);
  if (tests.empty()) return std::nullopt;
  cdl::Environment environment = robot::library_environment();
  environment.files = &files;
  text::Diagnostics ignored;
  const cdl::Configuration configuration = cdl::load(source, environment, ignored);
  TestFile out;
  out.source = source;
  for (const cdl::Test* test : tests) {
    WrittenTest& one = out.tests.emplace_back();
    one.name = text::as_utf8(test->name.text);
    one.place = test->name.place;
    if (!test->subject) continue;
    one.component = component_test::in_short(source->text(test->subject->place.span));
    const cdl::Assemblage* assemblage = called_in(*test->subject, configuration);
    if (assemblage == nullptr) continue;
    one.declared = assemblage->name.place;
    one.assemblage = assemblage->name.text;
  }
  out.used = {source->name()};
  out.used.insert(configuration.files.begin(), configuration.files.end());
  out.seal = base::hash_text(source->text());
  for (const std::string& path : configuration.files) {
    const text::Result<text::SourcePtr> used = files.read(path);
    out.seal = base::combine_bits(out.seal, base::hash_text(path));
    out.seal = base::combine_bits(out.seal, used ? base::hash_text((*used)->text()) : 0);
  }
  out.brings_code = std::ranges::any_of(configuration.procedures,
                                        [](const auto& tree) { return cnl::has_procedures(*tree); });
  return out;
}

}  // namespace mlab::designer
