// Any bytes as a historic configuration: the import ends, nothing is read out of bounds, and what comes out
// is a configuration of ours: it parses without an error and prints the same again.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "mlab/flow/library.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl_historic/import.h"
#include "mlab/library/library.h"
#include "mlab/text/diagnostic.h"

namespace {

const mlab::cdl_historic::Vocabulary& vocabulary() {
  static const mlab::flow::Library kProcedures = [] {
    mlab::flow::Library out;
    out.add(mlab_library_behaviors());
    return out;
  }();
  static const mlab::cdl_historic::Vocabulary kVocabulary(kProcedures, {});
  return kVocabulary;
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  using namespace mlab;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  text::Diagnostics sink;
  const cdl::Tree tree = cdl_historic::import(
      std::make_shared<const text::Source>("fuzz.cdl", std::string(text)), vocabulary(), sink);
  text::render(sink);
  const std::string printed = cdl::print(tree);
  text::Diagnostics again;
  const cdl::Tree read = cdl::parse(std::make_shared<const text::Source>("ours.cdl", printed), again);
  if (again.has_errors() || cdl::print(read) != printed) {
    std::fputs((printed + text::render(again)).c_str(), stderr);
    std::abort();
  }
  return 0;
}
