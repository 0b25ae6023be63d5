#include "mlab/vehicle/lines.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::vehicle {
namespace {

std::string numbered_line(int number) {
  return "P " + std::to_string(number) + " 3.125 -0.25 " + std::to_string(number % 7) + " 0.1 0";
}

TEST(Lines, AreReadAsTheyAreWritten) {
  EXPECT_EQ(line_of("S"), "S*8B66\n");
  LineReader reader;
  reader.add(line_of("V 1200 0.2 -0.1") + line_of("S"));
  EXPECT_EQ(reader.next(), "V 1200 0.2 -0.1");
  EXPECT_EQ(reader.next(), "S");
  EXPECT_EQ(reader.next(), std::nullopt);
}

TEST(Lines, MayComeInPiecesAndWithCarriageReturns) {
  LineReader reader;
  const std::string line = "B 10 87*" + line_of("B 10 87").substr(8, 4) + "\r\n";
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    reader.add(line.substr(i, 1));
    EXPECT_EQ(reader.next(), std::nullopt);
  }
  reader.add("\n");
  EXPECT_EQ(reader.next(), "B 10 87");
}

TEST(Lines, ThatAreDamagedAreLeftOut) {
  const std::string whole = line_of("P 1200 3.5 -0.25 1.57 0 0");
  for (std::size_t i = 0; i + 1 < whole.size(); ++i) {
    LineReader reader;
    std::string damaged = whole;
    damaged.erase(i, 1);
    reader.add(damaged + line_of("S"));
    EXPECT_EQ(reader.next(), "S") << damaged;
    reader.begin_anew();
    damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    if (damaged[i] == '\n') continue;
    reader.add(damaged + line_of("S"));
    EXPECT_EQ(reader.next(), "S") << damaged;
  }
}

TEST(Lines, ThatAreTooLongAreLeftOutAndTakeNoMemory) {
  LineReader reader;
  for (int i = 0; i < 100; ++i) {
    reader.add(std::string(1000, 'x'));
    EXPECT_EQ(reader.next(), std::nullopt);
  }
  reader.add("\n" + line_of("S"));
  EXPECT_EQ(reader.next(), "S");
  reader.add(line_of(std::string(LineReader::kLongest, 'x')) + line_of("S"));
  EXPECT_EQ(reader.next(), "S");
}

TEST(Lines, ThatLackPiecesAreNeverTakenForOthers) {
  const std::uint64_t seed = 5;
  base::Random random(seed);
  std::string all;
  for (int i = 0; i < 4000; ++i) {
    const std::string line = line_of(numbered_line(i));
    const std::size_t lost = random.uniform() < 0.3 ? random.below(line.size()) : line.size();
    all += line.substr(0, lost) + line.substr(std::min(line.size(), lost + 1 + random.below(8)));
  }
  LineReader reader;
  reader.add(all);
  int read = 0;
  int last = -1;
  while (const auto text = reader.next()) {
    const auto words = words_of(*text);
    ASSERT_TRUE(words.has_value()) << *text << ", seed " << seed;
    const int number = static_cast<int>(words->numbers.at(0));
    EXPECT_EQ(*text, numbered_line(number)) << "seed " << seed;
    EXPECT_GT(number, last);
    last = number;
    ++read;
  }
  EXPECT_GT(read, 2000);
}

TEST(Words, AreOneLetterAndNumbers) {
  const auto words = words_of("P 1200 3.5 -0.25 -");
  ASSERT_TRUE(words.has_value());
  EXPECT_EQ(words->word, 'P');
  ASSERT_EQ(words->numbers.size(), 4U);
  EXPECT_EQ(words->numbers[0], 1200.0);
  EXPECT_EQ(words->numbers[1], 3.5);
  EXPECT_EQ(words->numbers[2], -0.25);
  EXPECT_TRUE(std::isinf(words->numbers[3]));
  EXPECT_TRUE(words_of("S").has_value());
  EXPECT_TRUE(words_of("S")->numbers.empty());
}

TEST(Words, AreNothingWhereSomethingIsNoNumber) {
  for (const char* text :
       {"", "PX", "P  1", "P 1 ", "P nan", "P inf", "P 1e999", "P 1x", "P --", "P 0x10", "1 2", "-", " 1 2"})
    EXPECT_FALSE(words_of(text).has_value()) << text;
}

}  // namespace
}  // namespace mlab::vehicle
