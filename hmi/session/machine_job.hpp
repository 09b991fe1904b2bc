// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/model/mesh.hpp"

namespace psicarve::session {

/// The job in the machine, whatever is open in the window: the one published last, and whether the core has
/// accepted it. Generations are those of the segment; 0: none.
class MachineJob {
public:
    /// A job that this window has published, and what it was made of.
    void take_published(std::uint64_t generation, std::shared_ptr<const cam::PreparedJob> job,
                        std::shared_ptr<const model::Mesh> mesh, std::string path) {
        take_fetched(generation, std::move(job));
        fetched_ = generation;
        mesh_ = std::move(mesh);
        path_ = std::move(path);
    }
    /// A job that was read in the segment: what it was made of is not known.
    void take_fetched(std::uint64_t generation, std::shared_ptr<const cam::PreparedJob> job) {
        generation_ = generation;
        job_ = std::move(job);
        mesh_.reset();
        path_.clear();
    }
    void note_accepted(std::uint64_t generation) noexcept { accepted_ = generation; }
    /// Whether the job of that generation is to be read in the segment: each is asked for once.
    bool is_to_be_fetched(std::uint64_t generation) const noexcept {
        return generation != 0 && generation != fetched_;
    }
    void note_fetch(std::uint64_t generation) noexcept { fetched_ = generation; }

    /// The job that the core accepted last; null while it is not known.
    std::shared_ptr<const cam::PreparedJob> accepted() const noexcept {
        return accepted_ == generation_ ? job_ : nullptr;
    }
    std::uint64_t generation() const noexcept { return generation_; }
    /// The mesh that it was sliced from in this window; else null.
    const std::shared_ptr<const model::Mesh>& mesh() const noexcept { return mesh_; }
    /// The file that it was made of in this window; else empty.
    const std::string& path() const noexcept { return path_; }

private:
    std::shared_ptr<const cam::PreparedJob> job_;
    std::shared_ptr<const model::Mesh> mesh_;
    std::string path_;
    std::uint64_t generation_ = 0;
    std::uint64_t accepted_ = 0;
    std::uint64_t fetched_ = 0;
};

}  // namespace psicarve::session
