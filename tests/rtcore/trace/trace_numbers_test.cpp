// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "shared/trace/trace_format.hpp"

namespace psicarve {
namespace {

std::vector<std::uint8_t> encoded(std::uint64_t value) {
    std::uint8_t room[kLeb128MaxBytes];
    return {room, encode_leb128(room, value)};
}

TEST(TraceNumbers, EncodeAsTheFormatSays) {
    EXPECT_EQ(encoded(0), (std::vector<std::uint8_t>{0x00}));
    EXPECT_EQ(encoded(127), (std::vector<std::uint8_t>{0x7F}));
    EXPECT_EQ(encoded(128), (std::vector<std::uint8_t>{0x80, 0x01}));
    EXPECT_EQ(encoded(624'485), (std::vector<std::uint8_t>{0xE5, 0x8E, 0x26}));
    EXPECT_EQ(encoded(~std::uint64_t{0}).size(), kLeb128MaxBytes);
}

TEST(TraceNumbers, ComeBackFromAnyEncoding) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t value = random() >> random() % 64;
        const std::vector<std::uint8_t> bytes = encoded(value);
        std::uint64_t decoded = 0;
        const std::uint8_t* const end = bytes.data() + bytes.size();
        ASSERT_EQ(decode_leb128(bytes.data(), end, decoded), end);
        ASSERT_EQ(decoded, value);
        ASSERT_EQ(decode_leb128(bytes.data(), end - 1, decoded), nullptr) << "cut short";
    }
}

TEST(TraceNumbers, RefuseWhatDoesNotFit) {
    std::vector<std::uint8_t> bytes(10, 0xFF);
    bytes.back() = 0x02;
    std::uint64_t value = 0;
    EXPECT_EQ(decode_leb128(bytes.data(), bytes.data() + bytes.size(), value), nullptr);
    bytes.assign(20, 0x80);
    EXPECT_EQ(decode_leb128(bytes.data(), bytes.data() + bytes.size(), value), nullptr);
}

TEST(TraceNumbers, KeepTheirSignThroughZigzag) {
    EXPECT_EQ(zigzag_from(0), 0U);
    EXPECT_EQ(zigzag_from(-1), 1U);
    EXPECT_EQ(zigzag_from(1), 2U);
    EXPECT_EQ(zigzag_from(-2), 3U);
    for (const std::int64_t value :
         {std::numeric_limits<std::int64_t>::min(), std::int64_t{-1'600}, std::int64_t{0},
          std::int64_t{24'000}, std::numeric_limits<std::int64_t>::max()}) {
        EXPECT_EQ(value_from_zigzag(zigzag_from(value)), value);
    }
}

}  // namespace
}  // namespace psicarve
