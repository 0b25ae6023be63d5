// Sentences of the grammar G and the component library: what is read is a configuration that runs, and what
// is written of a configuration can be read.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/hash.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/testing/any_sentence.h"
#include "mlab/robot/program/brought_code.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::robot {
namespace {

namespace fs = std::filesystem;

text::SourcePtr text_of(const std::string& name, const std::string& text) {
  return std::make_shared<const text::Source>(name, text);
}

// The sentences of a configuration, one a line; what is wrong with it instead.
std::string sentences_of(const text::SourcePtr& source, cdl::Configuration* read = nullptr) {
  text::Diagnostics sink;
  check_configuration(source, {}, sink);
  if (sink.has_errors()) return text::render(sink);
  cdl::Configuration configuration = cdl::load(source, library_environment(), sink);
  const auto library = describe_library(configuration.procedures);
  std::string out;
  for (const std::string& one : cdl::formula(configuration, library->library, sink).sentences)
    out += one + "\n";
  if (sink.has_errors()) return text::render(sink);
  if (read != nullptr) *read = std::move(configuration);
  return out;
}

// Every robot of it gets a program that steps.
void expect_to_run(const text::SourcePtr& source, const cdl::Configuration& configuration) {
  for (const auto& [name, robot] : configuration.robots) {
    if (robot->name.place.source != source) continue;  // the library's own
    text::Diagnostics sink;
    const auto made = configure(source, name, "", {}, {}, sink);
    ASSERT_TRUE(made) << text::render(sink) << source->text();
    flow::Frame frame = made->built.program->make_frame();
    percept::Action action;
    made->built.program->step(frame.data(), {}, action, 1, 1);
    EXPECT_EQ(made->built.program->find_fault(frame.data()), nullptr) << source->text();
  }
}

TEST(FormulaWithTheLibrary, ReadsAndWritesAThousandSentences) {
  constexpr int kSentences = base::kIsSlowBuild ? 100 : 1000;
  const char* given = std::getenv("MLAB_SEED");
  const std::uint64_t seed = given == nullptr ? std::random_device{}() : std::strtoull(given, nullptr, 10);
  std::printf("seed %llu (MLAB_SEED=%llu repeats it)\n", static_cast<unsigned long long>(seed),
              static_cast<unsigned long long>(seed));
  std::uint64_t state = base::mix_bits(seed);
  const auto pick = [&](int low, int end) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + static_cast<int>((state >> 33U) % static_cast<std::uint64_t>(end - low));
  };
  for (int i = 0; i < kSentences; ++i) {
    const std::string sentence = print(cdl::testing::AnySentence(pick).society(2)) + "\n";
    const text::SourcePtr source = text_of("any.formula", sentence);
    cdl::Configuration read;
    ASSERT_EQ(sentences_of(source, &read), sentence) << i;
    ASSERT_FALSE(read.trees.empty());
    // And so does the configuration that it is, as text.
    if (i % 4 == 0) {
      ASSERT_EQ(sentences_of(text_of("any.cdl", cdl::print(*read.trees.back()))), sentence) << i;
    }
    if (i % 20 == 0) expect_to_run(source, read);
  }
}

TEST(FormulaWithTheLibrary, GivesANumberThatTwoAskForToTheFirst) {
  const std::string robot = "movement = cooperate { Noise(); Stand(); } as cooperation3;";
  const std::string written = sentences_of(
      text_of("a.cdl", "robot A is Rover { " + robot + " }\nrobot B is Rover { " + robot + " }\n"));
  EXPECT_NE(written.find("[+3 "), std::string::npos) << written;
  EXPECT_EQ(written.find("[+3 "), written.rfind("[+3 ")) << written;
  EXPECT_NE(written.find("[+1 "), std::string::npos) << written;
}

TEST(FormulaWithTheLibrary, ReadsWhatItWritesOfTheConfigurationsThatComeWithIt) {
  std::size_t read = 0;
  for (const char* folder : {"missions", "library/robots", "src/mlab/lang/cdl/testdata/examples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(base::source_folder()) / folder)) {
      if (entry.path().extension() != ".cdl") continue;
      std::ifstream file(entry.path());
      std::stringstream text;
      text << file.rdbuf();
      const std::string written = sentences_of(text_of(entry.path().string(), text.str()));
      if (!written.starts_with("{") && !written.starts_with("'")) continue;  // no robot, or files beside it
      EXPECT_EQ(sentences_of(text_of("again.formula", written)), written) << entry.path();
      ++read;
    }
  }
  EXPECT_GT(read, 5U);
}

}  // namespace
}  // namespace mlab::robot
