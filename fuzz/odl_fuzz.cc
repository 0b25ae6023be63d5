// Any bytes as an overlay: it ends, nothing is read out of bounds, and what has no errors keeps its meaning,
// comments and layout when it is printed.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "mlab/lang/odl/odl.h"
#include "mlab/lang/odl/testing/check_print.h"
#include "mlab/text/diagnostic.h"

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  bool had_errors = false;
  const std::string change = mlab::odl::what_print_changes(text, had_errors);
  if (!change.empty()) {
    std::fputs(change.c_str(), stderr);
    std::abort();
  }
  mlab::text::Diagnostics sink;
  mlab::odl::parse(std::make_shared<const mlab::text::Source>("fuzz.odl", std::string(text)), sink);
  mlab::text::render(sink);
  mlab::odl::looks_like_odl(text);
  return 0;
}
