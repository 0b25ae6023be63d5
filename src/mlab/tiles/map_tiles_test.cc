#include "mlab/tiles/map_tiles.h"

#include <sqlite3.h>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace mlab::tiles {
namespace {

const std::string kPng = std::string("\x89PNG\r\n\x1a\n") + "picture";

// A file of the test's own, which goes with it.
class MapTilesTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }

  void make(const std::string& sql) {
    sqlite3* connection = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &connection), SQLITE_OK);
    char* error = nullptr;
    EXPECT_EQ(sqlite3_exec(connection, sql.c_str(), nullptr, nullptr, &error), SQLITE_OK)
        << (error ? error : "");
    sqlite3_free(error);
    sqlite3_close(connection);
  }
  static std::string hex(std::string_view bytes) {
    std::string out = "x'";
    for (const char c : bytes) {
      out += "0123456789abcdef"[static_cast<unsigned char>(c) / 16];
      out += "0123456789abcdef"[static_cast<unsigned char>(c) % 16];
    }
    return out + "'";
  }
  static std::string tile(int zoom, int column, int row, std::string_view bytes) {
    return "INSERT INTO tiles VALUES (" + std::to_string(zoom) + "," + std::to_string(column) + "," +
           std::to_string(row) + "," + hex(bytes) + ");";
  }
  std::string what_is_wrong() const {
    const auto opened = MapTiles::open(path_);
    return opened ? "" : opened.error().message.substr(opened.error().message.find(": ") + 2);
  }

  const std::string path_ = testing::TempDir() + "map_tiles_" +
                            testing::UnitTest::GetInstance()->current_test_info()->name() + ".mbtiles";
};

constexpr const char* kTables =
    "CREATE TABLE metadata (name TEXT, value TEXT);"
    "CREATE TABLE tiles (zoom_level INTEGER, tile_column INTEGER, tile_row INTEGER, tile_data BLOB);";

TEST_F(MapTilesTest, HandsOutTilesByTheirRowFromTheNorth) {
  make(kTables + tile(2, 3, 0, kPng + "south") + tile(2, 3, 3, kPng + "north"));
  const auto opened = MapTiles::open(path_);
  ASSERT_TRUE(opened) << text::render(opened.error());
  const MapTiles& map = **opened;
  EXPECT_EQ(map.find(2, 3, 0).content_type, "image/png");
  EXPECT_EQ(*map.find(2, 3, 0).bytes, kPng + "north");
  EXPECT_EQ(*map.find(2, 3, 3).bytes, kPng + "south");
  EXPECT_EQ(map.description().least_zoom, 2);
  EXPECT_EQ(map.description().most_zoom, 2);
  EXPECT_FALSE(map.find(2, 1, 1).bytes);
  EXPECT_FALSE(map.find(1, 0, 0).bytes);
  EXPECT_FALSE(map.find(2, 4, 0).bytes);
  EXPECT_FALSE(map.find(4000000000U, 0, 0).bytes);
}

TEST_F(MapTilesTest, SaysWhatItsMetadataSay) {
  make(std::string(kTables) + tile(14, 1, 1, kPng) +
       "INSERT INTO metadata VALUES ('minzoom', '10'), ('maxzoom', '99'), ('format', 'png'),"
       "('bounds', '16.2, 48.1,16.6,48.3'), ('attribution', '<a href=\"https://x\">&copy; Somebody</a> & "
       "Sons');");
  const auto opened = MapTiles::open(path_);
  ASSERT_TRUE(opened);
  const Description& it = (*opened)->description();
  EXPECT_EQ(it.least_zoom, 10);
  EXPECT_EQ(it.most_zoom, MapTiles::kMostZoom);
  EXPECT_EQ(it.west, 16.2);
  EXPECT_EQ(it.south, 48.1);
  EXPECT_EQ(it.east, 16.6);
  EXPECT_EQ(it.north, 48.3);
  EXPECT_EQ(it.attribution, "© Somebody & Sons");
}

TEST_F(MapTilesTest, TakesTilesOutOfAView) {
  make(
      "CREATE TABLE metadata (name TEXT, value TEXT); CREATE TABLE map (z, x, y, id); CREATE TABLE images "
      "(id, data);"
      "CREATE VIEW tiles AS SELECT z AS zoom_level, x AS tile_column, y AS tile_row, data AS tile_data FROM "
      "map JOIN "
      "images ON images.id = map.id; INSERT INTO map VALUES (0, 0, 0, 1); INSERT INTO images VALUES (1, " +
      hex("\xff\xd8\xff picture") + ");");
  const auto opened = MapTiles::open(path_);
  ASSERT_TRUE(opened);
  EXPECT_EQ((*opened)->find(0, 0, 0).content_type, "image/jpeg");
}

TEST_F(MapTilesTest, RefusesWhatIsNoMapInTiles) {
  EXPECT_EQ(what_is_wrong(), "No such file or directory");
  std::ofstream(path_)
      << "just some text, as long as the header of a database would have been, and then some more of it";
  EXPECT_EQ(what_is_wrong(), "file is not a database");
  std::filesystem::remove(path_);
  make("CREATE TABLE metadata (name TEXT, value TEXT);");
  EXPECT_EQ(what_is_wrong(), "no such table: tiles");
  std::filesystem::remove(path_);
  make("CREATE TABLE other (x);");
  EXPECT_EQ(what_is_wrong(), "no such table: metadata");
}

TEST_F(MapTilesTest, RefusesVectorsAndWhatIsEmpty) {
  make(kTables);
  EXPECT_EQ(what_is_wrong(), "it holds no tile");
  make(tile(3, 1, 1, "\x1f\x8b vectors"));
  EXPECT_EQ(what_is_wrong(), "its tiles are no PNG, JPEG or WebP pictures");
  make("INSERT INTO metadata VALUES ('format', 'pbf');");
  EXPECT_EQ(what_is_wrong(), "its tiles are vectors (`pbf`), no pictures");
}

TEST_F(MapTilesTest, HandsOutNothingThatIsTooLargeOrNoPicture) {
  make(kTables + tile(1, 0, 0, kPng) + tile(1, 1, 0, "<svg onload='evil()'/>") +
       "INSERT INTO tiles VALUES (1, 0, 1, zeroblob(3000000));");
  const auto opened = MapTiles::open(path_);
  ASSERT_TRUE(opened);
  EXPECT_TRUE((*opened)->find(1, 0, 1).bytes);
  EXPECT_FALSE((*opened)->find(1, 1, 1).bytes);
  EXPECT_FALSE((*opened)->find(1, 0, 0).bytes);
  EXPECT_TRUE((*opened)->find(1, 0, 1).bytes) << "what went wrong before is over";
}

TEST_F(MapTilesTest, GivesUpOnAViewThatNeverEnds) {
  make(
      "CREATE TABLE metadata (name TEXT, value TEXT); CREATE VIEW tiles AS WITH RECURSIVE n(i) AS (SELECT 1 "
      "UNION ALL "
      "SELECT i + 1 FROM n) SELECT 1 AS zoom_level, i AS tile_column, 1 AS tile_row, NULL AS tile_data FROM "
      "n WHERE i < 0;");
  EXPECT_EQ(what_is_wrong(), "looking at it takes too long");
}

TEST_F(MapTilesTest, LetsASchemaCallNothingAndMetadataBeAnything) {
  make(std::string(kTables) + tile(1, 0, 0, kPng) +
       "INSERT INTO metadata VALUES ('bounds', '1,2'), ('bounds', 'nan,1,2,3'), ('bounds', '5,5,4,4'),"
       "('minzoom', 'x'), ('maxzoom', '-1e999'), (NULL, NULL), ('attribution', NULL), ('attribution', "
       "'<<<');");
  const auto opened = MapTiles::open(path_);
  ASSERT_TRUE(opened);
  EXPECT_EQ((*opened)->description().west, -180.0);
  EXPECT_EQ((*opened)->description().most_zoom, 1);
  EXPECT_EQ((*opened)->description().attribution, "");
}

}  // namespace
}  // namespace mlab::tiles
