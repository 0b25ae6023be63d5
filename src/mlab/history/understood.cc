#include "mlab/history/understood.h"

#include <optional>
#include <utility>

#include "mlab/text/one_line.h"

namespace mlab::history {
namespace {

std::string what_fails(const wire::HistoryInput& input) {
  if (input.has_exchanged()) return "another version of the mission can't be made: ";
  return input.has_posted() ? "an order can't be understood: " : "";
}

}  // namespace

const Understood::One& Understood::input(std::size_t index) {
  while (inputs_.size() <= index) {
    text::Diagnostics problems;
    const wire::HistoryInput& next = history_->inputs()[inputs_.size()].input;
    std::optional<run::Input> one = remaker_.understand(next, problems);
    if (one)
      inputs_.emplace_back(std::move(*one));
    else
      inputs_.emplace_back(std::unexpected(what_fails(next) + text::first_error(problems)));
  }
  return inputs_[index];
}

}  // namespace mlab::history
