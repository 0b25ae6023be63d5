#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>

#include "mlab/cli/batch_study.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/version.h"
#include "mlab/python/bindings.h"
#include "mlab/study/batch.h"
#include "mlab/study/page.h"
#include "mlab/study/study_file.h"
#include "mlab/study/summary.h"
#include "mlab/study/table.h"

namespace mlab::python {
namespace {

using namespace pybind11::literals;
using Given = std::vector<std::pair<std::string, std::string>>;

void complain_if(const std::optional<text::Diagnostic>& problem) {
  if (problem) raise(*problem);
}

// Out of the mission or the study's file, and what was given beside it, which counts more.
study::Definition definition_of(const std::string& file, const Given& given) {
  study::Definition out;
  text::Diagnostics sink;
  if (study::is_study_file(file)) {
    const auto source = text::read_source(file);
    if (!source) raise(source.error());
    if (!study::read_study(*source, out, sink)) raise(sink);
  } else {
    complain_if(study::take(out, "mission", study::written_in_option("mission", file)));
  }
  for (const auto& [field, value] : given) {
    const study::Written written = study::written_in_option(field, value);
    if (field == "set") {
      study::Definition one;
      complain_if(study::take(one, field, written));
      std::erase_if(out.dimensions, [&](const study::Dimension& before) {
        return before.name.text == one.dimensions.front().name.text;
      });
    }
    complain_if(study::take(out, field, written));
  }
  complain_if(study::settle(out));
  if (out.start_time.empty()) out.start_time = cli::print(cli::wall_clock());
  if (!cli::parse_start_time(out.start_time))
    raise("start_time " + out.start_time + ": expected YYYY-MM-DD HH:MM or YYYY-MM-DD HH:MM:SS");
  return out;
}

// Somebody who asks is told how far it is; what he raises ends it.
class Teller {
 public:
  explicit Teller(py::object tell) : tell_(std::move(tell)) {}
  ~Teller() = default;
  Teller(const Teller&) = delete;
  Teller& operator=(const Teller&) = delete;

  void look(const study::Progress& now, Signals& signals) {
    if (signals.wants_end()) has_ended_ = true;
    if (tell_.is_none() || has_ended_) return;
    stay_where_python_ends();
    const py::gil_scoped_acquire locked;
    try {
      tell_(now.done, now.all);
    } catch (py::error_already_set&) {
      raised_ = std::current_exception();
      has_ended_ = true;
    }
  }
  bool has_ended() const { return has_ended_; }
  void raise_again() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  py::object tell_;
  std::exception_ptr raised_;
  std::atomic<bool> has_ended_ = false;  // asked by the threads of the batch
};

py::dict run_batch(const std::string& file, const Given& given, int threads, bool allows_native,
                   bool has_cell, bool wants_page, const py::object& tell) {
  const study::Definition definition = definition_of(file, given);
  const study::Plan plan(definition);
  const cell::Permission permission = permission_for(definition.mission.text, allows_native, has_cell);
  text::Diagnostics sink;
  const cli::Scenes scenes =
      beside([&](const std::stop_token&) { return cli::scenes_of(definition, plan, permission, {}, sink); });
  if (scenes.all.empty()) raise(sink);
  study::Batch batch(definition, plan, scenes.all, nullptr);
  Teller teller(tell);
  without_lock([&](Signals& signals) {
    const auto end = batch.run(
        threads, [&] { return teller.has_ended(); },
        [&](const study::Progress& now) { teller.look(now, signals); });
    return end;
  });
  teller.raise_again();
  const study::Summary summary = study::summary_of(batch, definition, plan);
  const std::string& title = scenes.all.front()->mission_name();
  return py::dict(
      "json"_a = study::json_of(batch, summary, definition, plan, cli::kVersion),
      "page"_a =
          wants_page ? study::page_of(batch, summary, definition, plan, {title, "", cli::kVersion}) : "",
      "are_all_met"_a = summary.are_all_met(), "warnings"_a = said_of(sink));
}

}  // namespace

void bind_batches(py::module_& module) {
  module.def("batch", &run_batch);
}

}  // namespace mlab::python
