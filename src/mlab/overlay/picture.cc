#include "mlab/overlay/picture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace mlab::overlay {
namespace {

// Of 48 MB, uncompressed: a few bytes of a file may ask for any size.
constexpr std::uint64_t kMostPixels = std::uint64_t{16} << 20;
constexpr std::uint32_t kMostValue = 65535;

std::string type_of(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff"sv)) return "image/jpeg";
  if (bytes.starts_with("GIF87a"sv) || bytes.starts_with("GIF89a"sv)) return "image/gif";
  if (bytes.starts_with("RIFF"sv) && bytes.size() > 12 && bytes.substr(8, 4) == "WEBP"sv) return "image/webp";
  if (bytes.starts_with("BM"sv)) return "image/bmp";
  return "";
}

bool is_blank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// What a PGM or PPM file is read from. Nothing here reads past the end.
class Netpbm {
 public:
  struct Header {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    std::uint32_t most = 0;  // value of white
    bool is_grey = false;
    bool is_text = false;  // numbers instead of bytes
  };

  explicit Netpbm(std::string_view bytes) : bytes_(bytes) {}

  static bool is_one(std::string_view bytes) {
    return bytes.size() > 2 && bytes[0] == 'P' &&
           std::string_view("2356").find(bytes[1]) != std::string_view::npos &&
           (is_blank(bytes[2]) || bytes[2] == '#');
  }

  std::optional<Header> header() {
    Header out;
    out.is_grey = bytes_[1] == '2' || bytes_[1] == '5';
    out.is_text = bytes_[1] == '2' || bytes_[1] == '3';
    at_ = 2;
    out.width = number();
    out.height = number();
    out.most = number();
    ++at_;  // one blank, then the pixels
    const bool is_good = out.width > 0 && out.height > 0 && out.most > 0 && out.most <= kMostValue &&
                         out.height <= kMostPixels / out.width;
    return is_good ? std::optional(out) : std::nullopt;
  }

  // 0 to 255; 0 where the file has ended.
  std::uint8_t value(const Header& header) {
    std::uint32_t raw = 0;
    if (header.is_text) {
      raw = number();
    } else {
      raw = next_byte();
      if (header.most > 255) raw = raw * 256U + next_byte();
    }
    return static_cast<std::uint8_t>(std::min(raw, header.most) * std::uint64_t{255} / header.most);
  }

 private:
  std::uint32_t next_byte() { return at_ < bytes_.size() ? static_cast<std::uint8_t>(bytes_[at_++]) : 0U; }

  // 0 where there is none; what is too large stays larger than every limit.
  std::uint32_t number() {
    for (; at_ < bytes_.size(); ++at_) {
      if (bytes_[at_] == '#') {
        at_ = std::min(bytes_.find('\n', at_), bytes_.size());
        if (at_ == bytes_.size()) return 0;
      } else if (!is_blank(bytes_[at_])) {
        break;
      }
    }
    std::uint32_t out = 0;
    for (; at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_)
      out = std::min<std::uint32_t>(out * 10U + static_cast<std::uint32_t>(bytes_[at_] - '0'), 200'000'000U);
    return out;
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

void put(std::string& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>((value >> (8 * i)) & 255U));
}

// 24 bits a pixel; rows from the top, each filled up to four bytes.
std::string bmp_of(Netpbm& pixels, const Netpbm::Header& header) {
  const std::uint64_t row_bytes = (header.width * 3 + 3) / 4 * 4;
  const std::uint64_t size = row_bytes * header.height;
  std::string out = "BM";
  out.reserve(54 + size);
  put(out, static_cast<std::uint32_t>(54 + size), 4);
  put(out, 0, 4);
  put(out, 54, 4);  // where the pixels begin
  put(out, 40, 4);  // BITMAPINFOHEADER
  put(out, static_cast<std::uint32_t>(header.width), 4);
  put(out, ~static_cast<std::uint32_t>(header.height) + 1U, 4);  // negative: from the top
  put(out, 1, 2);
  put(out, 24, 2);
  put(out, 0, 4);
  put(out, static_cast<std::uint32_t>(size), 4);
  for (int i = 0; i < 4; ++i) put(out, 0, 4);
  for (std::uint64_t row = 0; row < header.height; ++row) {
    for (std::uint64_t column = 0; column < header.width; ++column) {
      std::array<std::uint8_t, 3> color{};
      color.fill(pixels.value(header));
      if (!header.is_grey) {
        color[1] = pixels.value(header);
        color[2] = pixels.value(header);
      }
      for (int i = 2; i >= 0; --i) out.push_back(static_cast<char>(color[static_cast<std::size_t>(i)]));
    }
    out.append(row_bytes - header.width * 3, '\0');
  }
  return out;
}

}  // namespace

ShownPicture shown_picture(std::string bytes) {
  if (Netpbm::is_one(bytes)) {
    Netpbm picture(bytes);
    const auto header = picture.header();
    return header ? ShownPicture{"image/bmp", bmp_of(picture, *header)} : ShownPicture{};
  }
  std::string type = type_of(bytes);
  if (type.empty()) return {};
  return {std::move(type), std::move(bytes)};
}

std::string why_not_shown(std::string_view first_bytes) {
  if (Netpbm::is_one(first_bytes)) {
    return Netpbm(first_bytes).header()
               ? ""
               : "does not begin with width, height and largest value, or has more than 16 million pixels";
  }
  return type_of(first_bytes).empty() ? "is none of PNG, JPEG, GIF, WebP, BMP, PGM and PPM" : "";
}

}  // namespace mlab::overlay
