// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "hmi/flat/grey_image.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {
namespace {

/// P1 to P6: netpbm's formats. Text numbers may have comments between them, binary rows follow one blank.
class PnmWalk {
public:
    PnmWalk(Bytes bytes, const std::string& file) : bytes_(bytes), file_(file), kind_(bytes[1] - '0') {}

    Result<GreyImage> read() {
        at_ = 2;
        const auto width = number();
        const auto height = width ? number() : std::nullopt;
        const auto most = height && !is_bits() ? number() : std::optional<std::uint32_t>(1);
        if (!width || !height || !most)
            return bad_input(file_ + ": a damaged PGM picture: its size cannot be read");
        if (auto fits = check_image_size(*width, *height, file_); !fits) return fits.error();
        if (*most < 1 || *most > 65535) {
            return bad_input(file_ + ": a damaged PGM picture: white is " + std::to_string(*most) +
                             ", allowed are 1 to 65535");
        }
        most_ = *most;
        if (is_binary()) ++at_;  // the one blank behind the head
        const std::string bits = most_ > 255 ? "PGM, 16 bits" : "PGM, 8 bits";
        GreyImage image{*width, *height, {}, bits, {}};
        // Each pixel takes at least this much of the file: check that before allocating memory.
        const std::uint64_t pixels = image.width * image.height;
        const std::uint64_t least = kind_ == 4 ? (image.width + 7) / 8 * image.height : pixels;
        if (at_ > bytes_.size() || bytes_.size() - at_ < least) return cut();
        image.values.reserve(pixels);
        for (std::size_t y = 0; y < image.height; ++y) {
            for (std::size_t x = 0; x < image.width; ++x) {
                const auto value = pixel(x);
                if (!value) return cut();
                image.values.push_back(*value);
            }
        }
        if (is_colour()) image.warnings.emplace_back("the picture is in colour; its brightness is taken");
        return image;
    }

private:
    bool is_bits() const noexcept { return kind_ == 1 || kind_ == 4; }
    bool is_colour() const noexcept { return kind_ == 3 || kind_ == 6; }
    bool is_binary() const noexcept { return kind_ >= 4; }
    Error cut() const {
        return bad_input(file_ + ": a damaged PGM picture: its pixels end too early, or are more than white");
    }

    void skip_gap() noexcept {
        while (at_ < bytes_.size()) {
            const unsigned char c = bytes_[at_];
            if (c == '#') {
                while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
            } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
                ++at_;
            } else {
                return;
            }
        }
    }
    std::optional<std::uint32_t> number() noexcept {
        skip_gap();
        std::uint32_t value = 0;
        const std::size_t begin = at_;
        while (at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9' && at_ - begin < 9) {
            value = value * 10 + (bytes_[at_++] - std::uint32_t{'0'});
        }
        if (at_ == begin) return std::nullopt;
        return value;
    }

    std::optional<std::uint32_t> sample() noexcept {
        std::uint32_t value = 0;
        if (is_binary()) {
            const std::size_t count = most_ > 255 ? 2 : 1;
            if (bytes_.size() - at_ < count) return std::nullopt;
            for (std::size_t i = 0; i < count; ++i) value = (value << 8U) | bytes_[at_++];
        } else {
            const auto read = number();
            if (!read) return std::nullopt;
            value = *read;
        }
        if (value > most_) return std::nullopt;
        return (value * 65535U + most_ / 2) / most_;
    }

    std::optional<std::uint16_t> pixel(std::size_t x) noexcept {
        if (is_bits()) {
            const auto is_black = bit(x);
            if (!is_black) return std::nullopt;
            return static_cast<std::uint16_t>(*is_black ? 0 : 65535);
        }
        if (!is_colour()) {
            const auto grey = sample();
            if (!grey) return std::nullopt;
            return static_cast<std::uint16_t>(*grey);
        }
        std::array<std::uint32_t, 3> colour{};
        for (std::uint32_t& part : colour) {
            const auto value = sample();
            if (!value) return std::nullopt;
            part = *value;
        }
        return grey_of(colour[0], colour[1], colour[2]);
    }

    std::optional<bool> bit(std::size_t x) noexcept {
        if (is_binary()) {  // rows begin at whole bytes
            if (x == 0) row_at_ = at_;
            const std::size_t at = row_at_ + x / 8;
            if (at >= bytes_.size()) return std::nullopt;
            at_ = at + 1;
            return ((bytes_[at] >> (7U - x % 8)) & 1U) != 0;
        }
        skip_gap();
        if (at_ >= bytes_.size() || (bytes_[at_] != '0' && bytes_[at_] != '1')) return std::nullopt;
        return bytes_[at_++] == '1';
    }

    Bytes bytes_;
    const std::string& file_;
    int kind_;
    std::size_t at_ = 0;
    std::size_t row_at_ = 0;
    std::uint32_t most_ = 1;
};

}  // namespace

Result<GreyImage> read_pnm(Bytes bytes, const std::string& file) {
    if (bytes.size() < 3) return bad_input(file + ": a damaged PGM picture: its size cannot be read");
    return PnmWalk(bytes, file).read();
}

}  // namespace psicarve::flat
