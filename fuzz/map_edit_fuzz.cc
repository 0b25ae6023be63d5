// Any bytes as an overlay, and changes of its map that any eight bytes choose: it ends, nothing is read out
// of bounds, what had no errors has none afterwards, and the map is as was asked for.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "mlab/base/random.h"
#include "mlab/console/testing/map_of_texts.h"
#include "mlab/console/testing/random_change.h"
#include "mlab/text/utf8.h"

namespace {

constexpr std::size_t kLargest = 20000;  // bytes: each change reads everything anew
constexpr int kChanges = 6;

void fail(const std::string& why, const std::string& text) {
  std::fputs((why + "\nnow:\n" + text).c_str(), stderr);
  std::abort();
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  if (size < 8 || size > kLargest) return 0;
  std::uint64_t seed = 0;
  std::memcpy(&seed, data, sizeof seed);
  // A document is UTF-8 from the moment it is opened.
  const std::string text = mlab::text::as_utf8({reinterpret_cast<const char*>(data) + 8, size - 8});
  mlab::console::testing::MapOfTexts texts(text);
  mlab::base::Random random(seed);
  for (int i = 0; i < kChanges; ++i) {
    const bool was_right = !texts.has_errors();
    const mlab::console::Scene before = texts.scene();
    const mlab::console::MapChange change = mlab::console::testing::random_change(before, random);
    if (!texts.change({change}).empty() || !was_right) continue;
    if (texts.has_errors()) fail(change.ShortDebugString() + "\n" + texts.said(), texts.overlay());
    const std::string difference = mlab::console::testing::difference(before, change, texts.scene());
    if (!difference.empty()) fail(change.ShortDebugString() + "\n" + difference, texts.overlay());
  }
  return 0;
}
