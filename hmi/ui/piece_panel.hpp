// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <functional>
#include <memory>

#include "hmi/session/piece_preview.hpp"
#include "hmi/ui/tokens.hpp"

class QLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace psicarve::ui {

class MeshView;

/// Whether a view shows the model or the piece that is to be expected, the piece itself, and what is to be
/// told of it.
class PiecePanel : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PiecePanel)
public:
    /// `shows_model` is called when the view is the model's again.
    PiecePanel(MeshView& view, std::function<void()> shows_model, QWidget* parent = nullptr);

    /// Model and Expected piece.
    void add_buttons(QLayout& row);
    /// The view is the piece's.
    bool is_chosen() const;
    void choose_model();
    /// At screen rate. `is_asked_for`: by another panel, too.
    void refresh(const session::PieceChoice& choice, const std::optional<session::PieceRequest>& request,
                 bool is_asked_for);
    const session::PiecePreview& desk() const noexcept { return desk_; }

private:
    void choose();
    void show_piece();
    void say();
    session::PieceScenePlan plan() const;

    MeshView& view_;
    std::function<void()> shows_model_;
    session::PiecePreview desk_;
    std::shared_ptr<const session::PieceView> shown_;
    bool is_view_ours_ = false;
    QPushButton* model_;
    QPushButton* piece_;
    QLabel* facts_;
    QProgressBar* progress_;
    QPushButton* cancel_;
};

}  // namespace psicarve::ui
