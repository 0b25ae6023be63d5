// Any bytes as a map-info file.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "mlab/lang/odl/map_info.h"
#include "mlab/text/diagnostic.h"

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  const std::string text(reinterpret_cast<const char*>(data), size);
  mlab::text::Diagnostics sink;
  const auto info =
      mlab::odl::parse_map_info(std::make_shared<const mlab::text::Source>("fuzz.mapinfo", text), sink);
  if (info.has_value() == sink.has_errors()) std::abort();
  if (info && !(info->width > 0.0 && info->height > 0.0 && !info->picture.empty())) std::abort();
  mlab::text::render(sink);
  return 0;
}
