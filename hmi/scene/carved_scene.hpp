// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hmi/scene/carving_record.hpp"
#include "hmi/scene/mesh_scene.hpp"

namespace psicarve::session {

/// Vertices first .. first + count - 1.
struct VertexRange {
    std::size_t first = 0;
    std::size_t count = 0;
    bool operator==(const VertexRange&) const = default;
};

/// Ranges of rows of `round` vertices each, in rising order.
std::vector<VertexRange> ranges_of_rows(const std::vector<std::uint32_t>& rows, std::size_t round);

/// The meaning of the colours of carved cells.
enum class Colouring : std::uint8_t { done, radius, deviation };

struct CarvedScenePlan {
    std::size_t most_round = 480;  ///< cells; a larger job is drawn with some of its cells
    std::size_t most_up = 400;
    std::size_t coarse_step = 4;  ///< one of this many cells is in the coarse facets
    std::uint32_t done_rgb = 0;
    std::uint32_t blank_rgb = 0;
    Colouring colouring = Colouring::done;
    double least_mm = 0.0;  ///< radius: the scale's ends
    double most_mm = 1.0;
    std::int32_t neutral_pulses = 1;  ///< deviation: shown as done up to here; requires neutral < reach
    std::int32_t reach_pulses = 8;    ///< the scale's end on either side
    std::uint32_t doubt_rgb = 0;      ///< what is carved, but can be wrong, whatever the colouring
};

/// The piece on the table, as a scene that follows the carving: only rows that have changed are made anew.
class PieceOnTable {
public:
    virtual ~PieceOnTable() = default;
    PieceOnTable() = default;
    PieceOnTable(const PieceOnTable&) = delete;
    PieceOnTable& operator=(const PieceOnTable&) = delete;

    virtual std::shared_ptr<const MeshScene> scene() const noexcept = 0;
    /// Height of the scene's middle, which is on the axis.
    virtual double middle_mm() const noexcept = 0;
    /// Requires the record it was made with. Returns the ranges of changed vertices.
    virtual std::vector<VertexRange> update(CarvingRecord& record) = 0;
};

/// For a point tool: the record's own layers and directions, and the blank where nothing is carved.
class CarvedScene : public PieceOnTable {
public:
    CarvedScene(const CarvingRecord& record, const CarvedScenePlan& plan);

    std::shared_ptr<const MeshScene> scene() const noexcept override { return scene_; }
    double middle_mm() const noexcept override { return middle_mm_; }
    std::vector<VertexRange> update(CarvingRecord& record) override;

private:
    std::uint32_t colour_of(const CarvingRecord& record, std::uint32_t layer,
                            std::uint32_t cell) const noexcept;
    /// Whether any of the layers is that a row stands for.
    bool is_in_doubt(const CarvingRecord& record, std::size_t row) const noexcept;
    void fill_row(const CarvingRecord& record, std::size_t row);
    std::uint32_t layer_of(std::size_t row) const noexcept;

    CarvedScenePlan plan_;
    std::size_t round_;
    std::size_t up_;
    std::uint32_t layer_count_;
    double middle_mm_;
    std::uint64_t doubt_edition_ = 0;          ///< of the record, that the scene shows
    std::vector<std::uint32_t> row_of_layer_;  ///< or kNoRow
    std::vector<std::array<float, 2>> directions_;
    std::shared_ptr<MeshScene> scene_;
};

}  // namespace psicarve::session
