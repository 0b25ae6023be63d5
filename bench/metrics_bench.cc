// What metrics cost a run in the console, in processor time: noting one control cycle, and putting down and
// telling what there is of a hundred robots.
//
//     metrics_bench

#include <cstddef>
#include <ctime>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/console/run/cycle_times.h"
#include "mlab/metrics/exposition.h"

namespace mlab {
namespace {

double processor_ns() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

template <class Work>
double ns_each(int times, Work work) {
  const double begin = processor_ns();
  for (int i = 0; i < times; ++i) work();
  return (processor_ns() - begin) / times;
}

// Three series of each robot, as a session puts them down twice a second.
void put_down(metrics::Exposition& out) {
  std::vector<metrics::Exposition::Series> series;
  for (std::size_t robot = 1; robot <= metrics::kMostSeries; ++robot)
    series.push_back({{{"robot", std::to_string(robot)}}, 0.125 * static_cast<double>(robot)});
  out.counter("mlab_robot_contacts_total", "Contacts.", series);
  out.gauge("mlab_robot_percept_age_seconds", "Age.", series);
  out.gauge("mlab_robot_silence_seconds", "Silence.", series);
}

}  // namespace
}  // namespace mlab

int main() {
  using namespace mlab;
  console::CycleTimes times;
  const double cycle = ns_each(1'000'000, [&] {
    const console::CycleTimes::Watch watch(times);
    watch.note(times);
  });
  const double look = ns_each(1'000, [] {
    metrics::Exposition out;
    put_down(out);
  });
  metrics::Exposition told;
  put_down(told);
  std::size_t bytes = 0;
  const double text = ns_each(1'000, [&] { bytes = told.text().size(); });
  fmt::print("one cycle noted      {:8.2f} us\n", cycle * 1e-3);
  fmt::print("100 robots put down  {:8.1f} us\n", look * 1e-3);
  fmt::print("and told             {:8.1f} us, {} bytes\n", text * 1e-3, bytes);
}
