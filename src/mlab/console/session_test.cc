#include "mlab/console/session.h"

#include <gtest/gtest.h>

#include "mlab/console/testing/browser.h"

namespace mlab::console {
namespace {

using testing::Browser;
using testing::TestSession;

TEST(Session, SaysWhoAndWhatThereIsAfterHello) {
  TestSession session("demo_c/demo_c.mdl");
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  EXPECT_EQ(anna.welcome().client(), 1U);
  EXPECT_EQ(anna.plan().steps_size(), 12);
  EXPECT_EQ(anna.roster().robots_size(), 4);
  EXPECT_EQ(anna.roster().units_size(), 3);
  EXPECT_FALSE(anna.scene().measures().empty());
  EXPECT_EQ(anna.clients().operator_(), 1U);
}

TEST(Session, CarriesDemoCOutFromExecuteThroughAllQuestionsToTheEnd) {
  TestSession session("demo_c/demo_c.mdl", 0.0);
  Browser anna(session, "Anna");
  ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
  EXPECT_EQ(anna.control(Control::EXECUTE), "");
  int answered = 0;
  ASSERT_TRUE(anna.wait([&] {
    if (anna.questions().questions_size() > 0) {
      anna.answer(anna.questions().questions(0).id(), true);
      anna.forget_questions();
      ++answered;
    }
    return anna.status().mode() == Status::ENDED;
  }));
  EXPECT_EQ(anna.status().outcome(), Status::DONE);
  EXPECT_EQ(answered, 5);
  EXPECT_EQ(anna.status().steps_size(), 12);
  EXPECT_TRUE(session->has_ended());
  EXPECT_NE(session->report().find("\"outcome\": \"done\""), std::string::npos);
  EXPECT_GT(anna.frame_count(), 0U);
}

}  // namespace
}  // namespace mlab::console
