// How long a change of a drawing takes: from its message to the text that it makes, in processor time.
//
//     edit_bench ASSEMBLAGES TIMES    (65 are 3,100 lines, 600 are 1 MB)

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/model.h"
#include "mlab/designer/edit/edit.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer {
namespace {

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

std::string written(int assemblages) {
  std::string out;
  for (int i = 0; i < assemblages; ++i) {
    out += fmt::format(
        "/// Says what it is.\nassemblage A{}(near: length = 2 m) {{\n  // inside\n"
        "  let around = sense_obstacles(range = near);\n  cooperate {{\n",
        i);
    for (int k = 0; k < 8; ++k) {
      out += fmt::format(
          "    1: cooperate {{\n      1: Noise(persistence = {} s);\n"
          "      0.5: AvoidStaticObstacles(readings = around, sphere = 1 m, safety_margin = 0.5 m);  // "
          "near\n"
          "      0.8: Probe(readings = around);\n    }};\n",
          k + 1);
    }
    out += "  }\n}\n\n";
  }
  return cdl::laid_out(out + "layout A0 {\n  cooperate 10 20;\n  around 3 4;\n}\n");
}

class Bench {
 public:
  Bench(int assemblages, int times)
      : page_(fmt::format("A{}", assemblages / 2)),
        times_(times),
        model_(std::make_shared<const Model>(
            std::make_shared<const text::Source>("bench.cdl", written(assemblages)),
            robot::library_environment())) {}

  /// @return whether every change could be done
  bool run() const {
    fmt::print("{} lines, {} bytes\n", std::ranges::count(model_->text(), '\n'), model_->text().size());
    const bool has_value = measure("a value", [this](Change& change) {
      change.mutable_set_value()->set_page(page_);
      change.mutable_set_value()->set_node("around");
      change.mutable_set_value()->set_port("range");
      change.mutable_set_value()->set_value("3 m");
    });
    const bool has_name = measure("a name", [this](Change& change) {
      change.mutable_rename()->set_page(page_);
      change.mutable_rename()->set_node("around");
      change.mutable_rename()->set_name("near_by");
    });
    const bool has_place = measure("a place", [](Change& change) {
      change.mutable_arrange()->set_page("A0");
      Arrange::At& at = *change.mutable_arrange()->add_nodes();
      at.set_node("cooperate");
      at.set_x(33);
    });
    return has_value && has_name && has_place;
  }

 private:
  bool measure(const char* what, const std::function<void(Change&)>& fill) const {
    Edit edit;
    fill(*edit.add_changes());
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < times_; ++i) {
      const double begin = processor_ms();
      const text::Result<Edited> done = edited(model_, robot::library_environment(), edit);
      best = std::min(best, processor_ms() - begin);
      if (done) continue;
      fmt::print(stderr, "{}\n", done.error().message);
      return false;
    }
    fmt::print("{}: {:.1f} ms\n", what, best);
    return true;
  }

  std::string page_;
  int times_;
  std::shared_ptr<const Model> model_;
};

}  // namespace
}  // namespace mlab::designer

int main(int argc, char** argv) {
  const int assemblages = argc > 1 ? std::atoi(argv[1]) : 65;
  const int times = argc > 2 ? std::atoi(argv[2]) : 15;
  return mlab::designer::Bench(std::max(assemblages, 1), std::max(times, 1)).run() ? 0 : 1;
}
