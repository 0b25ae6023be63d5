#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "mlab/text/diagnostic.h"

struct sqlite3;
struct sqlite3_stmt;

namespace mlab::tiles {

/// What a file of tiles says of itself.
struct Description {
  int least_zoom = 0;  ///< 0..kMostZoom
  int most_zoom = 0;   ///< least_zoom..kMostZoom
  // What it covers [degrees]; the whole Earth where it doesn't say.
  double south = -85.06;
  double west = -180.0;
  double north = 85.06;
  double east = 180.0;
  std::string attribution;  ///< whose it is: plain text, at most kMostAttribution bytes
};

/// A picture, and its content type; without bytes: there is none.
struct Tile {
  std::string content_type;
  std::shared_ptr<const std::string> bytes;
};

/// A map of the Earth in squares of Web Mercator, out of an MBTiles file of PNG, JPEG or WebP pictures. Only
/// reads.
class MapTiles {
 public:
  static constexpr int kMostZoom = 24;
  static constexpr std::size_t kMostBytes = std::size_t{2} << 20;  ///< of a tile
  static constexpr std::size_t kMostAttribution = 300;

  /// @errors  `no-tiles`: it can't be read, is no MBTiles file, holds no pictures (vectors, say) or nothing
  static text::Result<std::shared_ptr<MapTiles>> open(const std::string& path);

  const Description& description() const { return description_; }
  /// Of a square: column from 180 degrees west, row from the north; from any thread. Nothing where the file
  /// has none, where it is larger than kMostBytes, or no picture.
  Tile find(std::uint32_t zoom, std::uint32_t column, std::uint32_t row) const;

 private:
  struct Close {
    void operator()(sqlite3* connection) const;
  };
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Finalize>;

  MapTiles() = default;
  std::string connect(const std::string& path);
  std::string describe();
  std::string find_zooms();
  std::string look_at_one();
  Statement prepare(const char* sql) const;
  int step(sqlite3_stmt* statement) const;
  std::string why() const;

  mutable std::mutex mutex_;  // of all below but the description
  std::unique_ptr<sqlite3, Close> connection_;
  Statement tile_;  // ends before its connection
  mutable std::int64_t steps_ = 0;
  Description description_;
};

}  // namespace mlab::tiles
