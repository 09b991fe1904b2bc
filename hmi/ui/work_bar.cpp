// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/work_bar.hpp"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

#include "hmi/ui/field_value.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/lock_with.hpp"

namespace psicarve::ui {
namespace {

using session::DeskState;

QPushButton* bar_button(const char* name, const QString& text) {
    auto* button = new QPushButton{text};
    button->setObjectName(name);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QString offer_text(const UnfinishedWork& work) {
    const QString text = work.is_sliced ? WorkBar::tr("Take up again: %1, %2 layers × %3 points, sliced")
                                        : WorkBar::tr("Take up again: %1, %2 layers × %3 points");
    return text.arg(QFileInfo{work.path}.fileName(), work.fields.value("layers").toString(),
                    work.fields.value("points").toString());
}

/// Nothing is under way with it.
bool is_settled(DeskState state) {
    return state == DeskState::model || state == DeskState::job || state == DeskState::published;
}

}  // namespace

WorkBar::WorkBar(Bench& bench, Form form, QWidget* parent)
    : QFrame(parent),
      bench_(bench),
      form_(std::move(form)),
      keeper_(*bench.settings),
      offer_(role_label("title")),
      note_(role_label("label")),
      take_(bar_button("work_take", tr("Take up again"))) {
    setObjectName("unfinished_work");
    offer_->setObjectName("work_offer");
    note_->setObjectName("work_note");
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, kGap);
    for (QLabel* label : {offer_, note_}) {
        label->setWordWrap(true);
        all->addWidget(label);
    }
    auto* decline = bar_button("work_forget", tr("Forget it"));
    decline->setToolTip(tr("It is not offered again; the file stays"));
    connect(take_, &QPushButton::clicked, this, [this] { take_up(); });
    connect(decline, &QPushButton::clicked, this, [this] {
        keeper_.drop_left();
        show_offer();
    });
    auto* buttons = new FlowLayout;
    buttons->addWidget(take_);
    buttons->addWidget(decline);
    all->addLayout(buttons);
    setVisible(false);
}

void WorkBar::take_up() {
    if (keeper_.left() == nullptr || bench_.desk.sight().is_busy()) return;
    taking_ = *keeper_.left();
    edition_before_ = bench_.desk.edition();
    bench_.forget_refused_file();
    bench_.desk.open(taking_->work.path.toStdString());
}

void WorkBar::fill_in_taken() {
    if (!taking_ || bench_.desk.edition() == edition_before_ || bench_.desk.sight().is_busy()) return;
    const auto taken = std::exchange(taking_, std::nullopt);
    if (taken->work.path.toStdString() != bench_.desk.path()) return;
    put_into_fields(*form_.fields, taken->work.fields);
    // What another program has made of it since is to be looked at first.
    const bool is_sliced = taken->work.is_sliced && taken->file == WorkKeeper::FileState::same;
    sliced_path_ = is_sliced ? bench_.desk.path() : std::string{};
    if (keeper_.left() != nullptr && keeper_.left()->id == taken->id) keeper_.drop_left();
}

/// Turning and making another body of it go before.
void WorkBar::slice_again() {
    if (sliced_path_.empty() || bench_.desk.sight().state != DeskState::model) return;
    if (std::exchange(sliced_path_, {}) == bench_.desk.path()) form_.slice();
}

void WorkBar::keep(std::uint64_t changes, bool is_stale) {
    const session::JobDesk& desk = bench_.desk;
    const bool is_saved = desk.job() && bench_.files.saved_job() == desk.job();
    const Seen seen{desk.edition(), changes, desk.sight().state, is_saved};
    if (!is_settled(seen.state) || seen_ == seen) return;
    seen_ = seen;
    const bool is_done = !is_stale && (seen.state == DeskState::published || is_saved);
    const auto stamp = desk.stamp();
    if (!desk.mesh() || !stamp || is_done) return keeper_.forget();
    keeper_.remember({QFileInfo{QString::fromStdString(desk.path())}.absoluteFilePath(), *stamp,
                      desk.job() != nullptr && !is_stale, values_of_fields(*form_.fields)});
}

void WorkBar::show_offer() {
    const WorkKeeper::Left* const left = keeper_.left();
    if (isHidden() == (left != nullptr)) setVisible(left != nullptr);
    if (left == nullptr) return;
    const QString text = offer_text(left->work);
    if (offer_->text() != text) offer_->setText(text);
    offer_->setToolTip(left->work.path);
    const bool is_changed = left->file == WorkKeeper::FileState::changed;
    const QString note =
        is_changed
            ? tr("The file was written since: it comes as it is now, and is not sliced.")
            : tr("A window ended before it was published or saved. Nothing is published, nothing moves.");
    if (note_->text() != note) note_->setText(note);
    const QString why_not = left->file == WorkKeeper::FileState::gone ? tr("The file is not there any more")
                            : bench_.desk.sight().is_busy() ? tr("A job is being made; cancel it first")
                                                            : QString{};
    lock_with(*take_, why_not, tr("Opens the model with the form it had"));
    if (left->file == WorkKeeper::FileState::gone) note_->setText(why_not);
    if (told_ == left->id) return;
    told_ = left->id;
    bench_.log.add(session::Severity::info,
                   session::phrase("Not published when a window ended: %1 (page Model)",
                                   QFileInfo{left->work.path}.fileName().toStdString()));
}

void WorkBar::refresh(std::uint64_t changes, bool is_stale) {
    keeper_.poll();
    if (taking_ && bench_.refused_file() != nullptr) taking_.reset();
    fill_in_taken();
    keep(changes, is_stale);
    slice_again();
    show_offer();
}

}  // namespace psicarve::ui
