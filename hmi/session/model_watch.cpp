// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/model_watch.hpp"

#include <utility>

namespace psicarve::session {

void ModelWatch::forget() {
    if (goes_on_) goes_on_->store(false);
    goes_on_.reset();
    seen_.reset();
    lane_.drop_waiting();
}

void ModelWatch::look(std::shared_ptr<const model::Mesh> mesh, std::shared_ptr<const MeshScene> scene,
                      const Profile& profile, cam::JobOptions options) {
    forget();
    goes_on_ = std::make_shared<std::atomic<bool>>(true);
    options.search_progress = [goes_on = goes_on_](double) { return goes_on->load(); };
    lane_.post([this, mesh = std::move(mesh), scene = std::move(scene), profile, options,
                goes_on = goes_on_]() -> WorkLane::Finish {
        auto sight = look_at_model(*mesh, *scene, profile, options);
        if (!sight) return {};
        auto painted = std::make_shared<const MeshScene>(painted_scene(*scene, *sight, rgb_, hidden_rgb_));
        auto seen = std::make_shared<const Seen>(Seen{std::move(*sight), std::move(painted)});
        return [this, goes_on, seen] {
            if (goes_on->load()) seen_ = seen;
        };
    });
}

}  // namespace psicarve::session
