// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/model_watch.hpp"

#include <utility>

namespace psicarve::session {

void ModelWatch::forget() {
    if (goes_on_) goes_on_->store(false);
    goes_on_.reset();
    seen_.reset();
    findings_.reset();
    mesh_.reset();
    is_looked_into_ = false;
    queue_.drop_waiting();
}

void ModelWatch::look(std::shared_ptr<const model::Mesh> mesh, std::shared_ptr<const MeshScene> scene,
                      const Profile& profile, cam::JobOptions options) {
    forget();
    mesh_ = mesh;
    middle_ = slice::placed(options.up, scene->middle);
    up_ = options.up;
    base_mm_ = profile.job.base_height_mm;
    core_mm_ = profile.core_radius_mm;
    goes_on_ = std::make_shared<std::atomic<bool>>(true);
    options.search_progress = [goes_on = goes_on_](double) { return goes_on->load(); };
    queue_.post([this, mesh = std::move(mesh), scene = std::move(scene), profile, options,
                 goes_on = goes_on_]() -> BackgroundQueue::Finish {
        auto reach = look_at_model(*mesh, *scene, profile, options);
        if (!reach) return {};
        auto painted = std::make_shared<const MeshScene>(painted_scene(*scene, *reach, rgb_, hidden_rgb_));
        const auto hidden_view = view_of_hidden(*scene, *reach, options.up);
        auto seen = std::make_shared<const Seen>(Seen{std::move(*reach), std::move(painted), hidden_view});
        return [this, goes_on, seen] {
            if (goes_on->load()) seen_ = seen;
        };
    });
}

void ModelWatch::poll(bool wants_findings) {
    queue_.deliver();
    if (!wants_findings || !seen_ || is_looked_into_) return;
    is_looked_into_ = true;
    const ReachReport& reach = seen_->reach;
    const piece::PlacedModel model{mesh_,
                                   {up_, middle_[0] + reach.axis[0], middle_[1] + reach.axis[1]},
                                   reach.mm_per_unit,
                                   base_mm_,
                                   core_mm_};
    queue_.post([this, model, goes_on = goes_on_]() -> BackgroundQueue::Finish {
        auto found = report::find_in_model(model, {1, [&goes_on](double) { return goes_on->load(); }});
        if (!found) return {};
        auto findings = std::make_shared<const report::ModelFindings>(std::move(*found));
        return [this, goes_on, findings] {
            if (goes_on->load()) findings_ = findings;
        };
    });
}

}  // namespace psicarve::session
