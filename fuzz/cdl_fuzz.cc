// Any bytes as a configuration: read, laid out, printed, read again, checked, flattened; what is right
// becomes CNL.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "mlab/lang/cdl/emit_cnl.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/parser.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace {

namespace cdl = mlab::cdl;
namespace text = mlab::text;

text::SourcePtr source(std::string bytes) {
  return std::make_shared<const text::Source>("fuzz.cdl", std::move(bytes));
}

void fail(const char* why, const std::string& what) {
  std::fprintf(stderr, "%s:\n%s\n", why, what.c_str());
  std::abort();
}

// A file that is right stays right when it is laid out or printed, and neither changes anything the second
// time.
void check_round_trips(const cdl::Tree& tree) {
  text::Diagnostics sink;
  const std::string laid_out = cdl::laid_out(tree.source->text());
  if (cdl::laid_out(laid_out) != laid_out) fail("laid out twice differs", laid_out);
  const std::string printed = cdl::print(tree);
  const std::string again = cdl::print(cdl::parse(source(laid_out), sink));
  if (again != printed) fail("laying out changed the tree", laid_out);
  if (cdl::print(cdl::parse(source(printed), sink)) != printed) fail("printing changed the tree", printed);
  if (sink.has_errors()) fail(text::render(sink).c_str(), printed);
}

void check_robots(const cdl::Configuration& configuration) {
  for (const cdl::Robot* robot : configuration.own_robots) {
    text::Diagnostics sink;
    cdl::EarlierFindings said;
    const cdl::LoweredRobot lowered =
        cdl::lower(configuration, *robot, mlab::robot::component_library(), sink, said);
    if (sink.has_errors() || lowered.network.nodes.size() > 1000) continue;
    const std::string cnl = cdl::cnl_text(lowered.network);
    text::Diagnostics cnl_sink;
    const auto network = mlab::cnl::elaborate(mlab::cnl::parse(source(cnl), cnl_sink), cnl_sink);
    if (cnl_sink.has_errors()) fail(text::render(cnl_sink).c_str(), cnl);
    if (cdl::cnl_text(network) != cnl) fail("CNL read and written differs", cnl);
    cdl::build(lowered, mlab::robot::component_library(), sink, said);
  }
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  cdl::looks_like_cdl(bytes);
  text::Diagnostics sink;
  const auto tree = std::make_shared<const cdl::Tree>(cdl::parse(source(bytes), sink));
  text::render(sink);
  if (!sink.has_errors()) check_round_trips(*tree);
  // Nothing on this machine is read.
  const text::Files nothing{[](const std::string&) { return false; },
                            [](const std::string& path) -> text::Result<text::SourcePtr> {
                              text::Diagnostic d;
                              d.kind = "cannot-read";
                              d.message = path;
                              return std::unexpected(d);
                            },
                            {}};
  const cdl::Configuration configuration = cdl::configuration_of(tree, {{}, &nothing}, sink);
  const bool was_right = !sink.has_errors();
  cdl::check(configuration, mlab::robot::component_library(), sink);
  text::render(sink);
  if (was_right) check_robots(configuration);
  return 0;
}
