// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hmi/piece/piece_front.hpp"
#include "hmi/scene/carved_scene.hpp"

namespace psicarve::session {

/// For a tool that has a size: what it leaves of the whole blank, from the table up. Deviations are the
/// record's, where its nearest layer has one. Used by the thread that reads the front.
class StockScene : public PieceOnTable {
public:
    /// The front outlives this.
    StockScene(const CarvingRecord& record, piece::PieceFront& front, const CarvedScenePlan& plan);

    std::shared_ptr<const MeshScene> scene() const noexcept override { return scene_; }
    double middle_mm() const noexcept override { return middle_mm_; }
    std::vector<VertexRange> update(CarvingRecord& record) override;

private:
    /// Whether any of the record's layers is that lie between this row's height and the next one's, or are
    /// nearest to it.
    bool is_in_doubt(const CarvingRecord& record, std::size_t up) const noexcept;
    std::uint32_t colour_of(const CarvingRecord& record, std::size_t row, std::size_t column,
                            bool is_doubtful) const;
    void fill_row(const CarvingRecord& record, std::size_t up);
    std::size_t stock_row(std::size_t up) const noexcept;
    void note_layer(const CarvingRecord& record, std::uint32_t layer, std::vector<std::uint8_t>& has_changed);

    CarvedScenePlan plan_;
    piece::PieceFront& front_;
    std::size_t round_;
    std::size_t up_;
    double middle_mm_;
    std::uint64_t doubt_edition_ = 0;  ///< of the record, that the scene shows
    std::vector<std::array<float, 2>> directions_;
    std::shared_ptr<MeshScene> scene_;
};

}  // namespace psicarve::session
