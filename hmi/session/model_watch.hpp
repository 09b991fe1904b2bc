// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

#include "hmi/report/model_findings.hpp"
#include "hmi/session/background_queue.hpp"
#include "hmi/session/reach_report.hpp"

namespace psicarve::session {

/// Examines a model on a thread of its own, again whenever it is placed otherwise. All calls come from one
/// thread, the owner's.
class ModelWatch {
public:
    struct Seen {
        ReachReport reach;
        std::shared_ptr<const MeshScene> painted;
        std::optional<SceneView> hidden_view;  ///< as view_of_hidden()
    };

    ModelWatch(std::uint32_t rgb, std::uint32_t hidden_rgb) : rgb_(rgb), hidden_rgb_(hidden_rgb) {}
    ~ModelWatch() { forget(); }

    /// Ends the task under way for another model or placement.
    void look(std::shared_ptr<const model::Mesh> mesh, std::shared_ptr<const MeshScene> scene,
              const Profile& profile, cam::JobOptions options);
    void forget();
    /// Call it at screen rate. The report's findings are calculated once the model was examined and
    /// `wants_findings` is true.
    void poll(bool wants_findings = false);
    /// For the last request; null until it is there.
    std::shared_ptr<const Seen> seen() const noexcept { return seen_; }
    std::shared_ptr<const report::ModelFindings> findings() const noexcept { return findings_; }

private:
    std::uint32_t rgb_;
    std::uint32_t hidden_rgb_;
    std::shared_ptr<std::atomic<bool>> goes_on_;  ///< shared with the task under way
    std::shared_ptr<const Seen> seen_;
    std::shared_ptr<const model::Mesh> mesh_;  ///< the mesh that was examined
    std::array<double, 3> middle_{};           ///< of its box, turned
    slice::Up up_ = slice::Up::z;
    double base_mm_ = 0.0;
    double core_mm_ = 0.0;
    bool is_looked_into_ = false;
    std::shared_ptr<const report::ModelFindings> findings_;
    BackgroundQueue queue_{BackgroundQueue::Haste::background};
};

}  // namespace psicarve::session
