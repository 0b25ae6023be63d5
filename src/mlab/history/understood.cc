#include "mlab/history/understood.h"

#include <optional>
#include <utility>
#include <variant>

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

std::shared_ptr<Understood> Understood::branch(std::shared_ptr<const History> history, std::size_t inputs) {
  if (inputs > 0) static_cast<void>(input(inputs - 1));
  auto out = std::make_shared<Understood>(std::move(history), remaker_.tools());
  out->inputs_.assign(inputs_.begin(), inputs_.begin() + static_cast<std::ptrdiff_t>(inputs));
  std::shared_ptr<const run::Crew> crew;
  for (const One& one : out->inputs_) {
    if (const auto* exchanged = one ? std::get_if<run::input::Exchanged>(&*one) : nullptr)
      crew = exchanged->crew;
  }
  out->remaker_.take_up(remaker_, std::move(crew), inputs);
  return out;
}

}  // namespace mlab::history
