// Any bytes as sentences of the grammar G: reading ends, and what has no errors gives a configuration that
// prints as the same sentences.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/lang/cdl/formula/formula_parser.h"

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  using namespace mlab;
  const auto source = std::make_shared<const text::Source>(
      "fuzz.formula", std::string(reinterpret_cast<const char*>(data), size));
  text::Diagnostics sink;
  auto tree = std::make_shared<const cdl::Tree>(cdl::parse_formula(source, sink));
  cdl::looks_like_formula(source->text());
  text::render(sink);
  if (sink.has_errors()) return 0;
  std::string read;
  for (const cdl::Term& sentence : cdl::parse_sentences(source, sink)) read += cdl::print(sentence) + "\n";
  const cdl::Configuration configuration = cdl::configuration_of(tree, {}, sink);
  std::string written;
  for (const std::string& one : cdl::formula(configuration, flow::Library(), sink).sentences)
    written += one + "\n";
  if (sink.has_errors() || read == written) return 0;
  std::fprintf(stderr, "%s-----\n%s", read.c_str(), written.c_str());
  std::abort();
}
