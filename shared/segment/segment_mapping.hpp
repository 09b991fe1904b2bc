// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/interprocess/mapped_region.hpp>
#include <cstdint>
#include <string>
#include <utility>

#include "shared/segment/segment.hpp"
#include "shared/segment/segment_fault_guard.hpp"
#include "shared/segment/segment_header.hpp"
#include "shared/segment/segment_object.hpp"

namespace psicarve {

/// The inside of a Segment, for the segment's own sources only.
struct Segment::Mapping {
    Mapping(SegmentObject mapped_object, boost::interprocess::mapped_region mapped, const HeaderFacts& facts,
            std::string segment_name)
        : object(std::move(mapped_object)),
          region(std::move(mapped)),
          guard(region.get_address(), region.get_size()),
          name(std::move(segment_name)),
          capacity_layers(facts.capacity_layers),
          capacity_points(facts.capacity_points),
          capacity_records(facts.capacity_records),
          geometry(facts.geometry) {}

    SegmentHeader& header() const noexcept { return *static_cast<SegmentHeader*>(region.get_address()); }

    SegmentObject object;  ///< stays open: locks and slots go through its descriptor
    boost::interprocess::mapped_region region;
    SegmentFaultGuard guard;  ///< ends before the region does
    std::string name;
    std::string warning;
    std::uint32_t capacity_layers;
    std::uint32_t capacity_points;
    std::uint32_t capacity_records;
    SegmentGeometry geometry;          ///< our own, checked; never re-read from shared memory
    std::uint32_t core_owner_pid = 0;  ///< the process that claimed the core through this object; 0: none
};

}  // namespace psicarve
