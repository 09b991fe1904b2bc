// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shared/program/record_ring.hpp"

namespace psicarve::test {

/// A ring in memory of our own.
class RingInMemory {
public:
    explicit RingInMemory(std::uint32_t capacity = kLeastRingRecords, std::uint64_t first = 0)
        : records_(capacity) {
        ends_.written.store(first);
        ends_.taken.store(first);
    }
    RecordRing get() { return {&ends_, records_.data(), static_cast<std::uint32_t>(records_.size())}; }
    RingEnds& ends() { return ends_; }
    RingRecord& record(std::size_t index) { return records_[index]; }

private:
    RingEnds ends_{};
    std::vector<RingRecord> records_;
};

/// What a record's targets are of these axes.
inline std::array<double, kAxisCount> positions(double r1_mm, double r2_mm, double y_mm, double psi_deg) {
    std::array<double, kAxisCount> target{};
    target[index_of(Axis::r1)] = r1_mm;
    target[index_of(Axis::r2)] = r2_mm;
    target[index_of(Axis::y)] = y_mm;
    target[index_of(Axis::psi)] = psi_deg;
    return target;
}

/// A way of a program, in the middle of the default machine's travel; every number tells its sequence.
inline MotionRecord numbered_record(std::uint64_t sequence, std::uint64_t program = 7) {
    MotionRecord record{};
    record.program = program;
    record.sequence = sequence;
    record.line = sequence / 3 + 1;
    record.kind = MotionKind::way;
    record.axes = 0xF;
    record.flags = kEndsBlock;
    const auto step = static_cast<double>(sequence % 4'000) * 0.0025;
    record.target = positions(20.0 + step, 30.0 - step, 10.0 + step, step);
    record.tolerance_mm = 0.01;
    record.check = record_check(record);
    return record;
}

inline bool is_same(const MotionRecord& a, const MotionRecord& b) {
    return a.check == b.check && a.check == record_check(a) && b.check == record_check(b);
}

}  // namespace psicarve::test
