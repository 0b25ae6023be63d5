// Any bytes as a CNL file: it ends, nothing is read out of bounds, and what has no errors keeps its meaning
// and its layout when it is printed.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/compiler_messages.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/format.h"
#include "mlab/lang/cnl/generate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/lang/cnl/parser.h"
#include "mlab/lang/cnl/testing/meaning.h"

namespace {

using namespace mlab;

text::SourcePtr source_of(std::string text) {
  return std::make_shared<const text::Source>("fuzz.cnl", std::move(text));
}

void fail(const char* what, const std::string& printed) {
  std::fprintf(stderr, "%s\n%s\n", what, printed.c_str());
  std::abort();
}

void check_print(const text::SourcePtr& source) {
  text::Diagnostics sink;
  const auto once = cnl::format(source, sink);
  if (!once) return;
  const auto twice = cnl::format(source_of(*once), sink);
  if (!twice) fail("what was printed cannot be read:", *once + "\n" + text::render(sink));
  if (*twice != *once) fail("printing again changes it:", *once + "\n-----\n" + *twice);
  if (cnl::testing::meaning(source_of(*once)) != cnl::testing::meaning(source))
    fail("printing changed its meaning:", *once);
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  const text::SourcePtr source = source_of(std::string(reinterpret_cast<const char*>(data), size));
  text::Diagnostics sink;
  const cnl::Tree tree = cnl::parse(source, sink);
  cnl::check_order(tree, sink);
  cnl::check_declarations(tree, sink);
  cnl::elaborate(tree, sink);
  if (!sink.has_errors()) cnl::generate(tree, {"fuzz.cc", true});
  cnl::report_compiler_messages(source->text(), tree, sink);
  text::render(sink);
  cnl::looks_like_cnl(source->text());
  check_print(source);
  return 0;
}
