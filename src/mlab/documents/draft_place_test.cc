#include "mlab/documents/draft_place.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/documents/drafts.h"
#include "mlab/documents/testing/scratch_project.h"

namespace mlab::documents {
namespace {

const std::vector<std::string> kKinds = {"", "designer"};
constexpr const char* kProject = "/some/project";

using Texts = std::vector<std::string>;

struct Server {
  explicit Server(const std::string& state) : place(state, kProject, kKinds) {}
  Drafts drafts(const std::string& kind = "") const {
    return {kind.empty() ? place.state_folder() : place.state_folder() + '/' + kind, kProject};
  }
  std::string text(std::string_view path) const {
    const auto draft = drafts().find(path);
    return draft ? draft->text : "(none)";
  }
  DraftPlace place;
};

class ServersOfOneProject : public ::testing::Test {
 protected:
  std::unique_ptr<Server> start() const { return std::make_unique<Server>(scratch.path("state").string()); }

  testing::ScratchProject scratch;
};

TEST_F(ServersOfOneProject, HaveTheSameDraftsOneAfterTheOther) {
  auto first = start();
  EXPECT_FALSE(first->place.is_beside());
  EXPECT_EQ(first->drafts().keep("a.mdl", "typed", nullptr), "");
  first.reset();
  EXPECT_EQ(start()->text("a.mdl"), "typed");
}

TEST_F(ServersOfOneProject, HaveDraftsOfTheirOwnWhileTheyRunAtOnce) {
  const auto first = start();
  const auto second = start();
  const auto third = start();
  EXPECT_TRUE(second->place.is_beside());
  EXPECT_TRUE(third->place.is_beside());
  EXPECT_EQ(first->drafts().keep("a.mdl", "by the first", nullptr), "");
  EXPECT_EQ(second->drafts().keep("a.mdl", "by the second", nullptr), "");
  EXPECT_EQ(third->drafts().keep("a.mdl", "by the third", nullptr), "");
  EXPECT_EQ(first->text("a.mdl"), "by the first");
  EXPECT_EQ(second->text("a.mdl"), "by the second");
  EXPECT_EQ(second->drafts().drop("a.mdl"), "");
  EXPECT_EQ(first->text("a.mdl"), "by the first");
}

TEST_F(ServersOfOneProject, OfOtherProjectsDoNotCount) {
  const auto first = start();
  EXPECT_FALSE(DraftPlace(scratch.path("state").string(), "/another", kKinds).is_beside());
}

TEST_F(ServersOfOneProject, FindWhatWasLeftBesideByOneThatHasEnded) {
  {
    const auto first = start();
    const auto second = start();
    EXPECT_EQ(second->drafts().keep("a.mdl", "by the second", nullptr), "");
    EXPECT_EQ(second->drafts("designer").keep("a.cdl", "drawn", nullptr), "");
  }
  const auto next = start();
  EXPECT_FALSE(next->place.is_beside());
  EXPECT_EQ(next->text("a.mdl"), "by the second");
  EXPECT_EQ(next->drafts("designer").find("a.cdl").value_or(Drafts::Draft{}).text, "drawn");
  EXPECT_EQ(next->place.left_beside(), Texts{});
}

TEST_F(ServersOfOneProject, LeaveAloneWhatAnotherOneWorksWith) {
  auto first = start();
  const auto second = start();
  EXPECT_EQ(second->drafts().keep("a.mdl", "by the second", nullptr), "");
  first.reset();
  const auto next = start();
  EXPECT_FALSE(next->place.is_beside());
  EXPECT_EQ(next->text("a.mdl"), "(none)");
  EXPECT_EQ(second->text("a.mdl"), "by the second");
}

TEST_F(ServersOfOneProject, LoseNeitherOfTwoDraftsOfOneText) {
  {
    const auto first = start();
    const auto second = start();
    EXPECT_EQ(first->drafts().keep("a.mdl", "by the first", nullptr), "");
    EXPECT_EQ(second->drafts().keep("a.mdl", "by the second", nullptr), "");
  }
  const auto next = start();
  EXPECT_EQ(next->text("a.mdl"), "by the first");
  EXPECT_EQ(next->place.left_beside(), Texts{"a.mdl"});
  EXPECT_EQ(start()->text("a.mdl"), "by the second") << "the next one beside has it again";
}

TEST(DraftPlace, IsNowhereWhereNothingIsKept) {
  const DraftPlace place("", kProject, kKinds);
  EXPECT_EQ(place.state_folder(), "");
  EXPECT_FALSE(place.is_beside());
  const DraftPlace unwritable("/proc/no_such_folder", kProject, kKinds);
  EXPECT_FALSE(unwritable.is_beside());
  EXPECT_EQ(unwritable.state_folder(), "/proc/no_such_folder");
}

}  // namespace
}  // namespace mlab::documents
