#include "mlab/robot/runner/host.h"

#include <gtest/gtest.h>

#include "mlab/robot/wire/shared_cycle.h"

namespace mlab::robot_runner {
namespace {

TEST(Host, RefusesProceduresThatWereMadeWithOtherHeaders) {
  Host host({}, "1");
  wire::ToRobot message;
  message.mutable_load()->set_layout(robot_wire::shared_layout() + 1);
  EXPECT_EQ(host.answer(message.SerializeAsString()).problem().text(),
            "this program was made with headers of another version than the run");
  EXPECT_EQ(host.program(), nullptr);
}

}  // namespace
}  // namespace mlab::robot_runner
