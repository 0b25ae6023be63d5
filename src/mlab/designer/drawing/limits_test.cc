// What people and programs do to a designer that nobody thought of while it was drawn.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/designer/testing/browser.h"
#include "mlab/designer/testing/live_desk.h"

namespace mlab::designer {
namespace {

namespace fs = std::filesystem;
using testing::LiveDesk;

constexpr const char* kSmall = "assemblage One() {\n  Noise(persistence = 3 s)\n}\n";

std::string many_nodes(int nodes) {
  std::string out = "assemblage Many() {\n  cooperate {\n";
  for (int i = 0; i < nodes / 6; ++i) {
    const std::string sense = fmt::format("sense_obstacles(range = {} m)", 1 + i % 9);
    out += fmt::format(
        "    1: cooperate {{\n      1: Noise(persistence = {} s);\n      0.5: AvoidStaticObstacles(readings "
        "= {}, "
        "sphere = 1 m, safety_margin = 0.5 m);\n      0.8: Probe(readings = {});\n    }};\n",
        1 + i % 20, sense, sense);
  }
  return out + "  }\n}\n";
}

/// A desk with a page of so many nodes.
struct LargePage {
  explicit LargePage(std::size_t nodes) : path(desk.write(many_nodes(static_cast<int>(nodes)))) {}

  void rename_one() {
    const Drawing drawing = desk.drawing(path, "Many");
    const Answer answer = desk.ask([&](ToDesigner& m) {
      m.mutable_edit()->set_document(path);
      m.mutable_edit()->set_revision(desk.document(path).revision());
      Rename& rename = *m.mutable_edit()->add_changes()->mutable_rename();
      rename.set_page("Many");
      rename.set_node(drawing.nodes(drawing.nodes_size() / 2).name());
      rename.set_name(fmt::format("middle{}", ++names));
    });
    EXPECT_TRUE(answer.ok()) << answer.error();
  }
  // Without waiting for an answer, as fast keys come.
  void type_letters(std::size_t count) {
    const std::string before = desk.document(path).text();
    const std::uint64_t revision = desk.document(path).revision();
    for (std::size_t i = 0; i < count; ++i) {
      desk.tell([&](ToDesigner& m) {
        EditText& edit = *m.mutable_edit_text();
        edit.set_document(path);
        edit.set_revision(revision + i);
        edit.set_begin(static_cast<std::uint32_t>(before.size() + i));
        edit.set_end(edit.begin());
        edit.set_text(i % 60 == 0 ? "\n" : "/");
      });
    }
    desk.drawing(path, "Many");
    EXPECT_EQ(desk.document(path).text().size(), before.size() + count);
  }

  LiveDesk desk;
  std::string path;
  int names = 0;
};

TEST(Limits, APageOfTwoThousandNodesIsEditedAndRun) {
  constexpr std::size_t kFew = 250;
  LargePage few(kFew);
  LargePage many(8 * kFew);
  EXPECT_GE(many.desk.drawing(many.path, "Many").nodes_size(), 1990);
  const auto rename = [&](std::size_t nodes) { (nodes == kFew ? few : many).rename_one(); };
  EXPECT_LT(base::growth(rename, kFew), base::kGrowthOfLine);
  EXPECT_TRUE(many.desk.try_out(many.path, "Many").ok());
}

TEST(Limits, FiveMegabytesOfTextAreTypedInAndUndone) {
  LiveDesk desk;
  const std::string path = desk.write(kSmall);
  int times = 0;
  const auto type = [&](std::size_t size) {
    std::string text = kSmall + fmt::format("// for the {}. time\n", ++times);
    while (text.size() < size) text += "// a line that says nothing, but is there all the same\n";
    desk.type(path, text);
  };
  EXPECT_LT(base::growth(type, 625'000), base::kGrowthOfLine);
  EXPECT_EQ(desk.drawing(path, "One").nodes_size(), 1);
  EXPECT_TRUE(desk.ask([&](ToDesigner& m) { m.mutable_undo()->set_document(path); }).ok());
}

TEST(Limits, LettersThatNobodyWaitsForAreAllThere) {
  LargePage page(300);
  EXPECT_LT(base::growth([&](std::size_t letters) { page.type_letters(letters); }, 125), base::kGrowthOfLine);
}

TEST(Limits, TwoWhoTypeInTurnsLoseNothing) {
  LiveDesk desk;
  const std::string path = desk.write(kSmall);
  std::string wanted = kSmall;
  int refused = 0;
  for (int i = 0; i < 50; ++i) {
    const Document now = desk.document(path);
    // One types at the end, the other at the beginning, with what was there before the first one's letter.
    for (const bool is_first : {true, false}) {
      const Answer answer = desk.ask([&](ToDesigner& m) {
        EditText& edit = *m.mutable_edit_text();
        edit.set_document(path);
        edit.set_revision(now.revision());
        edit.set_begin(is_first ? static_cast<std::uint32_t>(now.text().size()) : 0);
        edit.set_end(edit.begin());
        edit.set_text(is_first ? "// a\n" : "// b\n");
      });
      if (is_first) {
        EXPECT_TRUE(answer.ok()) << answer.error();
        wanted += "// a\n";
      } else {
        refused += answer.ok() ? 0 : 1;
      }
    }
  }
  EXPECT_EQ(refused, 50) << "what was typed into an older text is tried again by who typed it";
  EXPECT_EQ(desk.document(path).text(), wanted);
}

class FilesThatAreNot : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) {
    fs::create_directories(desk_.folder().path("project"));
    std::ofstream(desk_.folder().path("project") / name, std::ios::binary) << bytes;
  }
  Answer open(const std::string& path) {
    return desk_.ask([&](ToDesigner& m) { m.mutable_open()->set_path(path); });
  }
  Answer save(const std::string& path) {
    return desk_.ask([&](ToDesigner& m) { m.mutable_save()->set_document(path); });
  }
  LiveDesk desk_;
};

TEST_F(FilesThatAreNot, AFolderIsRefusedInAWord) {
  fs::create_directories(desk_.folder().path("project") / "one.cdl");
  const Answer answer = open("one.cdl");
  EXPECT_FALSE(answer.ok());
  EXPECT_NE(answer.error(), "");
}

TEST_F(FilesThatAreNot, BytesThatAreNoTextAreShownAndDrawnAsFarAsTheyGo) {
  write("one.cdl", std::string("assemblage One() {\n  Noise()\n}\n// \xff\xfe\x80 \0 end\n", 44));
  const Answer answer = open("one.cdl");
  ASSERT_TRUE(answer.ok()) << answer.error();
  const Document document = desk_.document("one.cdl");
  EXPECT_NE(document.text().find("Noise()"), std::string::npos);
  EXPECT_EQ(desk_.drawing("one.cdl", "One").nodes_size(), 1);
  write("two.cdl", std::string(100'000, '\xff'));
  open("two.cdl");
  EXPECT_TRUE(open("one.cdl").ok()) << "it still answers";
}

TEST_F(FilesThatAreNot, AFileDeletedWhileItIsOpenIsWrittenAnewBySaving) {
  write("one.cdl", kSmall);
  ASSERT_TRUE(open("one.cdl").ok());
  const std::string more = std::string(kSmall) + "// more\n";
  desk_.type("one.cdl", more);
  fs::remove(desk_.folder().path("project") / "one.cdl");
  const Answer answer = save("one.cdl");
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(desk_.folder().read("project/one.cdl"), more);
}

TEST(FileThatIsGone, IsWrittenAnewBySavingOnceThatIsKnown) {
  testing::Browser browser;
  browser.write("one.cdl", kSmall);
  browser.open("one.cdl");
  const std::string more = std::string(kSmall) + "// more\n";
  browser.type("one.cdl", more);
  fs::remove(browser.project_folder() + "/one.cdl");
  ASSERT_TRUE(
      browser.waits_for([&] { return std::ranges::any_of(browser.seen_changes(1), &FileChanged::is_gone); }));
  const Answer answer = browser.ask([](ToDesigner& m) { m.mutable_save()->set_document("one.cdl"); });
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(browser.read("one.cdl"), more);
}

TEST_F(FilesThatAreNot, AFolderInPlaceOfAnOpenFileIsNotWrittenInto) {
  write("one.cdl", kSmall);
  ASSERT_TRUE(open("one.cdl").ok());
  desk_.type("one.cdl", std::string(kSmall) + "// more\n");
  const fs::path file = desk_.folder().path("project") / "one.cdl";
  fs::remove(file);
  fs::create_directories(file / "inside");
  const Answer answer = desk_.ask([](ToDesigner& m) {
    m.mutable_save()->set_document("one.cdl");
    m.mutable_save()->set_overwrite(true);
  });
  EXPECT_FALSE(answer.ok());
  EXPECT_NE(answer.error(), "");
  EXPECT_TRUE(fs::is_directory(file / "inside"));
  EXPECT_EQ(desk_.document("one.cdl").text(), std::string(kSmall) + "// more\n");
}

TEST_F(FilesThatAreNot, WhatIsReadOnlyInTheProjectIsSaidWhenItIsSaved) {
  write("one.cdl", kSmall);
  const fs::path folder = desk_.folder().path("project");
  ASSERT_TRUE(open("one.cdl").ok());
  desk_.type("one.cdl", std::string(kSmall) + "// more\n");
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  std::ofstream probe(folder / "probe");
  const bool is_superuser = probe.is_open();  // who may write everywhere
  probe.close();
  const Answer answer = save("one.cdl");
  fs::permissions(folder, fs::perms::owner_all);
  EXPECT_EQ(answer.ok(), is_superuser) << answer.error();
  if (!is_superuser) {
    EXPECT_NE(answer.error().find("cannot write"), std::string::npos) << answer.error();
  }
}

TEST(Limits, AFieldOfTheFinestGridLetsTheRunGoOn) {
  LiveDesk desk;
  const std::string path = desk.open("examples:forage/forager.cdl");
  ASSERT_TRUE(desk.try_out(path, "Forager", 20).ok());
  ASSERT_TRUE(desk.runs_until(1.0));
  const Answer answer = desk.ask([&](ToDesigner& m) {
    ReadField& request = *m.mutable_read_field();
    request.set_document(path);
    request.set_page("Forage");
    request.set_robot(1);
    request.mutable_area()->set_x_max(40.0);
    request.mutable_area()->set_y_max(30.0);
    request.set_columns(100);
    request.set_rows(100);
  });
  EXPECT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(answer.field().arrows().size() / sizeof(LiveDesk::Arrow), 10'000U);
  EXPECT_TRUE(desk.runs_until(1.5));
}

}  // namespace
}  // namespace mlab::designer
