// Radiance images (.hdr): a text header, then rows of RGBE pixels, each row flat or run-length coded in one of two
// ways.
#include "base/text.hpp"
#include "lab/scene/images/image_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace glint::scene {
namespace {

using Rgbe = std::array<uint8_t, 4>; // three mantissas and their common exponent

glm::vec3 decodeRgbe(const Rgbe& p) {
    if (p[3] == 0)
        return glm::vec3(0);
    const float scale = std::ldexp(1.0f, p[3] - (128 + 8)); // mantissas are 8-bit fractions, the exponent's bias is 128
    return {asEnvironmentRadiance(float(p[0]) * scale), asEnvironmentRadiance(float(p[1]) * scale),
            asEnvironmentRadiance(float(p[2]) * scale)};
}

class Decoder {
public:
    Decoder(std::string_view bytes, std::string_view name, uint64_t maxPixels)
        : bytes_(bytes), name_(name), maxPixels_(maxPixels) {}

    Result<HdrImage> decode() {
        GLINT_CHECK(readHeader());
        GLINT_CHECK(readResolution());
        std::vector<Rgbe> row(image_.width);
        std::vector<glm::vec3>& rgb = image_.rgb; // grows with the file's data, not with its header's size
        for (uint32_t y = 0; y < image_.height; ++y) {
            if (!readRow(row))
                return invalidInput("{}: row {} of {} is truncated or broken", name_, y + 1, image_.height);
            for (const Rgbe& pixel : row)
                rgb.push_back(decodeRgbe(pixel));
            if (mirrored_)
                std::reverse(rgb.end() - image_.width, rgb.end());
        }
        if (bottomUp_)
            flipRows();
        return std::move(image_);
    }

private:
    Result<std::string_view> readLine() {
        constexpr size_t kLongestLine = 4096;
        const size_t end = bytes_.substr(at_, kLongestLine).find('\n');
        if (end == std::string_view::npos)
            return invalidInput("{}: the header is truncated", name_);
        std::string_view line = bytes_.substr(at_, end);
        at_ += end + 1;
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        return line;
    }

    Result<void> readHeader() {
        GLINT_TRY(magic, readLine());
        if (!magic.starts_with("#?"))
            return invalidInput("{}: no Radiance picture: it does not begin with #?", name_);
        for (;;) {
            GLINT_TRY(line, readLine());
            if (line.empty())
                return {};
            if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
                return invalidInput("{}: {} is not supported, only 32-bit_rle_rgbe", name_, printable(line));
        }
    }

    /// "-Y 512 +X 1024": rows from the top, pixels from the left. The other signs flip.
    Result<void> readResolution() {
        GLINT_TRY(line, readLine());
        const auto bad = [&] {
            return invalidInput("{}: expected a size like '-Y 512 +X 1024', got '{}'", name_, printable(line));
        };
        const char* at = line.data();
        const char* const end = at + line.size();
        const auto axis = [&](char letter, bool& negative, uint32_t& size) {
            if (end - at < 4 || (at[0] != '-' && at[0] != '+') || at[1] != letter || at[2] != ' ')
                return false;
            negative = at[0] == '-';
            const auto [rest, error] = std::from_chars(at + 3, end, size);
            at = rest;
            return error == std::errc() && size > 0;
        };
        bool topDown = false;
        if (!axis('Y', topDown, image_.height) || at == end || *at++ != ' ' || !axis('X', mirrored_, image_.width) ||
            at != end)
            return bad();
        bottomUp_ = !topDown;
        if (image_.width > kMaxImageSide || image_.height > kMaxImageSide ||
            uint64_t(image_.width) * image_.height > maxPixels_)
            return invalidInput("{}: {} x {} pixels are too many, at most {} a side and {} in all are read", name_,
                                image_.width, image_.height, kMaxImageSide, maxPixels_);
        return {};
    }

    bool readRow(std::vector<Rgbe>& row) {
        const std::string_view rest = bytes_.substr(at_);
        const size_t width = row.size();
        // A new-style row begins with 2, 2 and its length; only rows of 8 to 32767 pixels may use it.
        if (rest.size() >= 4 && rest[0] == 2 && rest[1] == 2 && byte(rest[2]) < 128 && width >= 8) {
            if ((size_t(byte(rest[2])) << 8 | byte(rest[3])) != width)
                return false;
            at_ += 4;
            return readPlanes(row);
        }
        return readPixels(row);
    }

    /// Four planes, each in runs: n > 128 repeats the next byte n - 128 times, n <= 128 copies n bytes.
    bool readPlanes(std::vector<Rgbe>& row) {
        for (size_t plane = 0; plane < 4; ++plane) {
            for (size_t x = 0; x < row.size();) {
                if (at_ + 2 > bytes_.size())
                    return false;
                const size_t code = byte(bytes_[at_++]);
                const bool run = code > 128;
                const size_t count = run ? code - 128 : code;
                if (count == 0 || x + count > row.size() || at_ + (run ? 1 : count) > bytes_.size())
                    return false;
                for (size_t i = 0; i < count; ++i)
                    row[x++][plane] = byte(bytes_[run ? at_ : at_ + i]);
                at_ += run ? 1 : count;
            }
        }
        return true;
    }

    /// Whole pixels; 1, 1, 1, n repeats the previous pixel n times; directly following repeats add higher bytes to n.
    bool readPixels(std::vector<Rgbe>& row) {
        int shift = 0;
        for (size_t x = 0; x < row.size();) {
            if (at_ + 4 > bytes_.size())
                return false;
            Rgbe pixel;
            for (size_t i = 0; i < 4; ++i)
                pixel[i] = byte(bytes_[at_ + i]);
            at_ += 4;
            if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
                row[x++] = pixel;
                shift = 0;
                continue;
            }
            const uint64_t count = shift < 32 ? uint64_t(pixel[3]) << shift : row.size() + 1;
            if (x == 0 || count > row.size() - x)
                return false;
            std::fill_n(row.begin() + std::ptrdiff_t(x), count, row[x - 1]);
            x += count;
            shift += 8;
        }
        return true;
    }

    void flipRows() {
        for (size_t top = 0, bottom = image_.height - 1; top < bottom; ++top, --bottom)
            std::swap_ranges(image_.rgb.begin() + std::ptrdiff_t(top * image_.width),
                             image_.rgb.begin() + std::ptrdiff_t((top + 1) * image_.width),
                             image_.rgb.begin() + std::ptrdiff_t(bottom * image_.width));
    }

    static uint8_t byte(char c) { return static_cast<uint8_t>(c); }

    std::string_view bytes_, name_;
    uint64_t maxPixels_;
    size_t at_ = 0;
    bool mirrored_ = false, bottomUp_ = false;
    HdrImage image_;
};

} // namespace

Result<HdrImage> decodeRadiance(std::string_view bytes, std::string_view name, uint64_t maxPixels) {
    return Decoder(bytes, name, maxPixels).decode();
}

} // namespace glint::scene
