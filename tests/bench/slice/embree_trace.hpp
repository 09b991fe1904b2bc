// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include "hmi/model/mesh.hpp"

namespace psicarve::bench {

/// Rays from outside to the axis: all directions at each height. File units.
struct Rays {
    std::vector<double> heights;
    std::vector<double> angles_rad;
    float axis_x = 0.0F;
    float axis_y = 0.0F;
    float outside = 100.0F;  ///< where they begin, from the axis
};

/// Builds a robust scene and traces the first hit of each ray; fills its radius, 0 where it hits nothing.
inline void trace_with_embree(std::span<const model::Triangle> triangles, const Rays& rays, RTCDevice device,
                              std::vector<double>& radius) {
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t count = triangles.size();
    void* vertices =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * count);
    std::memcpy(vertices, triangles.data(), count * sizeof(model::Triangle));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count));
    for (std::size_t i = 0; i < 3 * count; ++i) indices[i] = static_cast<unsigned>(i);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);

    const std::size_t directions = rays.angles_rad.size();
    std::vector<float> cosine;
    std::vector<float> sine;
    for (const double angle : rays.angles_rad) {
        cosine.push_back(static_cast<float>(std::cos(angle)));
        sine.push_back(static_cast<float>(std::sin(angle)));
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (std::size_t layer = 0; layer < rays.heights.size(); ++layer) {
        for (std::size_t k = 0; k < directions; ++k) {
            RTCRayHit hit{};
            hit.ray.org_x = rays.axis_x + rays.outside * cosine[k];
            hit.ray.org_y = rays.axis_y + rays.outside * sine[k];
            hit.ray.org_z = static_cast<float>(rays.heights[layer]);
            hit.ray.dir_x = -cosine[k];
            hit.ray.dir_y = -sine[k];
            hit.ray.tfar = rays.outside;
            hit.ray.mask = ~0U;
            hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene, &context, &hit);
            radius[layer * directions + k] =
                hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? 0.0 : double{rays.outside - hit.ray.tfar};
        }
    }
    rtcReleaseScene(scene);
}

}  // namespace psicarve::bench
