#pragma once

#include <dds/dds.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace mlab::ros2 {

/// Takes what has come to a reader, some hundred messages at most; the rest is taken the next time.
/// @param reader  0: nothing comes
/// @param take    (const Message&, const dds_sample_info_t&); the message is gone after it
template <class Message, class Take>
void take_all(dds_entity_t reader, Take&& take) {
  constexpr std::uint32_t kBatch = 16;
  constexpr int kMostBatches = 16;
  for (int i = 0; reader > 0 && i < kMostBatches; ++i) {
    std::array<void*, kBatch> samples{};
    std::array<dds_sample_info_t, kBatch> infos{};
    const dds_return_t count = dds_take(reader, samples.data(), infos.data(), kBatch, kBatch);
    for (std::size_t k = 0; k < static_cast<std::size_t>(std::max(count, 0)); ++k) {
      if (infos[k].valid_data) take(*static_cast<const Message*>(samples[k]), infos[k]);
    }
    if (count > 0) dds_return_loan(reader, samples.data(), count);
    if (count < static_cast<dds_return_t>(kBatch)) return;
  }
}

}  // namespace mlab::ros2
