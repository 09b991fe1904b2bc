// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/segment/segment.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <boost/interprocess/exceptions.hpp>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include "shared/segment/segment_header.hpp"
#include "shared/segment/segment_mapping.hpp"
#include "shared/segment/segment_object.hpp"

namespace psicarve {
namespace {

namespace bip = boost::interprocess;

/// How long another process may take to make a segment.
constexpr std::chrono::milliseconds kMakingLimit{5000};
constexpr std::chrono::milliseconds kMakingPoll{2};

/// Only header and ring are mapped: slots are read and written through the descriptor.
Result<bip::mapped_region> map_front(const SegmentObject& object, const std::string& name,
                                     const SegmentGeometry& geometry) {
    try {
        return bip::mapped_region{object.shm(), bip::read_write, 0, geometry.mapped_bytes};
    } catch (const bip::interprocess_exception& failure) {
        return bad_input("segment " + name + ": cannot be mapped: " +
                         std::generic_category().message(failure.get_native_error()));
    }
}

/// Fills an object that we created and whose creator lock we hold.
Result<void> make_contents(SegmentObject& object, const std::string& name, const SegmentOptions& options) {
    const SegmentGeometry geometry =
        segment_geometry(options.capacity_layers, options.capacity_points, options.capacity_records);
    if (auto sized = object.resize(name, geometry.total_bytes); !sized) return sized;
    if (auto reserved = object.reserve(name, 0, geometry.mapped_bytes); !reserved) return reserved;
    Result<bip::mapped_region> region = map_front(object, name, geometry);
    if (!region) return region.error();
    auto* const header = static_cast<SegmentHeader*>(region->get_address());
    return fill_header(*header, options.capacity_layers, options.capacity_points, options.capacity_records);
}

/// Makes the object if the name is free. False: another process was first, look again.
Result<bool> try_make(const std::string& name, const SegmentOptions& options) {
    auto created = SegmentObject::create(name, options.group);
    if (!created) return created.error();
    if (!created->has_value()) return false;
    SegmentObject& object = **created;
    // Between creation and this lock the object looks like one whose creator died: a process that held the
    // lock meanwhile has removed its name.
    if (!object.try_lock(LockByte::creator) || !object.is_named(name)) return false;
    if (auto made = make_contents(object, name, options); !made) {
        if (auto removed = SegmentObject::unlink(name); !removed) return removed.error();
        return made.error();
    }
    object.unlock(LockByte::creator);
    return true;
}

bool is_to_be_replaced(HeaderState state, const SegmentOptions& options) noexcept {
    return state == HeaderState::half_made || is_stale(state) ||
           (options.replaces_damaged && is_damaged(state));
}

/// Frees the name of an object that its creator left half made, or that has no user any more. False: its
/// creator is at work.
Result<bool> try_take_away(SegmentObject& object, const std::string& name, const SegmentOptions& options) {
    if (!object.try_lock(LockByte::creator)) return false;
    // No process removes the name without this lock: now it cannot change under us.
    if (is_to_be_replaced(examine_header(object).state, options) && object.is_named(name)) {
        if (auto removed = SegmentObject::unlink(name); !removed) return removed.error();
    }
    object.unlock(LockByte::creator);
    return true;
}

Result<void> check_capacity(const SegmentOptions& options) {
    const bool is_possible = options.capacity_layers >= 1 && options.capacity_layers <= kMaxCapacityLayers &&
                             options.capacity_points >= 2 && options.capacity_points <= kMaxCapacityPoints;
    if (!is_ring_capacity(options.capacity_records)) {
        return Error{ErrorCode::bad_usage, "a ring of " + std::to_string(options.capacity_records) +
                                               " records is not possible: a power of two from 64 to 65536"};
    }
    if (is_possible) return {};
    return Error{ErrorCode::bad_usage, "a capacity of " + std::to_string(options.capacity_layers) + "x" +
                                           std::to_string(options.capacity_points) +
                                           " is not possible: 1x2 to 1000000x1000000"};
}

std::string capacity_warning(const HeaderFacts& found, const SegmentOptions& asked, const std::string& name) {
    const bool is_enough =
        found.capacity_layers >= asked.capacity_layers && found.capacity_points >= asked.capacity_points;
    if (is_enough) return {};
    return "segment " + name + " exists with room for " + std::to_string(found.capacity_layers) +
           " layers x " + std::to_string(found.capacity_points) +
           " points, less than asked for: choose another --segment " + "for larger jobs";
}

}  // namespace

Segment::Segment(std::unique_ptr<Mapping> mapping) noexcept : mapping_(std::move(mapping)) {}
Segment::Segment(Segment&&) noexcept = default;
Segment& Segment::operator=(Segment&&) noexcept = default;
Segment::~Segment() {
    if (mapping_) release_core();
}

Result<void> check_shared_memory_for(std::uint32_t capacity_layers, std::uint32_t capacity_points) {
    constexpr std::uint64_t kBytesPerMb = 1'000'000;
    const std::uint64_t wanted_bytes = segment_geometry(capacity_layers, capacity_points).slot_bytes;
    const auto free_bytes = free_shared_memory_bytes();
    if (!free_bytes || wanted_bytes <= *free_bytes) return {};
    return Error{ErrorCode::bad_usage,
                 "--capacity " + std::to_string(capacity_layers) + "x" + std::to_string(capacity_points) +
                     ": a job of that size takes " + std::to_string(wanted_bytes / kBytesPerMb) +
                     " MB of shared memory, /dev/shm has " + std::to_string(*free_bytes / kBytesPerMb) +
                     " MB free: ask for less, or enlarge it: mount -o remount,size=1G /dev/shm"};
}

Result<Segment> Segment::create_or_attach(const SegmentOptions& options) {
    if (auto possible = check_capacity(options); !possible) return possible.error();
    const Result<std::string> name = SegmentObject::checked_name(options.name);
    if (!name) return name.error();
    const auto deadline = std::chrono::steady_clock::now() + options.patience;
    do {
        auto found = SegmentObject::open(*name, options.group);
        if (!found) return found.error();
        if (!found->has_value()) {
            const Result<bool> made = try_make(*name, options);
            if (!made) return made.error();
            continue;
        }
        const HeaderFacts facts = examine_header(**found);
        if (facts.state == HeaderState::usable) {
            Result<bip::mapped_region> region = map_front(**found, *name, facts.geometry);
            if (!region) return region.error();
            Segment segment{std::make_unique<Mapping>(std::move(**found), std::move(*region), facts, *name)};
            segment.mapping_->warning = capacity_warning(facts, options, *name);
            return segment;
        }
        if (!is_to_be_replaced(facts.state, options)) return refusal_of(facts, *name);
        const Result<bool> taken = try_take_away(**found, *name, options);
        if (!taken) return taken.error();
        if (!*taken) std::this_thread::sleep_for(kMakingPoll);
    } while (std::chrono::steady_clock::now() < deadline);
    return Error{ErrorCode::timed_out,
                 "segment " + *name + ": another process began to make it and does not finish: end it"};
}

Result<Segment> Segment::attach(const std::string& name, const std::string& group) {
    return attach_by(name, [&](const std::string& checked) { return SegmentObject::open(checked, group); });
}

Result<Segment> Segment::attach_to_stop(const std::string& name) {
    return attach_by(name, SegmentObject::open_whosoever);
}

Result<void> Segment::hand_over(const std::string& name, uid_t user, gid_t group) {
    const Result<std::string> whole_name = SegmentObject::checked_name(name);
    if (!whole_name) return whole_name.error();
    auto found = SegmentObject::open_whosoever(*whole_name);
    if (!found) return found.error();
    // A core that claims it meanwhile finds it locked.
    if (!found->has_value() || !(*found)->try_lock(LockByte::core)) return {};
    return (*found)->give_to_user(*whole_name, user, group);
}

Result<void> Segment::fit_rights(const std::string& group) {
    return mapping_->object.fit_rights(name(), group);
}

template <typename Open>
Result<Segment> Segment::attach_by(const std::string& name, const Open& open) {
    const Result<std::string> checked = SegmentObject::checked_name(name);
    if (!checked) return checked.error();
    const Error missing{ErrorCode::no_core, "there is no segment " + *checked +
                                                ": start psicarve-rtcore, or name another --segment"};
    const auto deadline = std::chrono::steady_clock::now() + kMakingLimit;
    do {
        Result<std::optional<SegmentObject>> found = open(*checked);
        if (!found) return found.error();
        if (!found->has_value()) return missing;
        const HeaderFacts facts = examine_header(**found);
        if (facts.state == HeaderState::usable) {
            Result<bip::mapped_region> region = map_front(**found, *checked, facts.geometry);
            if (!region) return region.error();
            return Segment{
                std::make_unique<Mapping>(std::move(**found), std::move(*region), facts, *checked)};
        }
        if (is_stale(facts.state)) return missing;
        if (facts.state != HeaderState::half_made) return refusal_of(facts, *checked);
        if (!(*found)->is_locked_by_another(LockByte::creator) &&
            examine_header(**found).state == facts.state) {
            return missing;
        }
        std::this_thread::sleep_for(kMakingPoll);
    } while (std::chrono::steady_clock::now() < deadline);
    return missing;
}

Result<void> Segment::remove(const std::string& name) {
    const Result<std::string> checked = SegmentObject::checked_name(name);
    if (!checked) return checked.error();
    return SegmentObject::unlink(*checked);
}

SegmentHeader& Segment::header() noexcept {
    return mapping_->header();
}
const SegmentHeader& Segment::header() const noexcept {
    return mapping_->header();
}
const std::string& Segment::name() const noexcept {
    return mapping_->name;
}
std::uint32_t Segment::capacity_layers() const noexcept {
    return mapping_->capacity_layers;
}
std::uint32_t Segment::capacity_points() const noexcept {
    return mapping_->capacity_points;
}
RecordRing Segment::record_ring() noexcept {
    auto* const bytes = static_cast<std::byte*>(mapping_->region.get_address());
    return {.ends = &header().program.ends,
            .records = reinterpret_cast<RingRecord*>(bytes + mapping_->geometry.ring_offset),
            .capacity = mapping_->capacity_records};
}
std::uint64_t Segment::slot_bytes() const noexcept {
    return mapping_->geometry.slot_bytes;
}
const std::string& Segment::warning() const noexcept {
    return mapping_->warning;
}

Result<void> Segment::give_up_name() {
    return mapping_->object.is_named(mapping_->name) ? SegmentObject::unlink(mapping_->name) : Result<void>{};
}

bool Segment::is_still_linked() const noexcept {
    return !mapping_->guard.is_lost() && examine_header(mapping_->object).state == HeaderState::usable &&
           mapping_->object.is_named(mapping_->name);
}

}  // namespace psicarve
