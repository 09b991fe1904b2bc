// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/piece_panel.hpp"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

#include "hmi/scene/colour_map.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/checked_width.hpp"
#include "hmi/ui/colour_bar.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kPieceSteps = 1000;

QPushButton* choice_button(const QString& name, const char* id) {
    auto* button = new QPushButton{name};
    button->setProperty("small", true);
    button->setObjectName(id);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    leave_room_for_bold(*button);
    return button;
}

QString number_of(double value, int decimals) {
    return QString::fromStdString(session::number_text(value, decimals));
}

/// Of what the colours say.
QString legend_of(const session::PieceView& piece_view) {
    if (!piece_view.has_model) {
        return QStringLiteral("%1 %2 %3")
            .arg(number_of(piece_view.least_mm, 0), colour_bar(session::viridis),
                 PiecePanel::tr("%1 mm").arg(number_of(piece_view.most_mm, 0)));
    }
    const auto colour = [&piece_view](double ratio) {
        const bool is_neutral = std::abs(2.0 * ratio - 1.0) * piece_view.reach_mm <= piece_view.pulse_mm;
        return is_neutral ? kDoneColour : session::vik(ratio);
    };
    return PiecePanel::tr("too deep %1 material left<br>±%2 mm, ±%3 pulses")
        .arg(colour_bar(colour), number_of(piece_view.reach_mm, 3),
             number_of(piece_view.reach_mm / piece_view.pulse_mm, 0));
}

}  // namespace

PiecePanel::PiecePanel(MeshView& view, std::function<void()> shows_model, QWidget* parent)
    : QWidget(parent),
      view_(view),
      shows_model_(std::move(shows_model)),
      model_(choice_button(tr("Model"), "view_model")),
      piece_(choice_button(tr("Expected piece"), "view_piece")),
      facts_(role_label("label")),
      progress_(new QProgressBar),
      cancel_(new QPushButton{tr("Cancel")}) {
    auto* group = new QButtonGroup{this};
    group->setObjectName("model_or_piece");
    group->addButton(model_);
    group->addButton(piece_);
    model_->setChecked(true);
    connect(group, &QButtonGroup::buttonClicked, this, [this] { choose(); });
    facts_->setObjectName("piece_facts");
    facts_->setWordWrap(true);
    facts_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    progress_->setObjectName("piece_progress");
    progress_->setRange(0, kPieceSteps);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Working the expected piece out"));
    cancel_->setObjectName("piece_cancel");
    cancel_->setProperty("small", true);
    cancel_->setFocusPolicy(Qt::TabFocus);
    connect(cancel_, &QPushButton::clicked, this, [this] { desk_.cancel(); });
    auto* under_way = new QHBoxLayout;
    under_way->addWidget(progress_, 1);
    under_way->addWidget(cancel_);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(kSmallGap);
    all->addLayout(under_way);
    all->addWidget(facts_);
    hide();
}

void PiecePanel::add_buttons(QLayout& row) {
    row.addWidget(model_);
    row.addWidget(piece_);
}

bool PiecePanel::is_chosen() const {
    return piece_->isChecked();
}

void PiecePanel::choose_model() {
    if (!is_chosen()) return;
    model_->setChecked(true);
    choose();
}

void PiecePanel::choose() {
    setVisible(is_chosen());
    if (is_chosen() || !is_view_ours_) return;
    is_view_ours_ = false;
    shown_.reset();
    view_.show_file_axes(true);
    view_.set_legend({});
    shows_model_();
}

session::PieceScenePlan PiecePanel::plan() const {
    session::PieceScenePlan plan;
    if (view_.drawing() != Drawing::opengl) {
        plan.most_round = 240;
        plan.most_up = 200;
    }
    plan.neutral_rgb = kDoneColour;
    plan.blank_rgb = kBlankColour;
    return plan;
}

void PiecePanel::refresh(const session::PieceChoice& choice,
                         const std::optional<session::PieceRequest>& request, bool is_asked_for) {
    const bool can_be = choice.source != session::PieceSource::none;
    piece_->setEnabled(can_be);
    piece_->setToolTip(!can_be ? words(session::joined(session::phrase("Expected piece"), choice.reason))
                       : choice.source == session::PieceSource::job
                           ? tr("What the job and its tool will leave, and how far it is from the model")
                           : tr("A draft of what the tool will leave, before the model is sliced"));
    piece_->setAccessibleDescription(piece_->toolTip());
    if (!can_be) choose_model();
    desk_.poll(can_be ? request : std::nullopt, plan(), is_chosen() || is_asked_for);
    if (!is_chosen()) return;
    show_piece();
    say();
}

void PiecePanel::show_piece() {
    const auto piece_view = desk_.view();
    if (is_view_ours_ && piece_view == shown_) return;
    if (!is_view_ours_) {
        is_view_ours_ = true;
        view_.set_blank({});
        view_.show_file_axes(false);
        view_.set_up(slice::Up::z);
    }
    shown_ = piece_view;
    view_.set_legend(piece_view ? legend_of(*piece_view) : QString{});
    view_.replace_scene(piece_view ? piece_view->scene : nullptr);
}

void PiecePanel::say() {
    const bool is_working = desk_.is_working();
    progress_->setVisible(is_working);
    cancel_->setVisible(is_working);
    progress_->setValue(static_cast<int>(kPieceSteps * desk_.progress_ratio()));
    if (is_working)
        return facts_->setText(
            tr("Working the piece out: %1 %").arg(static_cast<int>(100.0 * desk_.progress_ratio())));
    if (!shown_) return facts_->setText(words(desk_.problem()));
    QStringList lines;
    for (const session::Phrase& line : session::piece_lines(*shown_)) lines += words(line);
    facts_->setText(lines.join('\n'));
}

}  // namespace psicarve::ui
