#include "mlab/history/understood.h"

#include <optional>
#include <utility>

#include <fmt/core.h>

namespace mlab::history {

const Understood::One& Understood::input(std::size_t index) {
  while (inputs_.size() <= index) {
    text::Diagnostics problems;
    std::optional<run::Input> one = remaker_.understand(history_->inputs()[inputs_.size()].input, problems);
    if (one)
      inputs_.emplace_back(std::move(*one));
    else
      inputs_.emplace_back(
          std::unexpected(fmt::format("what came in can't be understood any more: {}",
                                      problems.items().empty() ? "" : problems.items().front().message)));
  }
  return inputs_[index];
}

}  // namespace mlab::history
