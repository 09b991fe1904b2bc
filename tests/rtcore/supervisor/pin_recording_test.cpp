// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/pin_recording.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <vector>

#include "shared/machine/jog_lease.hpp"
#include "shared/machine/recording.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::supervisor {
namespace {

using std::chrono::milliseconds;

class PinRecordingTest : public testing::Test {
protected:
    void put(const std::vector<std::uint8_t>& bytes) { sut_.put(*shared_, 7, bytes, now_); }
    void renew() { shared_->recording_lease.store(jog_lease_word(7, ++beat_)); }

    std::unique_ptr<SegmentHeader> shared_ = std::make_unique<SegmentHeader>();
    PinRecording sut_;
    PinRecording::Time now_{};
    std::uint32_t beat_ = 0;
};

TEST_F(PinRecordingTest, CutsItsBytesIntoPiecesInOrderAndMarksTheEnd) {
    std::vector<std::uint8_t> bytes(1000);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
    RingReader reader{shared_->recording, true};
    put(bytes);
    put({});
    std::vector<std::uint8_t> got;
    auto piece = reader.next();
    for (; piece && piece->bytes > 0; piece = reader.next()) {
        EXPECT_EQ(piece->token, 7U);
        got.insert(got.end(), piece->data, piece->data + piece->bytes);
    }
    EXPECT_EQ(got, bytes);
    EXPECT_TRUE(piece) << "the end";
    EXPECT_FALSE(reader.next());
}

TEST_F(PinRecordingTest, IsAbandonedOnceItsReaderHasBeenSilentForTheLease) {
    put({1});
    for (int i = 0; i < 5; ++i) {
        renew();
        now_ += kRecordingLease - milliseconds{1};
        EXPECT_FALSE(sut_.is_abandoned(*shared_, now_)) << i;
    }
    now_ += kRecordingLease;
    EXPECT_TRUE(sut_.is_abandoned(*shared_, now_));
    EXPECT_FALSE(sut_.is_abandoned(*shared_, now_)) << "once";
}

TEST_F(PinRecordingTest, ThatHasEndedCannotBeAbandoned) {
    put({1});
    put({});
    now_ += 10 * kRecordingLease;
    EXPECT_FALSE(sut_.is_abandoned(*shared_, now_));
}

TEST_F(PinRecordingTest, WaitsForAReaderThatHasHalfTheRingBeforeIt) {
    for (std::size_t i = 0; i <= kRecordingPieces / 2; ++i) {
        EXPECT_FALSE(sut_.is_reader_behind(*shared_)) << i;
        put({1});
    }
    EXPECT_TRUE(sut_.is_reader_behind(*shared_));
    shared_->recording_taken.store(1);
    EXPECT_FALSE(sut_.is_reader_behind(*shared_));
    shared_->recording_taken.store(~std::uint64_t{0});  // garbage holds up nobody
    EXPECT_FALSE(sut_.is_reader_behind(*shared_));
    shared_->recording_taken.store(0);
    put({});
    EXPECT_FALSE(sut_.is_reader_behind(*shared_)) << "it is over";
}

}  // namespace
}  // namespace psicarve::supervisor
