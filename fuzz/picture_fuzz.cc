// Any bytes as a background picture.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "mlab/overlay/picture.h"

namespace {

// Some number of three digits or more among the first.
bool asks_for_much(const std::string& bytes) {
  std::size_t digits = 0;
  for (const char c : bytes.substr(0, 200)) {
    digits = c >= '0' && c <= '9' ? digits + 1 : 0;
    if (digits > 3) return true;
  }
  return false;
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string why = mlab::overlay::why_not_shown(bytes);
  // Few bytes may ask for hundreds of megabytes: they would only take their time.
  if (why.empty() && asks_for_much(bytes)) return 0;
  const mlab::overlay::ShownPicture shown = mlab::overlay::shown_picture(bytes);
  if (shown.content_type.empty() == why.empty()) std::abort();
  if (shown.content_type.empty() != shown.bytes.empty()) std::abort();
  return 0;
}
