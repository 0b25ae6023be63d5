#include "mlab/documents/project_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>
#include <tuple>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/documents/testing/scratch_project.h"

namespace mlab::documents {
namespace {

namespace fs = std::filesystem;

class ProjectFolderTest : public ::testing::Test {
 protected:
  ProjectFolderTest() : folder({scratch.path("project").string(), scratch.path("examples").string()}) {
    scratch.write("project/a.mdl", "a");
    scratch.write("project/sub/b.odl", "b");
    scratch.write("project/sub/p.png", "p");
    scratch.write("project/.hidden", "h");
    scratch.write("examples/demo/demo.mdl", "demo");
    scratch.write("elsewhere/secret.mdl", "secret");
  }

  testing::ScratchProject scratch;
  ProjectFolder folder;
};

TEST_F(ProjectFolderTest, WritesNothingThatCodeOfTheProjectMayInclude) {
  for (const char* file : {"a.mdl", "sub/b.odl", "c.ovl", "d.MDL"}) {
    EXPECT_TRUE(folder.is_writable(file)) << file;
  }
  for (const char* file : {"a.cnl", "a.h", "sub/a.hpp", "a.inc", "a.cc", "a"}) {
    EXPECT_FALSE(folder.is_writable(file)) << file;
    EXPECT_FALSE(folder.write(file, "x")) << file;
  }
}

TEST_F(ProjectFolderTest, ListsReadsAndWritesWhatIsInside) {
  const auto entries = folder.list("");
  ASSERT_TRUE(entries);
  ASSERT_EQ(entries->size(), 2U);
  EXPECT_EQ((*entries)[0].path, "sub");
  EXPECT_TRUE((*entries)[0].is_folder);
  EXPECT_EQ((*entries)[1].path, "a.mdl");
  EXPECT_EQ((*entries)[1].kind, "mission");
  EXPECT_EQ((*folder.list("sub"))[0].kind, "overlay");
  EXPECT_EQ((*folder.list("sub"))[1].kind, "picture");
  EXPECT_EQ(folder.read("sub/b.odl"), "b");
  EXPECT_TRUE(folder.write("new/deep/c.odl", "text"));
  EXPECT_EQ(scratch.read("project/new/deep/c.odl"), "text");
  EXPECT_TRUE(folder.write("a.mdl", "other"));
  EXPECT_EQ(scratch.read("project/a.mdl"), "other");
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path("project")), {}), 4)
      << "nothing is left beside it";
  EXPECT_EQ(folder.files("", ".mdl"), std::vector<std::string>{"a.mdl"});
  EXPECT_EQ(folder.name(), "project");
}

TEST_F(ProjectFolderTest, ReadsExamplesAndNeverWritesThem) {
  EXPECT_EQ(folder.files("examples:", ".mdl"), std::vector<std::string>{"examples:demo/demo.mdl"});
  EXPECT_EQ(folder.read("examples:demo/demo.mdl"), "demo");
  EXPECT_FALSE(folder.is_writable("examples:demo/demo.mdl"));
  EXPECT_FALSE(folder.write("examples:demo/demo.mdl", "mine"));
  EXPECT_FALSE(folder.write("examples:demo/new.mdl", "mine"));
  EXPECT_EQ(scratch.read("examples/demo/demo.mdl"), "demo");
}

TEST_F(ProjectFolderTest, RefusesNamesThatLeadOut) {
  const std::string secret = scratch.path("elsewhere/secret.mdl").string();
  for (const std::string& name :
       {std::string("../elsewhere/secret.mdl"), std::string("sub/../../elsewhere/secret.mdl"), secret,
        "/" + secret, std::string("./a.mdl"), std::string("sub//b.odl"), std::string("sub/"), std::string(""),
        std::string(".."), std::string("."), std::string(".hidden"), std::string("examples:../project/a.mdl"),
        std::string("examples:/etc/passwd"), "outside:" + secret, std::string("a.mdl\0.odl", 10),
        std::string(2000, 'a') + ".mdl"}) {
    EXPECT_FALSE(folder.read(name)) << name;
    EXPECT_FALSE(folder.is_file(name)) << name;
    EXPECT_FALSE(folder.write(name, "x")) << name;
  }
  EXPECT_FALSE(folder.list("..").has_value());
  EXPECT_FALSE(folder.list("/").has_value());
  EXPECT_FALSE(folder.list("sub/..").has_value());
  EXPECT_EQ(folder.name_of(secret), std::nullopt);
  EXPECT_EQ(folder.name_of(scratch.path("project/../elsewhere/secret.mdl").string()), std::nullopt);
  EXPECT_EQ(folder.name_of(scratch.path("projectile/x.mdl").string()), std::nullopt);
  EXPECT_EQ(folder.name_of(scratch.path("project/sub/../a.mdl").string()), "a.mdl");
}

RC_GTEST_FIXTURE_PROP(ProjectFolderTest, NeverReadsTheSecretWhateverTheName, ()) {
  const auto parts = *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(
      std::vector<std::string>{"..", ".", "sub", "elsewhere", "secret.mdl", "", "link",
                               "examples:", "project", "outside:", scratch.path("").string(), "a.mdl"}));
  std::error_code there;
  fs::create_directory_symlink(scratch.path("elsewhere"), scratch.path("project/link"), there);
  std::string name;
  for (const std::string& part : parts) name += (name.empty() || name.ends_with(':') ? "" : "/") + part;
  const auto read = folder.read(name);
  RC_ASSERT(read.value_or("") != "secret");
  std::ignore = folder.write(name, "changed");
  RC_ASSERT(scratch.read("elsewhere/secret.mdl") == "secret");
}

TEST_F(ProjectFolderTest, FollowsNoSymbolicLink) {
  fs::create_symlink(scratch.path("elsewhere/secret.mdl"), scratch.path("project/file_link.mdl"));
  fs::create_directory_symlink(scratch.path("elsewhere"), scratch.path("project/folder_link"));
  fs::create_symlink(scratch.path("elsewhere/new.mdl"), scratch.path("project/dangling.mdl"));
  for (const char* name : {"file_link.mdl", "folder_link/secret.mdl", "dangling.mdl"}) {
    EXPECT_FALSE(folder.read(name)) << name;
    EXPECT_FALSE(folder.is_file(name)) << name;
    EXPECT_FALSE(folder.write(name, "x")) << name;
  }
  EXPECT_FALSE(folder.write("folder_link/new.mdl", "x"));
  EXPECT_FALSE(folder.list("folder_link").has_value());
  const auto entries = folder.list("");
  for (const ProjectFolder::Entry& entry : *entries) EXPECT_FALSE(entry.path.contains("link")) << entry.path;
  EXPECT_EQ(scratch.read("elsewhere/secret.mdl"), "secret");
  EXPECT_FALSE(fs::exists(scratch.path("elsewhere/new.mdl")));
}

TEST_F(ProjectFolderTest, IsNotFooledByAFolderThatBecomesALinkMeanwhile) {
  std::atomic<bool> is_over = false;
  const fs::path sub = scratch.path("project/race");
  const fs::path aside = scratch.path("project/aside");
  fs::create_directory(sub);
  scratch.write("project/race/secret.mdl", "mine");
  std::thread attacker([&] {
    std::error_code any;
    while (!is_over) {
      fs::rename(sub, aside, any);
      fs::create_directory_symlink(scratch.path("elsewhere"), sub, any);
      fs::remove(sub, any);
      fs::rename(aside, sub, any);
    }
  });
  for (int i = 0; i < 3000; ++i) {
    const auto read = folder.read("race/secret.mdl");
    ASSERT_TRUE(!read || *read == "mine");
    if (i % 10 == 0) std::ignore = folder.write("race/secret.mdl", "mine");
  }
  is_over = true;
  attacker.join();
  EXPECT_EQ(scratch.read("elsewhere/secret.mdl"), "secret");
}

TEST_F(ProjectFolderTest, ReadsAndWritesOnlyRegularFiles) {
  ASSERT_EQ(::mkfifo(scratch.path("project/pipe.mdl").c_str(), 0600), 0);
  fs::create_directory(scratch.path("project/folder.mdl"));
  EXPECT_FALSE(folder.read("pipe.mdl")) << "and it doesn't wait for a writer";
  EXPECT_FALSE(folder.write("pipe.mdl", "x"));
  EXPECT_FALSE(folder.read("folder.mdl"));
  EXPECT_FALSE(folder.write("folder.mdl", "x"));
}

TEST_F(ProjectFolderTest, WritesNothingButMissionsAndOverlays) {
  for (const char* name : {"run.sh", "Makefile", "robot.cnl", "a.mdl.so", "sub/x", ".git/hooks.mdl"})
    EXPECT_FALSE(folder.write(name, "x")) << name;
  EXPECT_TRUE(folder.write("old.OVL", "x"));
}

TEST_F(ProjectFolderTest, KeepsTheModeOfAFileAndRefusesAProtectedOne) {
  fs::permissions(scratch.path("project/a.mdl"), fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(folder.write("a.mdl", "new"));
  EXPECT_EQ(fs::status(scratch.path("project/a.mdl")).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  // More than the process would give a new one.
  const fs::perms shared = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read |
                           fs::perms::group_write | fs::perms::others_write;
  fs::permissions(scratch.path("project/a.mdl"), shared);
  ASSERT_TRUE(folder.write("a.mdl", "newer"));
  EXPECT_EQ(fs::status(scratch.path("project/a.mdl")).permissions(), shared);
  if (::geteuid() == 0) return;  // nothing is protected from root
  fs::permissions(scratch.path("project/a.mdl"), fs::perms::owner_read);
  EXPECT_FALSE(folder.write("a.mdl", "newer"));
}

TEST_F(ProjectFolderTest, ReadsOutsideOnlyWhatWasAllowed) {
  scratch.write("elsewhere/other.odl", "other");
  const std::string allowed = scratch.path("elsewhere/other.odl").string();
  folder.allow_outside(allowed);
  const auto name = folder.name_of(allowed);
  ASSERT_TRUE(name);
  EXPECT_EQ(folder.read(*name), "other");
  EXPECT_TRUE(folder.is_file(*name));
  EXPECT_FALSE(folder.is_writable(*name));
  EXPECT_FALSE(folder.write(*name, "x"));
  EXPECT_FALSE(folder.read("outside:" + scratch.path("elsewhere/secret.mdl").string()));
  EXPECT_FALSE(folder.read(*name + "/../secret.mdl"));
}

TEST_F(ProjectFolderTest, WithoutAFolderWritesNothing) {
  const ProjectFolder none({"", ""});
  EXPECT_FALSE(none.write("a.mdl", "x"));
  EXPECT_FALSE(none.read("a.mdl"));
  EXPECT_FALSE(none.list("").has_value());
  EXPECT_TRUE(none.files("", ".mdl").empty());
}

}  // namespace
}  // namespace mlab::documents
