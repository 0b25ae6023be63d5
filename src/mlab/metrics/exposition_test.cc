#include "mlab/metrics/exposition.h"

#include <ctime>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/metrics/process.h"
#include "mlab/metrics/testing/scrape.h"

namespace mlab::metrics {
namespace {

using testing::Scrape;

TEST(Exposition, IsTheTextFormat) {
  Exposition out;
  out.counter("mlab_contacts_total", "How often robots met something.", 3.0);
  out.gauge("mlab_robots", "Robots.", {{{{"state", "running"}}, 2.0}, {{{"state", "faulted"}}, 0.25}});
  EXPECT_EQ(out.text(),
            "# HELP mlab_contacts_total How often robots met something.\n"
            "# TYPE mlab_contacts_total counter\n"
            "mlab_contacts_total 3\n"
            "# HELP mlab_robots Robots.\n"
            "# TYPE mlab_robots gauge\n"
            "mlab_robots{state=\"running\"} 2\n"
            "mlab_robots{state=\"faulted\"} 0.25\n");
  EXPECT_EQ(Scrape(out.text()).problems(), "");
}

TEST(Exposition, AValueMayBeAnyText) {
  Exposition out;
  out.gauge("mlab_run_info", "1.", {{{{"mission", "a \"b\"\\c\nmlab_robots 7"}}, 1.0}});
  const Scrape scrape(out.text());
  EXPECT_EQ(scrape.problems(), "");
  EXPECT_EQ(scrape.value(R"(mlab_run_info{mission="a \"b\"\\c\nmlab_robots 7"})"), 1.0);
  EXPECT_EQ(scrape.values().size(), 1U);
}

TEST(Exposition, AFamilyWithoutSeriesIsNotToldAndALongOneIsCut) {
  Exposition out;
  out.gauge("mlab_nothing", "Nothing.", std::vector<Exposition::Series>{});
  std::vector<Exposition::Series> many;
  for (int i = 0; i < 1000; ++i) many.push_back({{{"robot", std::to_string(i)}}, 1.0});
  out.gauge("mlab_many", "Many.", many);
  const Scrape scrape(out.text());
  EXPECT_EQ(scrape.problems(), "");
  EXPECT_FALSE(scrape.types().contains("mlab_nothing"));
  EXPECT_EQ(scrape.values().size(), kMostSeries);
}

TEST(Exposition, AHistogramCountsUpToItsBounds) {
  Histogram times;
  times.note(1e-4);  // a bound belongs to its bucket
  times.note(2e-4);
  times.note(5.0);
  Exposition out;
  out.histogram("mlab_cycle_duration_seconds", "How long.", times);
  const Scrape scrape(out.text());
  EXPECT_EQ(scrape.problems(), "");
  EXPECT_EQ(scrape.value("mlab_cycle_duration_seconds_bucket{le=\"3e-05\"}"), 0.0);
  EXPECT_EQ(scrape.value("mlab_cycle_duration_seconds_bucket{le=\"0.0001\"}"), 1.0);
  EXPECT_EQ(scrape.value("mlab_cycle_duration_seconds_bucket{le=\"0.0003\"}"), 2.0);
  EXPECT_EQ(scrape.value("mlab_cycle_duration_seconds_bucket{le=\"1\"}"), 2.0);
  EXPECT_EQ(scrape.value("mlab_cycle_duration_seconds_bucket{le=\"+Inf\"}"), 3.0);
  EXPECT_EQ(scrape.value("mlab_cycle_duration_seconds_count"), 3.0);
  EXPECT_DOUBLE_EQ(scrape.value("mlab_cycle_duration_seconds_sum"), 5.0003);
}

TEST(Exposition, TakesOverWhatAnotherOneTells) {
  Exposition inner;
  inner.gauge("mlab_a", "A.", 1.0);
  Exposition out;
  out.append(inner);
  out.gauge("mlab_b", "B.", 2.0);
  EXPECT_EQ(Scrape(out.text()).problems(), "");
  EXPECT_EQ(Scrape(out.text()).value("mlab_a"), 1.0);
}

TEST(Exposition, TellsOfThisProcessWhatTheSystemKnows) {
  Exposition out;
  tell_process(out);
  const Scrape scrape(out.text());
  EXPECT_EQ(scrape.problems(), "");
  EXPECT_GT(scrape.value("process_cpu_seconds_total"), 0.0);
  EXPECT_GT(scrape.value("process_resident_memory_bytes"), 1e5);
  EXPECT_GE(scrape.value("process_virtual_memory_bytes"), scrape.value("process_resident_memory_bytes"));
  EXPECT_GE(scrape.value("process_open_fds"), 3.0);
  const auto now = static_cast<double>(std::time(nullptr));
  EXPECT_LE(scrape.value("process_start_time_seconds"), now + 1.0);
  EXPECT_GT(scrape.value("process_start_time_seconds"), now - 3600.0);
}

TEST(Scrape, FindsWhatIsWrong) {
  const auto is_wrong = [](const std::string& text) { return !Scrape(text).problems().empty(); };
  const std::string head = "# HELP a_total A.\n# TYPE a_total counter\n";
  EXPECT_FALSE(is_wrong(head + "a_total 1\n"));
  EXPECT_TRUE(is_wrong(head + "a_total 1"));
  EXPECT_TRUE(is_wrong(head + "a_total 1\na_total 2\n"));
  EXPECT_TRUE(is_wrong(head + head + "a_total 1\n"));
  EXPECT_TRUE(is_wrong(head + "b_total 1\n"));
  EXPECT_TRUE(is_wrong(head + "a_total{x=\"\"\"} 1\n"));
  EXPECT_TRUE(is_wrong(head + "a_total one\n"));
  EXPECT_TRUE(is_wrong("# HELP a A.\n# TYPE a counter\na 1\n"));
  EXPECT_TRUE(is_wrong("# TYPE a gauge\na 1\n"));
  EXPECT_TRUE(is_wrong("# HELP h H.\n# TYPE h histogram\nh_bucket{le=\"+Inf\"} 2\nh_sum 1\nh_count 3\n"));
}

}  // namespace
}  // namespace mlab::metrics
