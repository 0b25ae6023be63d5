#include "mlab/model_vehicles/pseudo_terminal.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace mlab::model_vehicles {
namespace {

std::string own_link() {
  return (std::filesystem::temp_directory_path() / ("mlab_line_" + std::to_string(::getpid()))).string();
}

TEST(PseudoTerminal, CarriesBytesAsTheyAre) {
  const auto line = PseudoTerminal::open("");
  ASSERT_TRUE(line.has_value()) << line.error();
  const int other = ::open((*line)->path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(other, 0);
  const std::string bytes("\x03\x00\r\n\xFF\x11", 6);  // a terminal would take all of them for something else
  (*line)->write(bytes);
  std::array<char, 16> got{};
  ASSERT_EQ(::read(other, got.data(), got.size()), 6);
  EXPECT_EQ(std::string(got.data(), 6), bytes);
  ASSERT_EQ(::write(other, bytes.data(), bytes.size()), 6);
  std::string back;
  for (int i = 0; i < 1000 && back.size() < 6; ++i, ::usleep(100)) back += (*line)->read();
  EXPECT_EQ(back, bytes);
  ::close(other);
}

TEST(PseudoTerminal, KeepsNothingForWhoIsNotThere) {
  const auto line = PseudoTerminal::open("");
  ASSERT_TRUE(line.has_value()) << line.error();
  for (int i = 0; i < 1000; ++i) (*line)->write(std::string(100, 'x'));
  EXPECT_EQ((*line)->read(), "");
}

TEST(PseudoTerminal, HasItsLinkForAsLongAsItIsThere) {
  const std::string link = own_link();
  std::filesystem::create_symlink("/dev/pts/999999", link);  // of somebody who was killed
  {
    const auto line = PseudoTerminal::open(link);
    ASSERT_TRUE(line.has_value()) << line.error();
    EXPECT_EQ(std::filesystem::read_symlink(link), (*line)->path());
  }
  EXPECT_FALSE(std::filesystem::is_symlink(link));
}

TEST(PseudoTerminal, WritesOverNoFile) {
  const std::string link = own_link();
  std::filesystem::create_symlink("/etc/passwd", link);
  const auto line = PseudoTerminal::open(link);
  ASSERT_FALSE(line.has_value());
  EXPECT_EQ(line.error(), "there can't be a link `" + link + "`: File exists");
  EXPECT_EQ(std::filesystem::read_symlink(link), "/etc/passwd");
  std::filesystem::remove(link);
}

}  // namespace
}  // namespace mlab::model_vehicles
