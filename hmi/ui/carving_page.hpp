// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QWidget>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "hmi/scene/carved_scene.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QButtonGroup;
class QLayout;
class QLabel;
class QResizeEvent;

namespace psicarve::ui {

class AxisTable;

/// The blank as it is being carved, and both heads: from what the core reports, not from what was asked of
/// it. Its members: widgets, and what was drawn last, so that it draws only what has changed.
class CarvingPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::CarvingPage)
public:
    explicit CarvingPage(WindowContext& context, Drawing drawing, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    /// The record is kept whether or not the page is shown.
    void refresh();
    const session::CarvingWatch& watch() const noexcept { return context_.carving; }
    MeshView& view() noexcept { return *view_; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void add_colourings(QLayout& row);
    void colour_by(session::Colouring colouring);
    session::CarvedScenePlan plan() const;
    void show_scale();
    void take_range();
    /// The machine's, or a recording's.
    session::CarvingRecord* shown_record() const noexcept;
    piece::PieceFront* shown_piece() const noexcept;
    std::uint64_t shown_edition() const noexcept;
    void make_scene(const session::CarvingRecord& record);
    void draw();
    void draw_heads(const session::CarvingRecord& record);
    void note_known_heads();
    std::optional<MeshView::Head::Alarm> alarm_at(std::size_t head, const session::MachinePose& pose) const;
    void say();
    void say_doubt();
    /// Of a picture that is not as far as the machine.
    static QString behind_text(const session::LivePiece& piece);

    WindowContext& context_;
    const Tokens* tokens_ = nullptr;
    std::uint64_t blank_edition_ = 0;  ///< of the watch, that scene_ may be of
    std::unique_ptr<session::PieceOnTable> scene_;
    std::array<std::shared_ptr<const session::MeshScene>, verify::kHeadCount> rods_;
    Drawing scene_drawing_ = Drawing::painter;  ///< that scene_ was made for
    std::uint64_t drawn_edition_ = 0;
    verify::Positions drawn_positions_{};
    std::vector<Axis> drawn_alarm_;
    std::array<bool, verify::kHeadCount> is_head_known_{};  ///< where it stands, or stood before the alarm
    std::uint64_t shown_replay_ = 0;
    const session::CarvingRecord* drawn_record_ = nullptr;  ///< only compared
    const session::CarvingRecord* is_seen_ = nullptr;       ///< whose scene the view has; only compared
    QElapsedTimer drawn_;
    MeshView* view_;
    AxisTable* axes_;
    QButtonGroup* colourings_;
    session::Colouring colouring_ = session::Colouring::done;
    std::shared_ptr<const cam::PreparedJob> ranged_job_;  ///< whose radii these are
    double least_mm_ = 0.0;
    double most_mm_ = 1.0;
    QLabel* done_;
    QLabel* blank_;
    QLabel* doubt_;
    QLabel* behind_;
    QLabel* feed_;
    QLabel* point_;
};

}  // namespace psicarve::ui
