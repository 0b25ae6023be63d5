#include "mlab/cli/batch_rank.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include <fmt/core.h>

namespace mlab::cli {
namespace {

constexpr std::uint32_t kMostProcesses = 1'000'000;

std::optional<std::uint32_t> whole(std::string_view text) {
  std::uint32_t out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc{} || end != text.data() + text.size() || out > kMostProcesses * 10)
    return std::nullopt;
  return out;
}

std::optional<std::uint32_t> number(const Variables& variables, const char* name) {
  const auto value = variables(name);
  return value ? whole(*value) : std::nullopt;
}

/// What a launcher tells each of its processes.
struct Launcher {
  const char* rank;
  const char* size;
  const char* job;   ///< a variable that tells one start from another; may be missing
  const char* part;  ///< likewise, together with it; null: none
};
constexpr Launcher kLaunchers[] = {
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "PMIX_NAMESPACE",
     "OMPI_MCA_orte_precondition_transports"},
    {"PMI_RANK", "PMI_SIZE", "PMI_JOBID", nullptr},
    // Only srun sets the step's number of tasks; a script that sbatch starts is one process of one.
    {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_JOB_ID", "SLURM_STEP_ID"},
};

study::Share launched(const Variables& variables) {
  for (const Launcher& launcher : kLaunchers) {
    const auto rank = number(variables, launcher.rank);
    const auto size = number(variables, launcher.size);
    if (!rank || !size || *size == 0 || *size > kMostProcesses || *rank >= *size) continue;
    study::Share out;
    out.rank = *rank;
    out.number = *rank;
    out.count = *size;
    out.writes_table = *rank == 0;
    if (const auto job = variables(launcher.job)) {
      out.job = fmt::format("{} {}", launcher.job, *job);
      if (launcher.part != nullptr) out.job += "." + variables(launcher.part).value_or("");
    }
    return out;
  }
  return {};
}

}  // namespace

Variables environment() {
  return [](const char* name) -> std::optional<std::string> {
    const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets any here
    if (value == nullptr) return std::nullopt;
    return value;
  };
}

study::Share share_from(const Variables& variables) {
  study::Share out = launched(variables);
  const auto task = number(variables, "SLURM_ARRAY_TASK_ID");
  const auto tasks = number(variables, "SLURM_ARRAY_TASK_COUNT");
  if (!task || !tasks || *tasks < 2 || *tasks > kMostProcesses / out.count) return out;
  // Tasks may have any numbers: 3, 5, 9. Whose shares then are the same helps the others the sooner.
  const std::uint32_t first = number(variables, "SLURM_ARRAY_TASK_MIN").value_or(0);
  const std::uint32_t step = std::max(1U, number(variables, "SLURM_ARRAY_TASK_STEP").value_or(1));
  const std::uint32_t place = (*task - std::min(first, *task)) / step % *tasks;
  out.rank += place * out.count;
  out.number += *task * out.count;
  out.count *= *tasks;
  out.job = "SLURM_ARRAY_JOB_ID " + variables("SLURM_ARRAY_JOB_ID").value_or("");
  // Tasks may run one after another: nobody knows which is the last.
  out.writes_table = false;
  return out;
}

std::optional<study::Share> share_in(const std::string& text) {
  if (text == "none") return study::Share{};
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto rank = whole(std::string_view(text).substr(0, slash));
  const auto count = whole(std::string_view(text).substr(slash + 1));
  if (!rank || !count || *count == 0 || *count > kMostProcesses || *rank >= *count) return std::nullopt;
  study::Share out;
  out.rank = *rank;
  out.number = *rank;
  out.count = *count;
  out.writes_table = *rank == 0;
  return out;
}

}  // namespace mlab::cli
