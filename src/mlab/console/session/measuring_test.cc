#include "mlab/console/session/measuring.h"

#include <string>

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"
#include "mlab/metrics/testing/scrape.h"

namespace mlab::console {
namespace {

using metrics::testing::Scrape;
using testing::Browser;
using testing::TestSession;

std::string scraped(TestSession& session) {
  metrics::Exposition out;
  session->tell_metrics(out);
  return out.text();
}

// Asks again and again, as a monitoring system does, until a series has this value.
bool wait_for_series(TestSession& session, Browser& browser, const std::string& series, double value) {
  return browser.wait([&] { return Scrape(scraped(session)).value(series) == value; });
}

TEST(Measuring, TellsWhereARunStandsOnceItIsOver) {
  TestSession session("patrol/patrol.mdl", 1000.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for_series(session, anna, "mlab_mode{mode=\"ready\"}", 1.0));
  EXPECT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(wait_for_series(session, anna, "mlab_mode{mode=\"ended\"}", 1.0)) << scraped(session);
  const Scrape scrape(scraped(session));
  EXPECT_EQ(scrape.problems(), "");
  EXPECT_EQ(scrape.value("mlab_mode{mode=\"ready\"}"), 0.0);
  EXPECT_GT(scrape.value("mlab_simulated_seconds_total"), 1.0);
  const double cycles = scrape.value("mlab_cycles_total");
  EXPECT_NEAR(scrape.value("mlab_simulated_seconds_total"),
              cycles * scrape.value("mlab_cycle_period_seconds"), 1e-6);
  EXPECT_EQ(scrape.value("mlab_cycle_duration_seconds_count"), cycles);
  EXPECT_EQ(scrape.value("mlab_cycle_processor_seconds_count"), cycles);
  EXPECT_GT(scrape.value("mlab_cycle_processor_seconds_sum"), 0.0);
  EXPECT_GT(scrape.value("mlab_steps"), 0.0);
  EXPECT_EQ(scrape.value("mlab_steps_done"), scrape.value("mlab_steps"));
  EXPECT_EQ(scrape.value("mlab_events_total{kind=\"mission\"}"), 1.0);
  EXPECT_GT(scrape.value("mlab_events_total{kind=\"step\"}"), 0.0);
  EXPECT_EQ(scrape.value("mlab_robots{state=\"not_started\"}"), 0.0);
  EXPECT_EQ(scrape.value("mlab_contacts_total"), 0.0);
  EXPECT_EQ(scrape.value("mlab_robot_contacts_total{robot=\"1\"}"), 0.0);
  EXPECT_EQ(scrape.value("mlab_bodies_moving"), 0.0);
  EXPECT_EQ(scrape.value("mlab_questions_open"), 0.0);
  EXPECT_EQ(scrape.value("mlab_people"), 1.0);
  EXPECT_EQ(scrape.value("mlab_build_info{version=\"test\"}"), 1.0);
  EXPECT_GE(scrape.value("mlab_session_age_seconds"), 0.0);
}

TEST(Measuring, CountsOfARunBeginAnewWithTheNextAndThoseOfTheConsoleGoOn) {
  TestSession session("patrol/patrol.mdl", 1000.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for_series(session, anna, "mlab_mode{mode=\"ready\"}", 1.0));
  EXPECT_EQ(anna.control(Control::EXECUTE), "");
  ASSERT_TRUE(wait_for_series(session, anna, "mlab_mode{mode=\"ended\"}", 1.0));
  const Scrape before(scraped(session));
  EXPECT_EQ(anna.control(Control::RESTART), "");
  ASSERT_TRUE(wait_for_series(session, anna, "mlab_runs_total", before.value("mlab_runs_total") + 1.0));
  const Scrape after(scraped(session));
  EXPECT_EQ(after.problems(), "");
  EXPECT_EQ(after.value("mlab_cycles_total"), 0.0);
  EXPECT_EQ(after.value("mlab_simulated_seconds_total"), 0.0);
  EXPECT_EQ(after.value("mlab_cycle_duration_seconds_count"), before.value("mlab_cycles_total"));
}

TEST(Measuring, AnEmergencyStopIsTheMode) {
  TestSession session("patrol/patrol.mdl");
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for_series(session, anna, "mlab_mode{mode=\"ready\"}", 1.0));
  session->emergency_stop();
  EXPECT_TRUE(wait_for_series(session, anna, "mlab_mode{mode=\"stopped\"}", 1.0));
  EXPECT_EQ(Scrape(scraped(session)).value("mlab_mode{mode=\"ready\"}"), 0.0);
}

TEST(Measuring, WithoutAMissionThereIsNoRunToTellOf) {
  TestSession session("");
  Browser anna(session, "Anna");
  ASSERT_TRUE(wait_for_series(session, anna, "mlab_mode{mode=\"no_mission\"}", 1.0));
  const Scrape scrape(scraped(session));
  EXPECT_EQ(scrape.problems(), "");
  EXPECT_FALSE(scrape.types().contains("mlab_robots"));
  EXPECT_FALSE(scrape.types().contains("mlab_cycles_total"));
  EXPECT_EQ(scrape.value("mlab_cycle_duration_seconds_count"), 0.0);
}

}  // namespace
}  // namespace mlab::console
