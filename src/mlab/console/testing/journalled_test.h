#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/console/session.h"
#include "mlab/console/testing/browser.h"
#include "mlab/documents/testing/scratch_project.h"
#include "mlab/journal/journal_folder.h"

namespace mlab::console::testing {

/// Sessions that record and keep a journal, of a mission whose two robots drive for long.
class JournalledTest : public ::testing::Test {
 protected:
  void SetUp() override {
    project_.write("project/far.mdl",
                   "OVERLAY \"map.odl\"\nUNIT <pair> ROBOT ROBOT\nCOMMAND LIST:\n"
                   "0. UNIT pair START 100 100 0 40\n1. UNIT pair MOVETO PP-Far\n");
    project_.write("project/map.odl", "MISSION-AREA 2000 1000\nCONTROL MEASURES:\nPP Far 1900 100\n");
  }
  /// What all of them have.
  void change(SessionSettings& settings) const {
    settings.project_folder = project_.path("project").string();
    settings.record = {true, project_.path("runs").string(), ""};
    settings.journal_folder = folder_.folder();
  }
  void begin(SessionSettings& settings) const {
    change(settings);
    settings.mission = project_.path("project/far.mdl").string();
  }
  /// The newest run that did not end is gone on with.
  void resume(SessionSettings& settings) const {
    change(settings);
    const std::vector<journal::Unfinished> runs = folder_.look().runs;
    ASSERT_FALSE(runs.empty());
    settings.resume = runs.front().path;
  }
  static void start(Browser& anna) {
    ASSERT_TRUE(anna.wait([&] { return anna.status().mode() == Status::READY; }));
    ASSERT_EQ(anna.control(Control::EXECUTE), "");
    ASSERT_TRUE(anna.wait([&] { return anna.status().time() > 3.0; }));
  }

  const documents::testing::ScratchProject project_;
  const journal::JournalFolder folder_{project_.path("journals").string()};
};

}  // namespace mlab::console::testing
