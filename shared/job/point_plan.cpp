// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/job/point_plan.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

namespace psicarve {
namespace {

static_assert(std::endian::native == std::endian::little && sizeof(float) == 4);

constexpr std::string_view kMagic = "PSCAPTS1";
constexpr std::size_t kHeadBytes = kMagic.size() + sizeof(std::uint64_t);
constexpr std::size_t kPointBytes = sizeof(float) + 1;

bool is_time(float seconds) noexcept {
    return std::isfinite(seconds) && seconds >= 0.0F;
}

}  // namespace

std::vector<std::byte> point_plan_bytes(const PointPlan& plan) {
    const std::uint64_t count = plan.seconds.size();
    std::vector<std::byte> bytes(kHeadBytes + count * kPointBytes);
    std::byte* at = bytes.data();
    const auto put = [&at](const void* from, std::size_t size) {
        if (size > 0) std::memcpy(at, from, size);
        at += size;
    };
    put(kMagic.data(), kMagic.size());
    put(&count, sizeof count);
    put(plan.seconds.data(), count * sizeof(float));
    put(plan.bounds.data(), count);
    return bytes;
}

Result<PointPlan> point_plan_from(std::span<const std::byte> bytes, std::size_t point_count) {
    const Error wrong = bad_input("not the plan of a job with so many points");
    std::uint64_t count = 0;
    if (bytes.size() != kHeadBytes + point_count * kPointBytes) return wrong;
    if (std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0) return wrong;
    std::memcpy(&count, bytes.data() + kMagic.size(), sizeof count);
    if (count != point_count) return wrong;
    PointPlan plan{std::vector<float>(point_count), std::vector<WayBound>(point_count)};
    if (point_count == 0) return plan;
    std::memcpy(plan.seconds.data(), bytes.data() + kHeadBytes, point_count * sizeof(float));
    const auto bounds = bytes.subspan(kHeadBytes + point_count * sizeof(float));
    const bool are_known = std::ranges::all_of(
        bounds, [](std::byte bound) { return std::to_integer<std::size_t>(bound) < kWayBoundCount; });
    if (!are_known || !std::ranges::all_of(plan.seconds, is_time)) return wrong;
    std::memcpy(plan.bounds.data(), bounds.data(), point_count);
    return plan;
}

}  // namespace psicarve
