// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/pin_recording.hpp"

#include <algorithm>

#include "shared/machine/recording.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::supervisor {

void PinRecording::put(SegmentHeader& shared, std::uint32_t token, std::span<const std::uint8_t> bytes,
                       Time now) {
    if (token != token_) {
        token_ = token;
        lease_seen_ = shared.recording_lease.load(std::memory_order_acquire);
        renewed_ = now;
    }
    const bool is_end = bytes.empty();
    do {
        RecordingPiece piece{};
        piece.token = token;
        piece.bytes = static_cast<std::uint32_t>(std::min(bytes.size(), sizeof piece.data));
        std::copy_n(bytes.begin(), piece.bytes, piece.data);
        bytes = bytes.subspan(piece.bytes);
        append_to_ring(shared.recording, piece);
    } while (!bytes.empty());
    if (is_end) token_ = 0;
}

bool PinRecording::is_abandoned(const SegmentHeader& shared, Time now) noexcept {
    if (token_ == 0) return false;
    const std::uint64_t lease = shared.recording_lease.load(std::memory_order_acquire);
    if (lease != lease_seen_) {
        lease_seen_ = lease;
        renewed_ = now;
    }
    if (now - renewed_ < kRecordingLease) return false;
    token_ = 0;
    return true;
}

bool PinRecording::is_reader_behind(const SegmentHeader& shared) const noexcept {
    if (token_ == 0) return false;
    const std::uint64_t put = shared.recording.published.load(std::memory_order_relaxed);
    const std::uint64_t taken = shared.recording_taken.load(std::memory_order_acquire);
    return taken < put && put - taken > kRecordingPieces / 2;
}

}  // namespace psicarve::supervisor
