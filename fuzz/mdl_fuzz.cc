// Any bytes as a mission: checked, printed and read again; then as a line that an operator types.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/testing/check_print.h"
#include "mlab/text/diagnostic.h"

namespace {

std::shared_ptr<const mlab::mission::Mission> check(const std::string& text) {
  mlab::text::Diagnostics sink;
  const auto source = std::make_shared<const mlab::text::Source>("fuzz.mdl", text);
  auto mission = mlab::mdl::check_mission(source, "/nowhere", sink);
  if ((mission == nullptr) != sink.has_errors()) std::abort();
  mlab::text::render(sink);
  return mission;
}

void type(const std::string& line, const mlab::mission::Mission& mission) {
  mlab::text::Diagnostics sink;
  const auto typed = mlab::mdl::parse_immediate(line, mission, sink);
  if (typed.has_value() == sink.has_errors()) std::abort();
  mlab::text::render(sink);
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  static const auto kMission = check(
      "SP Home 10 10\nUNIT <scouts> (<front> ROBOT) (<rear> ROBOT)\nCOMMAND LIST:\n0. UNIT scouts START Home "
      "0 5\n");
  const std::string text(reinterpret_cast<const char*>(data), size);
  check(text);
  type(text, *kMission);
  mlab::mdl::looks_like_mdl(text);
  bool had_errors = false;
  const std::string changes = mlab::mdl::what_print_changes(text, had_errors);
  if (changes.empty()) return 0;
  std::fprintf(stderr, "%s\n", changes.c_str());
  std::abort();
}
