// Any bytes as a configuration and as an Edit, and edits that any eight bytes choose: it ends, nothing is
// read out of bounds, and what could be read before can be read afterwards.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "mlab/base/random.h"
#include "mlab/designer/edit/edit.h"
#include "mlab/designer/testing/random_edit.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/text/utf8.h"

namespace {

using mlab::designer::Edit;
using mlab::designer::Model;

constexpr std::size_t kLargest = 8000;  // bytes: each change reads everything anew
constexpr int kEdits = 4;

std::shared_ptr<const Model> model_of(std::string text) {
  return std::make_shared<const Model>(std::make_shared<const mlab::text::Source>("a.cdl", std::move(text)),
                                       mlab::robot::library_environment());
}

void check(const std::shared_ptr<const Model>& before, const Edit& edit, std::shared_ptr<const Model>& now) {
  const auto done = mlab::designer::edited(before, mlab::robot::library_environment(), edit);
  if (!done) return;
  now = model_of(done->text);
  if (now->is_readable()) return;
  std::fputs(("this can't be read any more:\n" + done->text).c_str(), stderr);
  std::abort();
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  if (size < 12 || size > kLargest) return 0;
  std::uint64_t seed = 0;
  std::uint16_t length = 0;
  std::memcpy(&seed, data, sizeof seed);
  std::memcpy(&length, data + 8, sizeof length);
  const std::size_t message = length % (size - 10);
  Edit edit;
  const bool is_edit = edit.ParseFromArray(data + 10, static_cast<int>(message));
  std::string text =
      mlab::text::as_utf8({reinterpret_cast<const char*>(data) + 10 + message, size - 10 - message});
  std::shared_ptr<const Model> model = model_of(std::move(text));
  if (!model->is_readable()) return 0;
  if (is_edit) check(model, edit, model);
  mlab::base::Random random(seed);
  for (int i = 0; i < kEdits; ++i)
    check(model, mlab::designer::testing::RandomEdit(*model, random).make(), model);
  return 0;
}
