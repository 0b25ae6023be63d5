// Any bytes as the definition of a batch; what is understood of it is planned.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "mlab/study/plan.h"
#include "mlab/study/study_file.h"

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  const std::string text(reinterpret_cast<const char*>(data), size);
  mlab::text::Diagnostics sink;
  mlab::study::Definition definition;
  const bool is_good = mlab::study::read_study(std::make_shared<const mlab::text::Source>("fuzz.toml", text),
                                               definition, sink);
  if (is_good == sink.has_errors()) std::abort();
  mlab::text::render(sink);
  if (!is_good || mlab::study::settle(definition)) return 0;
  if (definition.is_latin && definition.runs > 1000) return 0;  // takes its time, and nothing else
  const mlab::study::Plan plan(definition);
  if (plan.combinations() > mlab::study::Plan::kMostCombinations) return 0;
  for (std::uint64_t i = 0; i < plan.all() && i < 20; ++i) mlab::study::text_of(plan.settings(plan.key(i)));
  mlab::study::text_of(plan.settings(
      mlab::study::RunKey{0, static_cast<std::uint32_t>(plan.combinations() - 1), plan.runs() - 1}));
  return 0;
}
